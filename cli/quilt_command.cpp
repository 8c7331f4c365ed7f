// `ocelli quilt`: pictures for light-field displays.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <nlohmann/json.hpp>
#include <optional>

#include "cli/command.h"
#include "cli/interrupt.h"
#include "cli/number_check.h"
#include "cli/output_option.h"
#include "cli/quilt_choice.h"
#include "display_sim/observing/frame_sink.h"
#include "display_sim/quilt/color_and_depth.h"
#include "display_sim/quilt/panel_order.h"
#include "display_sim/quilt/quilt_errors.h"
#include "display_sim/quilt/quilt_ways.h"
#include "oc_core/base/error.h"
#include "oc_core/base/json_document.h"
#include "oc_core/base/output_file.h"
#include "oc_core/worlds/scene_motion.h"

namespace ocelli {
namespace {

using Json = nlohmann::ordered_json;

struct QuiltCommandChoice {
  QuiltChoice quilt;
  std::string output;
  std::string panel;
  std::string pair;
  std::string depthSide = "right";
  std::optional<double> seconds;
  double framesPerSecond = 24;
  bool evaluate = false;
  std::string json;
};

void checkQuiltChoice(const QuiltCommandChoice& choice) {
  if (!choice.panel.empty() && choice.quilt.calibration.empty()) {
    throw InputError("the panel's own order takes the calibration of the display", "--panel",
                     "add --calibration FILE.json");
  }
  if (choice.quilt.isImage() && (choice.evaluate || !choice.pair.empty())) {
    throw InputError("an image is no scene: there is nothing to render", choice.evaluate ? "--evaluate" : "--rgbd",
                     "give the scene that the image was made of");
  }
  if (isVideo(choice.output) && (choice.evaluate || !choice.pair.empty() || !choice.panel.empty())) {
    throw InputError("--evaluate, --rgbd and --panel take one picture", "-o", "give a .png file, and --time");
  }
  if (!isVideo(choice.output) && choice.seconds) {
    throw InputError("one picture has no length", "--seconds", "leave it out, or give an .mp4 file");
  }
}

std::string sizeText(const QuiltViews& views) {
  const QuiltDisplay& display = views.display();
  return fmt::format("{} views of {}x{}", views.count(), display.tileWidth(), display.tileHeight());
}

std::string outputOf(const QuiltCommandChoice& choice, const QuiltViews& views) {
  return isStream(choice.output) ? choice.output : quiltFileName(choice.output, views.display());
}

/// Compares the quilt, and what displays make of colour and depth, with rendered views.
Json evaluated(const QuiltCommandChoice& choice, const QuiltViews& views, const Mesh& scene, const QuiltPicture& quilt,
               const CommandContext& context) {
  const QuiltWay& pairWay = quiltWayNamed("rgbd", "--evaluate");
  const QuiltWay& exactWay = quiltWayNamed("di", "--evaluate");
  const QuiltWayInputs inputs{views, scene, choice.quilt.images, QuiltDepths::kKept, {}};
  const QuiltPicture exact = exactWay.make(inputs);
  const QuiltPicture pair = pairWay.make(inputs);
  const std::vector<std::string> names{choice.quilt.by, exactWay.name, pairWay.name};
  const std::vector<FrameErrors> errors = quiltErrors(views, scene, {&quilt, &exact, &pair}, context.progress());
  Json rows = Json::array();
  std::string table =
      fmt::format("{:<10} {:>16} {:>16} {:>9} {:>9}\n", "by", "missing, strict", "missing, thick", "FLIP", "PSNR dB");
  for (size_t i = 0; i < names.size(); ++i) {
    const FrameErrors& e = errors[i];
    table += fmt::format("{:<10} {:>14.3f} % {:>14.3f} % {:>9.4f} {:>9.2f}\n", names[i], 100 * e.strictRatio(),
                         100 * e.thickRatio(), e.meanFlip(), e.meanPsnrDecibels());
    rows.push_back({{"by", names[i]},
                    {"missing_strict", e.strictRatio()},
                    {"missing_thick", e.thickRatio()},
                    {"flip", e.meanFlip()},
                    {"psnr_db", e.meanPsnrDecibels()}});
  }
  context.clearProgress();
  if (choice.json != "-") {
    context.print(table);
  }
  return rows;
}

/// A file does not say where its empty rays went: what lies behind the scene is not told from what was not seen.
std::string gapsText(const QuiltChoice& quilt, const QuiltViews& views, const QuiltPicture& picture) {
  const double percent = 100 * picture.filledRatio(views);
  return quilt.isImage() ? fmt::format("{:.2f} % of the pixels show nothing, or what the image has not seen", percent)
                         : fmt::format("{:.2f} % of the pixels filled in", percent);
}

void makePicture(const QuiltCommandChoice& choice, const QuiltSource& source, const QuiltViews& views,
                 const CommandContext& context) {
  const std::string output = outputOf(choice, views);
  checkWritable(output);
  checkSecondOutput(choice.panel, "--panel", output);
  checkSecondOutput(choice.pair, "--rgbd", output);
  checkFiguresOutput(choice.json, output);
  const auto start = std::chrono::steady_clock::now();
  const QuiltPicture picture =
      source.picture(views, choice.evaluate ? QuiltDepths::kKept : QuiltDepths::kNone, context.progress());
  const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
  writePng(output, picture.color);
  Json figures{
      {"display", views.display().name}, {"views", views.count()},       {"cone_degrees", views.display().coneDegrees},
      {"by", source.description()},      {"milliseconds", time.count()}, {"filled", picture.filledRatio(views)}};
  context.note(fmt::format("wrote {}: {} by {} in {:.0f} ms; {}", output, sizeText(views), source.description(),
                           time.count(), gapsText(choice.quilt, views, picture)));
  if (!choice.panel.empty()) {
    const PanelCalibration panel = readCalibration(choice.quilt.calibration);
    writePng(choice.panel, panelPicture(picture.color, views.display(), panel));
    context.note(fmt::format("wrote {}: the dots of a panel of {}x{}", choice.panel, panel.width, panel.height));
  }
  if (!choice.pair.empty()) {
    const DepthSide& side = depthSideNamed(choice.depthSide, "--depth-side");
    writePng(choice.pair, pictureOf(colorAndDepth(middleDepthImage(views, source.scene())), side));
    context.note(fmt::format("wrote {}: colour, and depth on its {} ({})", choice.pair, side.name, side.number));
  }
  if (choice.evaluate) {
    figures["evaluation"] = evaluated(choice, views, source.scene(), picture, context);
  }
  giveFigures(choice.json, textOfJson(figures, 2) + "\n", "", context);
}

void makeVideo(const QuiltCommandChoice& choice, const QuiltViews& views, const CommandContext& context) {
  const std::string output = outputOf(choice, views);
  const std::unique_ptr<SceneMotion> motion =
      mayMove(choice.quilt.scene.source)
          ? loadMotion(choice.quilt.scene.source, choice.quilt.scene.options, context.progress())
          : nullptr;
  if (motion == nullptr) {
    throw InputError("this scene stands still", choice.quilt.scene.source, "give a .png file with -o");
  }
  const double seconds = choice.seconds.value_or(motion->durationSeconds());
  const auto frames = static_cast<int64_t>(std::max(1.0, std::round(seconds * choice.framesPerSecond)));
  const QuiltWay& way = quiltWayNamed(choice.quilt.by, "--by");
  runOrLeaveNothing(output, context.progress(), [&](const Progress& progress) {
    const auto sink = videoFile(output, {views.display().width, views.display().height, choice.framesPerSecond});
    for (int64_t i = 0; i < frames; ++i) {
      report(progress, "frames", static_cast<double>(i) / static_cast<double>(frames));
      Mesh scene = motion->at(static_cast<double>(i) / choice.framesPerSecond);
      views.stretchScene(scene, views.stretch());
      sink->add(way.make({views, scene, choice.quilt.images, QuiltDepths::kNone, {}}).color);
    }
    sink->finish();
  });
  context.note(fmt::format("wrote {}: {} frames, each of {}", output, frames, sizeText(views)));
}

void runQuilt(const QuiltCommandChoice& choice, const CommandContext& context) {
  checkQuiltChoice(choice);
  depthSideNamed(choice.depthSide, "--depth-side");
  const QuiltViews views = quiltViewsOf(choice.quilt, context);
  if (isVideo(choice.output)) {
    makeVideo(choice, views, context);
    return;
  }
  const QuiltSource source(choice.quilt, views, context);
  makePicture(choice, source, views, context);
}

}  // namespace

void addQuiltCommand(CLI::App& program, const CommandContext& context) {
  CLI::App& command = *program.add_subcommand(
      "quilt", "Make a picture for a light-field display: tiles that are views from places along a line");
  const auto choice = std::make_shared<QuiltCommandChoice>();
  addQuiltOptions(command, choice->quilt, context);
  command
      .add_option("--panel", choice->panel, "Also write what the panel itself shows, dot by dot, as --calibration says")
      ->type_name("FILE.png");
  command
      .add_option("--rgbd", choice->pair,
                  "Also write the middle view as colour and depth, near ones white, side by side")
      ->type_name("FILE.png");
  command.add_option("--depth-side", choice->depthSide, "Where the depth stands in it: top, bottom, right or left")
      ->capture_default_str()
      ->type_name("NAME");
  command
      .add_option("--seconds", choice->seconds, "Of an .mp4 file: how much of the scene's motion; all of it by default")
      ->check(numberCheck(0.001, 3600))
      ->type_name("SECONDS");
  command.add_option("--frames-per-second", choice->framesPerSecond, "Of an .mp4 file")
      ->check(numberCheck(0.01, 1000))
      ->capture_default_str()
      ->type_name("HERTZ");
  command.add_flag("--evaluate", choice->evaluate,
                   "Render every view, too, and print what the quilt lacks, beside what a display makes of colour and "
                   "depth, of full precision (di) and of 8 bits (rgbd)");
  addFiguresOption(command, choice->json);
  addOutputOption(command, choice->output,
                  "Where the quilt goes; the name gets an ending such as _qs8x6a0.75, which readers of quilts expect",
                  {".png", ".mp4"});
  context.finish(
      command,
      "  ocelli quilt builtin:statues --display portrait -o statues.png\n"
      "  ocelli quilt bunny.obj --display my-display.json --calibration visual.json --panel panel.png -o bunny.png\n"
      "  ocelli quilt builtin:statues --display 16 --evaluate --json figures.json -o statues.png\n"
      "  ocelli quilt builtin:waving --display go --seconds 2 -o waving.mp4",
      [choice, context] { runQuilt(*choice, context); });
}

}  // namespace ocelli
