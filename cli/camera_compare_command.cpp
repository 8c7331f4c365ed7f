// `ocelli camera compare`: general pinhole, fisheye and inset side by side on a page.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "cli/camera_compare.h"
#include "cli/command.h"
#include "cli/output_option.h"
#include "cli/scene_options.h"
#include "cli/values.h"
#include "cli/viewed_scene.h"
#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/base/output_file.h"
#include "oc_core/focus/focus_page.h"
#include "oc_core/ocri/nothing_seen.h"
#include "oc_core/ocri/representation_kind.h"
#include "oc_core/render/rasterize.h"
#include "oc_core/scene/winding_number.h"

namespace ocelli {
namespace {

struct FocusChoice {
  SceneChoice scene;
  std::string camera = "gpc";
  std::string view;
  std::string size = "1280x720";
  int runs = 3;
  std::string folder;
  std::string json;
};

std::string focusJson(const FocusComparison& comparison) {
  nlohmann::ordered_json ways = nlohmann::ordered_json::array();
  for (const FocusResult& result : comparison.results) {
    nlohmann::ordered_json row{{"way", result.way->name}};
    for (const FocusColumn& column : focusColumns()) {
      const std::optional<double> value = column.value(result);
      row[column.key] = value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json(nullptr);
    }
    ways.push_back(row);
  }
  return textOfJson({{"width", comparison.size.x}, {"height", comparison.size.y}, {"ways", ways}}, 1) + "\n";
}

void writeImages(const std::filesystem::path& folder, const FocusComparison& comparison) {
  for (const FocusResult& result : comparison.results) {
    const FocusImages names = focusImageNames(*result.way);
    writePng(folder / names.picture, result.picture);
    writePng(folder / names.rates, result.rates);
    writePng(folder / names.kept, result.kept);
  }
}

void compare(const FocusChoice& choice, const CommandContext& context) {
  const std::filesystem::path folder = choice.folder;
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    throw WorkError("cannot make this folder (" + error.message() + ")", choice.folder, "choose another one with -o");
  }
  checkWritable(folder / "index.html");
  const CameraChoice camera = cameraChoice(choice.camera);
  if (!camera.kind->layout) {
    throw InputError("camera \"" + camera.name + "\" has no regions of detail", "--camera " + choice.camera,
                     "use gpc, or a file of one");
  }
  const GpcLayout layout = camera.kind->layout(camera);
  requireFoci(layout, "--camera " + choice.camera);
  const ImageSize size = imageSizeFromText(choice.size, "--size");
  const PinholeCamera plain(readViewOption(choice.view), size.width, size.height);
  ViewedScene scene(choice.scene, context);
  const Mesh& mesh = scene.meshFor(camera, plain);
  requireOutside(mesh, plain.eye(), "view");
  const FragmentImage seen = rasterize(plain, mesh);
  if (std::none_of(seen.begin(), seen.end(), [](const Fragment& each) { return each.covered(); })) {
    failSeeingNothing(plain, mesh, "view");
  }
  const FocusComparison comparison =
      compareFocusWays(focusWays(), layout, plain, mesh, {.runs = choice.runs}, context.progress());
  giveFigures(choice.json, focusJson(comparison), focusTable(comparison), context);
  writeImages(folder, comparison);
  writeFile(folder / "index.html",
            focusPage({choice.scene.source, choice.camera, OCELLI_VERSION, choice.runs}, comparison, layout));
  context.note("wrote " + (folder / "index.html").string());
}

}  // namespace

void addCameraCompare(CLI::App& camera, const CommandContext& context) {
  CLI::App& command = *camera.add_subcommand(
      "compare", "Show the same foci by gpc, by a fisheye and by an inset magnifier, side by side on a page");
  const auto choice = std::make_shared<FocusChoice>();
  addSceneOptions(command, choice->scene, context);
  addCameraOption(command, choice->camera);
  addViewOption(command, choice->view);
  addSizeOption(command, choice->size);
  command.add_option("--runs", choice->runs, "How often each picture is drawn; the fastest counts")
      ->check(CLI::Range(1, 100))
      ->capture_default_str();
  command.add_option("-o,--output", choice->folder, "Folder for the page and its images")->type_name("DIR")->required();
  addFiguresOption(command, choice->json);
  context.finish(command,
                 "  ocelli camera compare builtin:dna --camera two_lenses.json --view V.json -o focus\n"
                 "  ocelli camera compare builtin:statues --camera gpc -o focus --json focus.json",
                 [choice, context] { compare(*choice, context); });
}

}  // namespace ocelli
