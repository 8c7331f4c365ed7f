// `ocelli viewers`: what each of several viewers around a display misses who share one mesh.
#include <CLI/CLI.hpp>

#include "cli/command.h"
#include "cli/output_option.h"
#include "cli/scene_options.h"
#include "cli/values.h"
#include "cli/viewers_option.h"
#include "oc_core/base/error.h"
#include "oc_core/evaluation/viewers_evaluation.h"

namespace ocelli {
namespace {

struct ViewersCommandChoice {
  SceneChoice scene;
  std::string camera = "ddoc";
  ViewersChoice viewers;
  std::string cell = "8in";
  std::string size = "720x480";
  int interiorViews = 12;
  unsigned seed = 1;
  std::string json;
};

void run(const ViewersCommandChoice& choice, const CommandContext& context) {
  EvaluationOptions options;
  const ImageSize size = imageSizeFromText(choice.size, "--size");
  options.width = size.width;
  options.height = size.height;
  options.cell.sideRadii = cellSideFromText(choice.cell, "--cell");
  options.interiorViews = choice.interiorViews;
  options.seed = choice.seed;
  const CameraChoice camera = cameraChoice(choice.camera, options.cell);
  if (!camera.hasImages()) {
    throw InputError("\"" + camera.name + "\" is a mesh, the same for every viewer", "--camera",
                     "choose a camera that has a reference image");
  }
  const std::vector<View> views = viewsFor(choice.camera, choice.viewers);
  checkFiguresOutput(choice.json);
  const Mesh scene = loadScene(choice.scene.source, choice.scene.options, context.progress());
  const ViewersFigures figures = evaluateViewers(scene, camera, views, options, context.progress());
  giveFigures(choice.json, viewersJson(choice.scene.source, options, figures), viewersTable(figures), context);
}

}  // namespace

void addViewersCommand(CLI::App& program, const CommandContext& context) {
  CLI::App& command = *program.add_subcommand(
      "viewers", "Measure one mesh for several viewers around the display: what each of them misses");
  const auto choice = std::make_shared<ViewersCommandChoice>();
  addSceneOptions(command, choice->scene, context);
  addCameraOption(command, choice->camera);
  addViewersOptions(command, choice->viewers);
  command.add_option("--cell", choice->cell, "Side of the cube around each viewer, in inches at the reference display")
      ->type_name("SIDE");
  addSizeOption(command, choice->size);
  command.add_option("--interior", choice->interiorViews, "How many viewpoints inside of each cell")
      ->check(CLI::Range(0, 10000))
      ->type_name("N");
  command.add_option("--seed", choice->seed, "Of the viewpoints inside")->type_name("S");
  addFiguresOption(command, choice->json);
  context.finish(command,
                 "  ocelli viewers builtin:statues --viewers 4\n"
                 "  ocelli viewers bunny.obj --camera eoc-hv --view left.json --view right.json --json two.json",
                 [choice, context] { run(*choice, context); });
}

}  // namespace ocelli
