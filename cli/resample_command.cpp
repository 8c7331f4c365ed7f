#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "cli/command.h"
#include "cli/output_option.h"
#include "cli/scene_options.h"
#include "cli/values.h"
#include "oc_core/base/output_file.h"
#include "oc_core/image/png_file.h"
#include "oc_core/ocri/reference_image_file.h"
#include "oc_core/ocri/resample.h"
#include "oc_core/ocri/view_holes.h"

namespace ocelli {
namespace {

struct ResampleChoice {
  std::string image;
  std::string view;
  std::string size;
  std::string holes = "mark";
  std::string output;
};

std::string describe(const ResampledView& view) {
  std::string text = fmt::format(
      "{}; {:.2f} % holes", view.isWarped ? "samples warped by their depth" : "rays looked up", 100 * view.holes());
  if (view.coarse > 0) {
    text += fmt::format("; the image has fewer samples than {:.2f} % of the pixels ask for, {:.3f} for each at least",
                        100 * view.coarse, view.leastRate);
  }
  return text;
}

void resampleImage(const ResampleChoice& choice, const CommandContext& context) {
  checkWritable(choice.output);
  const ReferenceImages images = readReferenceImages(choice.image);
  const ReferenceImage& first = images.front();
  const ImageSize size =
      choice.size.empty() ? ImageSize{first.width(), first.height()} : imageSizeFromText(choice.size, "--size");
  const PinholeCamera camera(choice.view.empty() ? first.view : readViewOption(choice.view), size.width, size.height);
  ResampledView view = resample(images, camera);
  if (choice.holes == "fill") {
    fillHoles(view);
  } else {
    markHoles(view);
  }
  writePng(choice.output, srgbFromLinear(view.color));
  context.note(fmt::format("wrote {} of {}x{}: {}", choice.output, size.width, size.height, describe(view)));
}

}  // namespace

void addResampleCommand(CLI::App& program, const CommandContext& context) {
  CLI::App& command = *program.add_subcommand(
      "resample", "Make conventional pictures from a reference image: turned, zoomed, and from beside its eye");
  const auto choice = std::make_shared<ResampleChoice>();
  command.add_option("IMAGE", choice->image, "An EXR file that `ocelli render` or `ocelli ocri build` wrote")
      ->required()
      ->type_name("FILE.exr");
  command
      .add_option("--view", choice->view,
                  "Where the eye is, where it looks, and how wide, as a JSON file; that of the image where not given. "
                  "From the image's own eye rays are looked up, from elsewhere samples are warped by their depth")
      ->type_name("FILE.json");
  command.add_option("--size", choice->size, "Size of the picture in pixels; that of the image where not given")
      ->type_name("WIDTHxHEIGHT");
  command
      .add_option("--holes", choice->holes,
                  "What to do where the image knows nothing: mark in magenta, or fill from what lies around, the "
                  "farther first")
      ->check(CLI::IsMember({"mark", "fill"}))
      ->capture_default_str();
  addOutputOption(command, choice->output, "Where the picture goes", {".png"});
  context.finish(command,
                 "  ocelli render builtin:statues --camera gpc -o statues.exr\n"
                 "  ocelli resample statues.exr --view closer.json -o closer.png\n"
                 "  ocelli resample statues.exr --view beside.json --holes fill -o beside.png",
                 [choice, context] { resampleImage(*choice, context); });
}

}  // namespace ocelli
