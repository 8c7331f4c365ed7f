// `ocelli scene walk`: where one can walk in a scene, as figures, a file and a plan.
#include "cli/scene_walk_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <vector>

#include "cli/number_check.h"
#include "cli/output_option.h"
#include "cli/scene_options.h"
#include "oc_core/base/json_document.h"
#include "oc_core/base/output_file.h"
#include "oc_core/multiperspective/figure_file.h"
#include "oc_core/multiperspective/walk_plan.h"
#include "oc_core/walkable/walk_map_file.h"
#include "oc_core/walkable/walkable.h"

namespace ocelli {
namespace {

struct WalkChoice {
  SceneChoice scene;
  WalkOptions metres;  ///< as the user gives them
  std::optional<double> metre;
  std::optional<double> floor;
  std::vector<std::string> outputs;
  bool asJson = false;
};

size_t tunnelsIn(const WalkMap& map) {
  return static_cast<size_t>(std::count_if(map.cells.begin(), map.cells.end(),
                                           [](const WalkCell& cell) { return cell.kind == WalkCellKind::kTunnel; }));
}

size_t jointsIn(const WalkMap& map) {
  return map.portals.size() - map.openingCount();
}

std::string surveyAsText(const std::string& source, const WalkSurvey& survey, const SceneMetre& metre) {
  const WalkMap& map = survey.map;
  const double square = metre.units * metre.units;
  std::string text = fmt::format(
      "{}\n  rooms      {}, streets and crossings among them\n  cells      {}, {} of them tunnels\n"
      "  openings   {}, and {} joints within rooms\n  parts      {}{}\n",
      source, map.roomCount(), map.cells.size(), tunnelsIn(map), map.openingCount(), jointsIn(map), map.partCount(),
      map.partCount() > 1 ? ": one cannot walk from each to each" : "");
  text += fmt::format("  floor      {:.1f} m2\n", survey.floorArea / square);
  text += fmt::format("  left out   {:.1f} m2 too narrow, {:.1f} m2 in {} smaller parts out of reach\n",
                      survey.tooNarrowArea / square, survey.smallPartsArea / square, survey.smallParts);
  text += fmt::format("  grid       {:.3g} m, turned by {:.2f} degrees\n  a metre    {:.6g} units{}\n",
                      survey.cellSize / metre.units, survey.directionDegrees, metre.units,
                      metre.isKnown ? "" : ", as a guess from the size of the scene: --metre says it");
  return text;
}

std::string surveyAsJson(const std::string& source, const WalkSurvey& survey, const SceneMetre& metre) {
  const WalkMap& map = survey.map;
  const double square = metre.units * metre.units;
  return textOfJson({{"scene", source},
                     {"rooms", map.roomCount()},
                     {"cells", map.cells.size()},
                     {"tunnels", tunnelsIn(map)},
                     {"openings", map.openingCount()},
                     {"joints", jointsIn(map)},
                     {"parts", map.partCount()},
                     {"floor_m2", survey.floorArea / square},
                     {"too_narrow_m2", survey.tooNarrowArea / square},
                     {"out_of_reach_m2", survey.smallPartsArea / square},
                     {"out_of_reach_parts", survey.smallParts},
                     {"cell_size_m", survey.cellSize / metre.units},
                     {"turned_by_degrees", survey.directionDegrees},
                     {"units_per_metre", metre.units},
                     {"metre_is_known", metre.isKnown},
                     {"notes", survey.notes}},
                    2) +
         "\n";
}

void writeWalk(const std::string& path, const WalkChoice& choice, const WalkSurvey& survey, const Mesh& mesh,
               double metre) {
  if (path.ends_with(".json")) {
    OutputFile file(path);
    file.write(jsonText(survey.map));
    file.commit();
    return;
  }
  WalkPlanOptions options;
  options.title = choice.scene.source;
  options.metre = static_cast<float>(metre);
  if (choice.floor) {
    options.floor = static_cast<float>(*choice.floor);
  }
  writeFigure(path, walkPlanFigure(survey.map, mesh, options));
}

void runSceneWalk(const WalkChoice& choice, const CommandContext& context) {
  for (const std::string& path : choice.outputs) {
    checkWritable(path);
  }
  SceneOptions options = choice.scene.options;
  options.fit = false;  // maps are in the units of the file
  const GuidedScene scene = loadGuidedScene(choice.scene.source, options, context.progress());
  const SceneMetre metre = choice.metre ? SceneMetre{*choice.metre, true} : metreOf(choice.scene.source, scene);
  const WalkSurvey survey = surveyWalkable(scene.mesh, inUnits(choice.metres, metre.units), context.progress());
  for (const std::string& note : survey.notes) {
    context.note("note: " + note);
  }
  for (const std::string& path : choice.outputs) {
    writeWalk(path, choice, survey, scene.mesh, metre.units);
    context.note("wrote " + path);
  }
  context.print(choice.asJson ? surveyAsJson(choice.scene.source, survey, metre)
                              : surveyAsText(choice.scene.source, survey, metre));
}

std::string optionName(const WalkOption& option) {
  std::string name = std::string("--") + option.name;
  std::replace(name.begin(), name.end(), '_', '-');
  return name;
}

}  // namespace

void addSceneWalk(CLI::App& parent, const CommandContext& context) {
  CLI::App& command = *parent.add_subcommand(
      "walk", "Find where one can walk: rooms, tunnels between them and the openings, from the geometry alone");
  const auto choice = std::make_shared<WalkChoice>();
  addSceneOptions(command, choice->scene, context);
  addMotionOptions(command, choice->scene);
  for (const WalkOption& option : walkOptionTable()) {
    command
        .add_option(optionName(option), choice->metres.*option.value,
                    option.meaning + std::string(option.isLength ? ", metres" : ""))
        ->check(numberCheck(option.min, option.max));
  }
  addMetreOption(command, choice->metre);
  command.add_option("--floor", choice->floor, "Of the plan: the floor that is shown, y in units of the scene")
      ->check(numberCheck(-1e6, 1e6))
      ->type_name("Y");
  addOutputFilesOption(command, choice->outputs,
                       "The map to correct and to give back (.json), or a plan of it (.svg, .png); may be repeated",
                       {".json", ".svg", ".png"});
  command.add_flag("--json", choice->asJson, "Print the figures as JSON");
  context.finish(command,
                 "  ocelli scene walk builtin:house\n"
                 "  ocelli scene walk builtin:city -o city.json -o city.svg\n"
                 "  ocelli scene walk office.glb --metre 100 --agent-radius 0.4 -o office.png",
                 [choice, context] { runSceneWalk(*choice, context); });
}

}  // namespace ocelli
