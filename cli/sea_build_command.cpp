// `ocelli sea build`: images with known positions become a sea.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "cli/number_check.h"
#include "cli/output_option.h"
#include "cli/scene_options.h"
#include "cli/sea_command.h"
#include "oc_core/base/json_document.h"
#include "oc_core/sea/pose_refinement.h"
#include "oc_core/sea/sea_build.h"
#include "oc_core/sea_input/hidden_points.h"
#include "oc_core/sea_input/sea_input.h"

namespace ocelli {
namespace {

using Json = nlohmann::ordered_json;

struct SeaBuildChoice {
  SceneChoice scene;
  SeaInputOptions input;
  SeaSettings settings;
  std::string size = "1024x1024";
  std::string way = "direct";
  std::string output;
  std::string json;
  bool startOver = false;
};

void runBuild(SeaBuildChoice& choice, const CommandContext& context) {
  const ImageSize size = imageSizeFromText(choice.size, "--size");
  choice.input.size = {size.width, size.height};
  for (const SeaWay way : allSeaWays()) {
    if (nameOf(way) == choice.way) {
      choice.settings.way = way;
    }
  }
  checkFiguresOutput(choice.json, choice.output);
  const SeaInput input = openSeaInput(choice.scene.source, choice.scene.options, choice.input, context.progress());
  if (choice.settings.refinement.empty()) {
    choice.settings.refinement = input.arePosesExact ? "none" : "bobyqa";
  }
  choice.settings.source = input.source->description();
  choice.settings.projection = input.source->projection();
  validate(choice.settings, "the options");
  const SeaBuildReport built = buildSea(*input.source, input.proxy, choice.settings, choice.output, choice.startOver,
                                        context.progress(), hiddenPointsOf(choice.settings));
  context.clearProgress();
  const double ratio = static_cast<double>(built.rawBytes) / static_cast<double>(built.fileBytes);
  const size_t made = built.images - built.resumed;
  const Json figures{{"images", built.images},   {"i_nodes", built.inner},
                     {"resumed", built.resumed}, {"proxy_triangles", input.proxy.triangles.size()},
                     {"bytes", built.fileBytes}, {"raw_bytes", built.rawBytes},
                     {"ratio", ratio},           {"seconds", built.seconds}};
  const std::string table = fmt::format(
      "{}\n  images       {}, of which {} are I-nodes\n  proxy        {} triangles\n  size         {:.1f} MB, {:.0f} : "
      "1\n"
      "  built        {} images in {:.1f} s, {:.2f} s each\n",
      choice.output, built.images, built.inner, input.proxy.triangles.size(),
      static_cast<double>(built.fileBytes) / 1e6, ratio, made, built.seconds,
      made > 0 ? built.seconds / static_cast<double>(made) : 0.0);
  giveFigures(choice.json, textOfJson(figures, 2) + "\n", table, context);
}

}  // namespace

void addSeaBuildCommand(CLI::App& sea, const CommandContext& context) {
  CLI::App& command = *sea.add_subcommand("build", "Make a sea of images from photographs with poses, or from a scene");
  const auto choice = std::make_shared<SeaBuildChoice>();
  addSceneOptions(command, choice->scene, context);
  SeaInputOptions& input = choice->input;
  command.add_option("--positions", input.positions, "Of a scene: a table with columns x, y, z, and yaw if they turn")
      ->type_name("FILE.csv");
  command
      .add_option("--spacing", input.spacing,
                  "Of a scene: how far images along its path are apart; as it says itself by default")
      ->check(numberCheck(1e-6, 1e6))
      ->type_name("METRES");
  command
      .add_option("--grid", input.grid, "Of a scene: images on a level grid instead, from X0,Z0 to X1,Z1, so far apart")
      ->type_name("X0,Z0,X1,Z1,SPACING");
  command.add_option("--eye-height", input.eyeHeight, "Of a grid")
      ->check(numberCheck(-1e6, 1e6))
      ->capture_default_str()
      ->type_name("METRES");
  command.add_option("--first", input.first, "Leave out so many images before")->capture_default_str()->type_name("N");
  command.add_option("--count", input.count, "At most so many images; 0: all")->capture_default_str()->type_name("N");
  command.add_option("--size", choice->size, "Of a scene: of the panoramas")
      ->capture_default_str()
      ->type_name("WIDTHxHEIGHT");
  command.add_option("--samples", input.samples, "Of a scene: samples a side of each pixel")
      ->check(CLI::Range(1, 8))
      ->capture_default_str()
      ->type_name("N");
  command
      .add_option(
          "--proxy", input.proxy,
          "What the place is shaped like: a mesh, scene (the scene itself, simplified), box (around the "
          "positions and what is known of points), depth (of the views with depth in the folder depth beside the "
          "images), or none")
      ->type_name("FILE|scene|box|depth|none");
  command
      .add_option("--proxy-triangles", input.proxyTriangles,
                  "The most triangles that the scene, or what depths show, is simplified to")
      ->check(numberCheck(12, 8e6))
      ->capture_default_str()
      ->type_name("N");
  SeaSettings& settings = choice->settings;
  command
      .add_option("--way", choice->way,
                  "What residuals are against: root, indirect (the parent in the tree) or direct (the nearest I-node)")
      ->check(CLI::IsMember({"root", "indirect", "direct"}))
      ->capture_default_str()
      ->type_name("NAME");
  command.add_option("--i-spacing", settings.spacing, "Levels of the tree between I-nodes; 0: each image is one")
      ->capture_default_str()
      ->type_name("LEVELS");
  command.add_option("--i-codec", settings.iCodec, "Of I-nodes")->capture_default_str()->type_name("NAME");
  command.add_option("--p-codec", settings.pCodec, "Of residuals")->capture_default_str()->type_name("NAME");
  command.add_option("--i-quality", settings.iQuality, "Of I-nodes, as their codec has it")
      ->capture_default_str()
      ->type_name("1..100");
  command.add_option("--p-quality", settings.pQuality, "Of residuals")->capture_default_str()->type_name("1..100");
  command
      .add_option("--adaptive", settings.adaptive,
                  "Lower the quality of residuals with little energy by up to this share")
      ->capture_default_str()
      ->type_name("SHARE");
  settings.refinement = "";
  command
      .add_option("--refine", settings.refinement,
                  "How poses are refined: none, bobyqa or subplex; by default bobyqa for photographs, none for scenes")
      ->type_name("NAME");
  command.add_option("--warp-cell", settings.warpCell, "Pixels between the rays that are cast at the proxy first")
      ->capture_default_str()
      ->type_name("N");
  command
      .add_option("--hidden", settings.hidden,
                  "Store with each I-node what it does not see and images that hang on it do: samples that a kind of "
                  "reference image has of the proxy, such as ddoc, cell or ldi-2; or none")
      ->capture_default_str()
      ->type_name("KIND");
  command.add_option("--hidden-quality", settings.hiddenQuality, "Of hidden samples, as the codec of I-nodes has it")
      ->capture_default_str()
      ->type_name("1..100");
  command.add_option("--hidden-views", settings.hiddenViews, "Store hidden samples that at least so many images see")
      ->capture_default_str()
      ->type_name("N");
  command.add_flag("--start-over", choice->startOver,
                   "Remove what a build that was stopped has left, instead of going on");
  addFiguresOption(command, choice->json);
  addOutputOption(command, choice->output, "Where the sea goes", {".sea"});
  context.finish(
      command,
      "  ocelli sea build builtin:museum --count 2000 -o museum.sea\n"
      "  ocelli sea build photos/ --proxy room.ply -o room.sea\n"
      "  ocelli sea build town.glb --grid 0,0,4,4,0.1 --eye-height 1.6 --i-codec jxl --p-codec jxl -o town.sea",
      [choice, context] { runBuild(*choice, context); });
}

}  // namespace ocelli
