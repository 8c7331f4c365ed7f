// `ocelli observe`: what eyes or a camera see of a volume on the display.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <nlohmann/json.hpp>
#include <optional>

#include "cli/command.h"
#include "cli/gl_display.h"
#include "cli/gl_drawing.h"
#include "cli/interrupt.h"
#include "cli/observer_choice.h"
#include "cli/scene_notes.h"
#include "cli/values.h"
#include "display_sim/frames/svol_file.h"
#include "display_sim/observing/light_file.h"
#include "display_sim/observing/observe_series.h"
#include "oc_core/base/error.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/base/output_file.h"

namespace ocelli {
namespace {

using Json = nlohmann::ordered_json;

struct ObserveChoice {
  std::string volume;
  int64_t frame = 0;
  ObserverChoice observer;
  double stereoMetres = 0;
  bool sideBySide = false;
  int turntable = 0;
  std::string path;
  std::optional<double> rate;
  bool json = false;
  std::string method = "cpu";
  std::string gl = "auto";
  std::string output;

  bool isSeries() const { return turntable > 0 || !path.empty(); }
  double framesPerSecond() const { return rate.value_or(24); }
  bool isExr() const { return output.ends_with(".exr"); }
};

/// What the command works with once the volume is read.
struct Observation {
  const ObserveChoice& choice;
  const ObserverOptions& options;
  double separationRadii;
  const std::vector<EyePose>& way;  ///< of --path
  const CollectLight& collect;
  const CommandContext& context;
};

void checkOutput(const ObserveChoice& choice) {
  const std::string& output = choice.output;
  const bool stream = isStream(output);
  const bool image = output.ends_with(".png") || choice.isExr() || stream;
  if (choice.isSeries() && image) {
    throw InputError("a series of images does not go into one of them", output,
                     "give a folder, or a video that ends in .mp4 or .webm");
  }
  if (!choice.isSeries() && !image) {
    throw InputError("\"" + output + "\" does not end in .png or .exr", "-o",
                     "give such a file; folders and videos are for --turntable and --path");
  }
  if (stream && choice.stereoMetres > 0 && !choice.sideBySide) {
    throw InputError("two images do not go into one output", output, "add --side-by-side, or give a file");
  }
  if (choice.isExr() && (choice.observer.gain > 0 || choice.observer.gamma != 1 || choice.observer.tone != "clip")) {
    throw InputError("an .exr file holds the light as it is", "--gain, --gamma, --tone",
                     "leave these options out, or write a .png file");
  }
  if (!(choice.stereoMetres >= 0 && choice.stereoMetres <= 10)) {
    throw InputError("eyes must be between 0 and 10 metres apart", "--stereo", "--stereo 0.063");
  }
  if (choice.sideBySide && choice.stereoMetres == 0) {
    throw InputError("there is one image only", "--side-by-side", "add --stereo 0.063");
  }
  if (choice.rate && !choice.isSeries()) {
    throw InputError("there is one image only", "--rate", "leave it out, or add --turntable or --path");
  }
  if (!(choice.framesPerSecond() >= 0.01 && choice.framesPerSecond() <= 1000)) {
    throw InputError("there must be between 0.01 and 1000 frames in a second", "--rate", "--rate 24");
  }
}

std::string withSuffix(const std::string& path, const std::string& suffix) {
  const size_t dot = path.size() - 4;  // checkOutput() saw ".png" or ".exr"
  return path.substr(0, dot) + suffix + path.substr(dot);
}

void writeImage(const std::string& path, const Image<glm::vec3>& light, const Tone& tone, const Json& figures) {
  if (path.ends_with(".exr")) {
    writeLightExr(path, light, textOfJson(figures));
  } else {
    writeTonedPng(path, light, tone);
  }
}

/// Adds what it measured to the figures.
void observeImages(const Observation& o, Json& figures) {
  const bool pair = o.separationRadii > 0;
  const bool two = pair && !o.choice.sideBySide;
  const std::string left = two ? withSuffix(o.choice.output, "-left") : "";
  const std::string right = two ? withSuffix(o.choice.output, "-right") : "";
  for (const std::string& path : two ? std::vector{left, right} : std::vector{o.choice.output}) {
    checkWritable(path);
  }
  const auto start = std::chrono::steady_clock::now();
  const LightPair seen = pair ? collectPair(o.collect, o.options, o.separationRadii) : LightPair{};
  const Image<glm::vec3> whole = two ? Image<glm::vec3>() : pair ? sideBySide(seen) : o.collect(o.options);
  const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
  Tone tone = o.options.tone;
  if (tone.gain == 0) {
    CommonGain common;
    if (two) {
      common.add(seen.left);
      common.add(seen.right);
    } else {
      common.add(whole);
    }
    tone.gain = common.gain();
  }
  figures["gain"] = tone.gain;
  if (two) {
    writeImage(left, seen.left, tone, figures);
    writeImage(right, seen.right, tone, figures);
  } else {
    writeImage(o.choice.output, whole, tone, figures);
  }
  figures["observe_ms"] = time.count();
  const glm::vec3& eye = o.options.eye;
  o.context.note(fmt::format("wrote {}: seen from {:g},{:g},{:g} in {:.0f} ms",
                             two ? fmt::format("{} and {}", left, right) : o.choice.output, eye.x, eye.y, eye.z,
                             time.count()));
}

void observeFrames(const Observation& o, const DisplayProfile& profile, Json& figures) {
  const double rate = o.choice.framesPerSecond();
  ObserverSeries series;
  series.eyes = o.choice.turntable > 0 ? turntableEyes(o.options.eye, o.choice.turntable) : eyesAlong(o.way, rate);
  series.separationRadii = o.separationRadii;
  checkSeries(series, o.options, profile);
  const int width = o.options.width * (o.separationRadii > 0 ? 2 : 1);
  const auto sink = isVideo(o.choice.output) ? videoFile(o.choice.output, {width, o.options.height, rate})
                                             : frameFolder(o.choice.output);
  const auto start = std::chrono::steady_clock::now();
  double gain = 0;
  runOrLeaveNothing(o.choice.output, o.context.progress(), [&](const Progress& progress) {
    gain = seriesGain(o.collect, o.options, series);
    observeSeries(o.collect, o.options, series, gain, *sink, progress);
    sink->finish();
  });
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  figures["gain"] = gain;
  figures["frames"] = series.eyes.size();
  figures["seconds"] = time.count();
  o.context.note(fmt::format("wrote {}: {} frames in {:.1f} s", o.choice.output, series.eyes.size(), time.count()));
}

void run(const ObserveChoice& choice, const CommandContext& context) {
  requireGlUsed(choice.gl, choice.method == "gl", "--method gl");
  checkOutput(choice);
  const auto gl = choice.method == "gl" ? std::make_unique<GlDisplay>(choice.gl) : nullptr;
  const Volume volume = readSvol(choice.volume, frameNumber(choice.frame, "--frame"));
  noteDarkVolume(context, volume);
  ObserverOptions options = observerOptions(choice.observer, volume.profile());
  const std::vector<EyePose> way = choice.path.empty() ? std::vector<EyePose>() : readEyePath(choice.path);
  if (!way.empty()) {
    checkWay(way, choice.framesPerSecond(), volume.profile(), choice.path);
    options.eye = way.front().eye;
  } else if (choice.observer.eye.empty()) {
    checkDefaultEye(volume.profile());
  }
  checkObserverOptions(options, volume.profile());
  const CollectLight collect =
      gl != nullptr ? gl->observerOf(volume) : [&](const ObserverOptions& o) { return collectLight(volume, o); };
  const Observation observation{choice, options, choice.stereoMetres / volume.profile().radiusMetres,
                                way,    collect, context};
  Json figures = {{"profile", volume.profile().name},
                  {"eye", {options.eye.x, options.eye.y, options.eye.z}},
                  {"lit_voxels", volume.litVoxels()}};
  if (choice.isSeries()) {
    observeFrames(observation, volume.profile(), figures);
  } else {
    observeImages(observation, figures);
  }
  if (choice.json) {
    context.print(textOfJson(figures, 2) + "\n");
  }
  if (gl != nullptr) {
    context.note("drawn with " + gl->description());
  }
}

void addSeriesOptions(CLI::App& command, ObserveChoice& choice) {
  command.add_option("--stereo", choice.stereoMetres, "Two images, for eyes so far apart: NAME-left and NAME-right")
      ->type_name("METRES");
  command.add_flag("--side-by-side", choice.sideBySide, "Both in one image; in series they always are");
  CLI::Option* turntable =
      command
          .add_option("--turntable", choice.turntable, "So many frames around the display, into a folder or a video")
          ->check(CLI::Range(1, kMaxFrames))
          ->type_name("FRAMES");
  command
      .add_option("--path", choice.path,
                  "The eye's way: a table with the header time,x,y,z, or JSON; frames into a folder or a video")
      ->excludes(turntable)
      ->type_name("FILE.csv|FILE.json");
  command.add_option("--rate", choice.rate, "Frames in a second of a way or a video")->type_name("NUMBER");
}

}  // namespace

void addObserveCommand(CLI::App& program, const CommandContext& context) {
  CLI::App& command = *program.add_subcommand("observe", "Show what an eye sees of a volume on its display");
  const auto choice = std::make_shared<ObserveChoice>();
  command.add_option("VOLUME", choice->volume, "A volume (.svol)")->required();
  command.add_option("--frame", choice->frame, "Which frame of a recording, from 0")->type_name("NUMBER");
  addObserverOptions(command, choice->observer);
  addSeriesOptions(command, *choice);
  addMethodOption(command, choice->method);
  addGlOption(command, choice->gl);
  command.add_flag("--json", choice->json, "Print the figures as JSON");
  command
      .add_option("-o,--output", choice->output,
                  "Where it goes: a toned image, all of its light, or a series of images as PNG files or a video")
      ->required()
      ->type_name("FILE.png|FILE.exr|FOLDER|FILE.mp4|FILE.webm");
  context.finish(command,
                 "  ocelli observe teapot.svol -o teapot.png\n"
                 "  ocelli observe teapot.svol --eye 0,4,9 --exposure 1/25 --missing-sector 30 -o teapot.png\n"
                 "  ocelli observe teapot.svol --exposure 1/12 --wobble 0.005 --ambient 0.001 -o teapot.exr\n"
                 "  ocelli observe teapot.svol --turntable 120 -o teapot.mp4",
                 [choice, context] { run(*choice, context); });
}

}  // namespace ocelli
