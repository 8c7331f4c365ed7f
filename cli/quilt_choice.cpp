#include "cli/quilt_choice.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <glm/geometric.hpp>

#include "cli/number_check.h"
#include "cli/viewed_scene.h"
#include "display_sim/quilt/panel_order.h"
#include "oc_core/base/error.h"
#include "oc_core/ocri/reference_image_file.h"

namespace ocelli {
namespace {

std::string displayList() {
  std::string list;
  for (const QuiltDisplay& display : quiltDisplays()) {
    list += fmt::format("\n  {}: {}x{} views, {}x{} pixels, aspect {:g}", display.name, display.columns, display.rows,
                        display.width, display.height, display.aspect);
  }
  return list;
}

std::string wayList() {
  std::string list;
  for (const QuiltWay& way : quiltWays()) {
    list += fmt::format("\n  {}: {}", way.name, way.help);
  }
  return list;
}

/// What an epipolar image of these views would be made for: a packed scene gives what it needs.
CameraChoice segmentCamera(const QuiltViews& views) {
  CameraChoice choice = cameraChoice("eoc-h");
  choice.cellSideRadii = glm::distance(views.eyeIn(1, 0), views.eyeIn(1, views.count() - 1));
  return choice;
}

}  // namespace

void addQuiltOptions(CLI::App& command, QuiltChoice& choice, const CommandContext& context) {
  addSceneOptions(command, choice.scene, context);
  command.get_option("SCENE")->description(
      "A scene: a file or builtin:NAME; or X.exr, a reference image that `ocelli ocri build` wrote");
  addMotionOptions(command, choice.scene);
  command
      .add_option("--display", choice.display,
                  "The display, or a JSON file that describes one (docs/quilts.md):" + displayList())
      ->capture_default_str()
      ->type_name("NAME|FILE.json");
  command
      .add_option("--cone", choice.coneDegrees,
                  "Angle between the outermost views; by default that of the calibration, or of the display")
      ->check(numberCheck(kMinConeDegrees, kMaxConeDegrees))
      ->type_name("DEGREES");
  command
      .add_option("--calibration", choice.calibration,
                  "The calibration file that the display has on it: its cone, and how its panel is laid out")
      ->type_name("FILE.json");
  command
      .add_option("--view", choice.view,
                  "The middle view as a JSON file; its target lies in the plane of the display. By default one that "
                  "shows the unit sphere from 10 radii away")
      ->type_name("FILE.json");
  command.add_option("--by", choice.by, "How the views are made:" + wayList())
      ->capture_default_str()
      ->type_name("NAME");
  command
      .add_option("--images", choice.images.images,
                  "For eoc-h: one image from the leftmost view, or two from the middle, one to each side")
      ->check(CLI::Range(1, 2))
      ->capture_default_str()
      ->type_name("1|2");
  command
      .add_option("--sampling", choice.images.sampling,
                  "For eoc-h: samples of the image for each pixel of a tile, along its rows")
      ->check(numberCheck(0.25, 4))
      ->capture_default_str()
      ->type_name("RATIO");
}

QuiltViews quiltViewsOf(const QuiltChoice& choice, const CommandContext& context) {
  quiltWayNamed(choice.by, "--by");
  std::optional<PanelCalibration> panel;
  if (!choice.calibration.empty()) {
    panel = readCalibration(choice.calibration);
    for (const std::string& field : panel->unused) {
      context.note("warning: " + choice.calibration + " asks for " + field + ", which is not done");
    }
  }
  return {withCone(loadQuiltDisplay(choice.display), panel, choice.coneDegrees), readViewOption(choice.view)};
}

QuiltSource::QuiltSource(const QuiltChoice& choice, const QuiltViews& views, const CommandContext& context)
    : choice_(choice) {
  if (!choice.isImage()) {
    const PinholeCamera middle = views.middle(1, views.display().tileWidth());
    scene_ = ViewedScene(choice.scene, context).meshFor(segmentCamera(views), middle);
    views.stretchScene(scene_, views.stretch());
    return;
  }
  images_ = readReferenceImages(choice.scene.source);
  const ReferenceImage& first = images_.front();
  if (images_.size() == 1) {
    lines_ = quiltLinesOf(views, first);
  }
  if (first.rows != ImageRows::kShifted) {
    context.note(fmt::format("warning: {} is an image of the camera {}, not of an eoc-h: it lacks what other views see",
                             choice.scene.source, first.camera));
  } else if (!lines_) {
    context.note(
        fmt::format("note: the rows of {} are not those of the tiles ({}x{}), so its mesh is drawn for each "
                    "view, which takes longer",
                    choice.scene.source, views.display().tileWidth(), views.display().tileHeight()));
  }
}

QuiltPicture QuiltSource::picture(const QuiltViews& views, QuiltDepths depths, const Progress& progress) const {
  if (!choice_.isImage()) {
    return quiltWayNamed(choice_.by, "--by").make({views, scene_, choice_.images, depths, progress});
  }
  return lines_ ? quiltFromLines(views, {*lines_}, depths) : quiltFromMesh(views, images_, 1, depths, progress);
}

std::string QuiltSource::description() const {
  if (!choice_.isImage()) {
    return choice_.by;
  }
  return "the " + std::string(lines_ ? "rows" : "mesh") + " of an image of " + images_.front().camera;
}

}  // namespace ocelli
