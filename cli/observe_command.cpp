// `ocelli observe`: what an eye or a camera sees of a volume on the display.
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "cli/command.h"
#include "cli/gl_display.h"
#include "cli/gl_drawing.h"
#include "cli/output_option.h"
#include "cli/values.h"
#include "display_sim/observer.h"
#include "display_sim/svol_file.h"
#include "oc_core/base/png_file.h"

namespace ocelli {
namespace {

struct ObserveChoice {
  std::string volume;
  std::string eye;
  std::string exposure;
  std::string size = "768x768";
  ObserverOptions options;
  std::string method = "processor";
  std::string gl = "auto";
  std::string output;
};

ObserverOptions observerOptions(const ObserveChoice& choice, const DisplayProfile& profile) {
  ObserverOptions options = choice.options;
  const auto distance = static_cast<float>(profile.viewingDistanceRadii());
  options.eye = choice.eye.empty() ? glm::vec3(0, 0, distance) : pointFromText(choice.eye, "--eye");
  if (!choice.exposure.empty()) {
    options.exposureSeconds = ratioFromText(choice.exposure, "--exposure");
  }
  const ImageSize size = imageSizeFromText(choice.size, "--size");
  options.width = size.width;
  options.height = size.height;
  return options;
}

}  // namespace

void addObserveCommand(CLI::App& program, const Frame& frame) {
  CLI::App& command = *program.add_subcommand("observe", "Show what an eye sees of a volume on its display");
  const auto choice = std::make_shared<ObserveChoice>();
  command.add_option("VOLUME", choice->volume, "A volume (.svol)")->required();
  command
      .add_option("--eye", choice->eye,
                  "Where the eye is, in display radii; by default in front, at the display's viewing distance")
      ->type_name("X,Y,Z");
  command.add_option("--exposure", choice->exposure, "Seconds; by default one refresh of the display")
      ->type_name("SECONDS");
  command
      .add_option("--missing-sector", choice->options.missingSectorStartDegrees,
                  "Screen angle where an exposure ends, and where a shorter one than a refresh misses a sector")
      ->type_name("DEGREES");
  command.add_option("--size", choice->size, "Of the picture, in pixels")->type_name("WIDTHxHEIGHT");
  command
      .add_option("--fov", choice->options.fovVerticalDegrees, "Vertical field of view; 0 just holds the unit sphere")
      ->type_name("DEGREES");
  command.add_option("--gain", choice->options.gain, "Factor on the light; 0 chooses one for the picture")
      ->type_name("FACTOR");
  command.add_option("--gamma", choice->options.gamma, "Exponent 1/GAMMA on the light")->type_name("GAMMA");
  addMethodOption(command, choice->method);
  addGlOption(command, choice->gl);
  addOutputOption(command, choice->output, "Where the picture goes", {".png"});
  frame.finish(command,
               "  ocelli observe teapot.svol -o teapot.png\n"
               "  ocelli observe teapot.svol --eye 0,4,9 --exposure 1/25 --missing-sector 30 -o teapot.png",
               [choice, frame] {
                 requireGlUsed(choice->gl, choice->method == "gl", "--method gl");
                 const auto gl = choice->method == "gl" ? std::make_unique<GlDisplay>(choice->gl) : nullptr;
                 const Volume volume = readSvol(choice->volume);
                 const ObserverOptions options = observerOptions(*choice, volume.profile());
                 Image<glm::vec3> light =
                     gl != nullptr ? gl->collectLight(volume, options) : collectLight(volume, options);
                 tone(light, options.gain > 0 ? options.gain : automaticGain(light), options.gamma);
                 writePng(choice->output, srgbFromLinear(light));
                 if (gl != nullptr) {
                   frame.note("drawn with " + gl->description());
                 }
                 frame.note(fmt::format("wrote {}: seen from {:g},{:g},{:g}", choice->output, options.eye.x,
                                        options.eye.y, options.eye.z));
               });
}

}  // namespace ocelli
