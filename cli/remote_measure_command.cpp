// `ocelli remote measure`: a path over links, by images that the client draws from and by their peers.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <system_error>

#include "cli/command.h"
#include "cli/interrupt.h"
#include "cli/number_check.h"
#include "cli/output_option.h"
#include "cli/remote_command.h"
#include "cli/scene_options.h"
#include "cli/values.h"
#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/base/output_file.h"
#include "oc_core/remote_measure/remote_measure_page.h"
#include "oc_core/remote_measure/remote_measure_report.h"

namespace ocelli {
namespace {

namespace fs = std::filesystem;

constexpr double kQuickEvery = 4;  ///< so many times fewer pictures are judged with --quick

struct RemoteMeasureChoice {
  SceneChoice scene;
  std::string view;
  std::string path = "look-around";
  size_t frames = 0;
  double framesPerSecond = 60;
  std::string screen = "1280x720";
  std::vector<std::string> links;
  std::vector<std::string> modes{"gpc", "di", "jpeg", "x264", "x265", "x265-444"};
  RemoteMeasureOptions options;
  size_t every = 15;
  bool quick = false;
  double serverMilliseconds = -1;
  double clientMilliseconds = -1;
  double decodeMilliseconds = -1;
  double peerMilliseconds = 10;
  std::string json;
  std::string csv;
  std::string page;
};

std::optional<double> secondsOrMeasured(double milliseconds) {
  return milliseconds < 0 ? std::nullopt : std::optional(milliseconds / 1e3);
}

void preparePage(const std::string& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) {
    throw WorkError("cannot make this folder (" + error.message() + ")", folder, "choose another one with -o");
  }
  checkWritable(fs::path(folder) / "index.html");
}

void runRemoteMeasure(RemoteMeasureChoice& choice, const CommandContext& context) {
  RemoteMeasureOptions& options = choice.options;
  const ImageSize size = imageSizeFromText(choice.screen, "--screen");
  options.scene = choice.scene.source;
  options.screen = {size.width, size.height};
  options.path = remotePath(choice.path, readViewOption(choice.view), choice.frames, choice.framesPerSecond);
  if (!choice.links.empty()) {
    options.links.clear();
    for (const std::string& link : choice.links) {
      options.links.push_back(linkSpeedFromText(link));
    }
  }
  options.modes = choice.modes;
  options.every = choice.quick ? static_cast<size_t>(kQuickEvery) * choice.every : choice.every;
  options.serverSeconds = secondsOrMeasured(choice.serverMilliseconds);
  options.clientSeconds = secondsOrMeasured(choice.clientMilliseconds);
  options.decodeSeconds = secondsOrMeasured(choice.decodeMilliseconds);
  options.peerSeconds = choice.peerMilliseconds / 1e3;
  for (const std::string& file : {choice.json, choice.csv}) {
    if (!file.empty() && file != "-") {
      checkWritable(file);
    }
  }
  if (!choice.page.empty()) {
    preparePage(choice.page);
  }

  const InterruptGuard guard;
  const Progress progress = [bar = context.progress()](std::string_view stage, double fraction) {
    InterruptGuard::check();
    report(bar, stage, fraction);
  };
  try {
    const RemoteScene scene(loadScene(choice.scene.source, choice.scene.options, progress), choice.scene.source);
    const RemoteMeasurement measurement = measureRemote(scene, options, progress);
    giveFigures(choice.json, remoteMeasureJson(options, measurement), remoteMeasureTable(options, measurement),
                context);
    if (!choice.csv.empty()) {
      writeFile(choice.csv, remoteMeasureCsv(measurement));
    }
    if (!choice.page.empty()) {
      writeRemoteMeasurePage(choice.page, OCELLI_VERSION, options, measurement);
      context.note("wrote " + (fs::path(choice.page) / "index.html").string());
    }
  } catch (const Interrupted&) {
    throw WorkError("interrupted: nothing was measured to the end", choice.scene.source,
                    "fewer modes (--modes), links (--link) or frames (--frames) take less time");
  }
}

std::string pathHelp() {
  std::string help = "What is looked at: a JSON file with views, or";
  for (const RemotePathKind& kind : remotePaths()) {
    help += fmt::format("\n  {}: {}", kind.name, kind.meaning);
  }
  return help;
}

std::string modeHelp() {
  std::string help = "What is compared:";
  for (const RemoteModeName& mode : remoteModes()) {
    help += "\n  " + mode.name + ": " + mode.meaning;
  }
  return help;
}

}  // namespace

