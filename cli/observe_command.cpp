// `ocelli observe`: what an eye or a camera sees of a volume on the display.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <nlohmann/json.hpp>

#include "cli/command.h"
#include "cli/gl_display.h"
#include "cli/gl_drawing.h"
#include "cli/observer_choice.h"
#include "cli/output_option.h"
#include "display_sim/light_file.h"
#include "display_sim/svol_file.h"
#include "oc_core/base/error.h"
#include "oc_core/base/output_file.h"

namespace ocelli {
namespace {

struct ObserveChoice {
  std::string volume;
  ObserverChoice observer;
  bool json = false;
  std::string method = "processor";
  std::string gl = "auto";
  std::string output;
};

void checkExr(const ObserverChoice& choice) {
  if (choice.gain > 0 || choice.gamma != 1 || choice.tone != "clip") {
    throw InputError("an .exr file holds the light as it is", "--gain, --gamma, --tone",
                     "leave these options out, or write a .png file");
  }
}

void run(const ObserveChoice& choice, const Frame& frame) {
  requireGlUsed(choice.gl, choice.method == "gl", "--method gl");
  const bool exr = choice.output.ends_with(".exr");
  if (exr) {
    checkExr(choice.observer);
  }
  checkWritable(choice.output);
  const auto gl = choice.method == "gl" ? std::make_unique<GlDisplay>(choice.gl) : nullptr;
  const Volume volume = readSvol(choice.volume);
  const ObserverOptions options = observerOptions(choice.observer, volume.profile());
  const auto start = std::chrono::steady_clock::now();
  const Image<glm::vec3> light = gl != nullptr ? gl->collectLight(volume, options) : collectLight(volume, options);
  const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
  Tone tone = options.tone;
  tone.gain = tone.gain > 0 ? tone.gain : automaticGain(light);
  nlohmann::ordered_json json = {{"profile", volume.profile().name},
                                 {"eye", {options.eye.x, options.eye.y, options.eye.z}},
                                 {"lit_voxels", volume.litVoxels()},
                                 {"gain", tone.gain}};
  if (exr) {
    writeLightExr(choice.output, light, json.dump());
  } else {
    writeTonedPng(choice.output, light, tone);
  }
  if (choice.json) {
    json["observe_ms"] = time.count();
    frame.print(json.dump(2) + "\n");
  }
  if (gl != nullptr) {
    frame.note("drawn with " + gl->description());
  }
  frame.note(fmt::format("wrote {}: seen from {:g},{:g},{:g} in {:.0f} ms", choice.output, options.eye.x, options.eye.y,
                         options.eye.z, time.count()));
}

}  // namespace

void addObserveCommand(CLI::App& program, const Frame& frame) {
  CLI::App& command = *program.add_subcommand("observe", "Show what an eye sees of a volume on its display");
  const auto choice = std::make_shared<ObserveChoice>();
  command.add_option("VOLUME", choice->volume, "A volume (.svol)")->required();
  addObserverOptions(command, choice->observer);
  addMethodOption(command, choice->method);
  addGlOption(command, choice->gl);
  command.add_flag("--json", choice->json, "Print the figures as JSON");
  addOutputOption(command, choice->output, "Where the picture goes: toned, or all of its light", {".png", ".exr"});
  frame.finish(command,
               "  ocelli observe teapot.svol -o teapot.png\n"
               "  ocelli observe teapot.svol --eye 0,4,9 --exposure 1/25 --missing-sector 30 -o teapot.png\n"
               "  ocelli observe teapot.svol --exposure 1/12 --wobble 0.005 --ambient 0.001 -o teapot.exr",
               [choice, frame] { run(*choice, frame); });
}

}  // namespace ocelli
