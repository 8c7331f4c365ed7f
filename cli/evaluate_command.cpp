#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "cli/command.h"
#include "cli/scene_options.h"
#include "cli/values.h"
#include "display_sim/display_profile.h"
#include "display_sim/slicer.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/base/output_file.h"
#include "oc_core/evaluation/evaluation_json.h"
#include "oc_core/evaluation/evaluation_table.h"

namespace ocelli {
namespace {

struct EvaluateChoice {
  SceneChoice scene;
  std::vector<std::string> cameras{"di", "ddoc"};
  std::string cell = "8in";
  std::string view;
  std::string size = "720x480";
  std::string profile = "perspecta";
  int interiorViews = 12;
  unsigned seed = 1;
  std::string json;
};

void runEvaluate(const EvaluateChoice& choice, const Frame& frame) {
  const bool toFile = !choice.json.empty() && choice.json != "-";
  if (toFile) {
    checkWritable(choice.json);
  }
  EvaluationOptions options;
  options.view = readViewOption(choice.view);
  const ImageSize size = imageSizeFromText(choice.size, "--size");
  options.width = size.width;
  options.height = size.height;
  options.cell.sideRadii = cellSideFromText(choice.cell, "--cell");
  options.interiorViews = choice.interiorViews;
  options.seed = choice.seed;
  std::vector<CameraChoice> cameras;
  for (const std::string& name : choice.cameras) {
    cameras.push_back(cameraChoice(name, options.cell.sideRadii));
  }
  const DisplayProfile profile = loadProfile(choice.profile);
  options.slice = [&profile](const Mesh& mesh) { slice(mesh, profile); };

  const Mesh mesh = loadScene(choice.scene.source, choice.scene.options, frame.progress());
  const std::vector<RepresentationFigures> figures = evaluate(mesh, cameras, options, frame.progress());
  const std::string json = evaluationJson(choice.scene.source, options, figures);
  if (choice.json == "-") {
    frame.print(json);
    return;
  }
  frame.print(evaluationTable(figures));
  if (toFile) {
    writeFile(choice.json, json);
  }
}

}  // namespace

void addEvaluateCommand(CLI::App& program, const Frame& frame) {
  CLI::App& command = *program.add_subcommand(
      "evaluate", "Measure what reference images lack over a cell of viewpoints, and their cost");
  const auto choice = std::make_shared<EvaluateChoice>();
  addSceneOptions(command, choice->scene);
  command.add_option("--cameras", choice->cameras, "Cameras to compare: names or JSON files")
      ->delimiter(',')
      ->type_name("NAME,...");
  command.add_option("--cell", choice->cell, "Side of the cube of viewpoints, in inches at the reference display")
      ->type_name("SIDE");
  addViewOption(command, choice->view);
  addSizeOption(command, choice->size);
  command.add_option("--profile", choice->profile, "Display whose slicing is timed")->type_name("NAME|FILE.json");
  command.add_option("--interior", choice->interiorViews, "How many viewpoints inside of the cell")
      ->check(CLI::Range(0, 10000))
      ->type_name("N");
  command.add_option("--seed", choice->seed, "Of the viewpoints inside")->type_name("S");
  command.add_option("--json", choice->json, "Also write the figures here; alone or as - they go to standard output")
      ->expected(0, 1)
      ->default_str("-")
      ->type_name("FILE");
  frame.finish(command,
               "  ocelli evaluate builtin:statues\n"
               "  ocelli evaluate bunny.obj --cameras di,ddoc,ddoc-constant --cell 4in --json bunny.json",
               [choice, frame] { runEvaluate(*choice, frame); });
}

}  // namespace ocelli