void addRemoteMeasure(CLI::App& remote, const CommandContext& context) {
  CLI::App& command = *remote.add_subcommand(
      "measure", "Play a path over slow and fast links: bytes, stalls and errors of images, frames and video");
  const auto choice = std::make_shared<RemoteMeasureChoice>();
  RemoteMeasureOptions& options = choice->options;
  addSceneOptions(command, choice->scene, context);
  addViewOption(command, choice->view);
  command.add_option("--path", choice->path, pathHelp())->type_name("NAME|FILE.json");
  command.add_option("--frames", choice->frames, "How many frames; 0: all of a file, 900 of a built-in path")
      ->check(CLI::Range(size_t{0}, kMaxPathFrames))
      ->type_name("N");
  command.add_option("--rate", choice->framesPerSecond, "Frames a second")->check(numberCheck(1, 240))->type_name("HZ");
  command.add_option("--screen", choice->screen, "The client's screen")->type_name("WIDTHxHEIGHT");
  command
      .add_option(
          "--link", choice->links,
          "Bytes a second and round trip of a link, once for each; without it 300KB/s, 1MB/s and 12.5MB/s, each "
          "with 20ms and 200ms")
      ->type_name("RATE:DELAY");
  command.add_option("--modes", choice->modes, modeHelp())->delimiter(',')->type_name("NAME,...");
  command.add_option("--every", choice->every, "One of so many frames is judged: PSNR and FLIP")
      ->check(CLI::Range(1, 10000))
      ->type_name("N");
  command
      .add_option("--truth-samples", options.truthSamples, "Rays along either axis of a pixel of what should be seen")
      ->check(CLI::Range(1, 8))
      ->type_name("N");
  command.add_flag("--quick", choice->quick, "Judge a quarter of those");
  command.add_option("--jpeg-quality", options.jpegQualities, "Of JPEG frames")
      ->delimiter(',')
      ->check(numberCheck(0, 100))
      ->type_name("Q,...");
  command
      .add_option("--crf", options.rateFactors,
                  "Rate factors of the streams whose bytes are compared at equal error; less is better")
      ->delimiter(',')
      ->check(numberCheck(0, 51))
      ->type_name("CRF,...");
  command.add_option("--stream-crf", options.streamFactor, "Rate factor of streams over a link, where it carries that")
      ->check(numberCheck(0, 51))
      ->type_name("CRF");
  command
      .add_option("--server-ms", choice->serverMilliseconds,
                  "What the server takes to draw and encode an image; -1: what it takes here")
      ->check(numberCheck(-1, 1e5))
      ->type_name("MS");
  command
      .add_option("--client-ms", choice->clientMilliseconds,
                  "What the client takes to draw a picture; -1: what it takes here")
      ->check(numberCheck(-1, 1e5))
      ->type_name("MS");
  command
      .add_option("--decode-ms", choice->decodeMilliseconds,
                  "What the client takes to decode a message of an image: its colours, and then all of it; -1: what it "
                  "takes here")
      ->check(numberCheck(-1, 1e5))
      ->type_name("MS");
  command
      .add_option("--peer-ms", choice->peerMilliseconds,
                  "What the server of frames and streams takes to draw and encode one")
      ->check(numberCheck(0, 1e5))
      ->type_name("MS");
  command
      .add_option("--images", options.rule.maxRequests,
                  "How many images the client may ask for; 0: as many as it takes")
      ->check(CLI::Range(0, 100000))
      ->type_name("N");
  addRemoteSettingsOptions(command, options.settings);
  addFiguresOption(command, choice->json);
  command.add_option("--csv", choice->csv, "Also write the figures here, a line a mode and link")->type_name("FILE");
  command.add_option("-o,--output", choice->page, "Also make a page with charts and pictures in this folder")
      ->type_name("DIR");
  context.finish(command,
                 "  ocelli remote measure builtin:statues\n"
                 "  ocelli remote measure builtin:canyon --path explore --link 300KB/s:200ms -o canyon\n"
                 "  ocelli remote measure room.glb --path walk.json --modes gpc,x265 --quick --json room.json",
                 [choice, context] { runRemoteMeasure(*choice, context); });
}

}  // namespace ocelli
