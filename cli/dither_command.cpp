// `ocelli dither`: what each dither makes of colours, and how evenly surfaces are lit.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>

#include "cli/command.h"
#include "cli/dither_options.h"
#include "display_sim/dither_score/dither_report.h"
#include "oc_core/base/error.h"

namespace ocelli {
namespace {

struct DitherChoice {
  std::vector<std::string> methods;
  std::string profile = "perspecta";
  int bits = 0;
  std::vector<double> evenLightRadii{0, 0.5, 1};
  bool json = false;
  std::string folder;
};

void run(const DitherChoice& choice, const CommandContext& context) {
  DitherReportOptions options;
  options.profile = loadProfile(choice.profile);
  options.evenLightRadii = choice.evenLightRadii;
  if (choice.bits > 0) {
    options.profile.colorBitsPerChannel = choice.bits;
    if (options.profile.volumeBytes() > kMaxVolumeBytes) {
      throw InputError("a volume of this display would take more than 2 GiB", fmt::format("--bits {}", choice.bits),
                       "take fewer bits, or another --profile");
    }
  }
  if (!choice.folder.empty()) {
    std::error_code error;
    std::filesystem::create_directories(choice.folder, error);
    if (error || !std::filesystem::is_directory(choice.folder)) {
      throw WorkError("cannot make this folder (" + error.message() + ")", choice.folder, "choose another one with -o");
    }
  }
  for (const NamedDither& dither : kNamedDithers) {
    if (choice.methods.empty() || std::ranges::find(choice.methods, dither.name) != choice.methods.end()) {
      options.dithers.push_back(dither);
    }
  }
  const DitherReport report = compareDithers(options, context.progress());
  context.print(choice.json ? jsonOf(report) : textOf(report));
  if (!choice.folder.empty()) {
    writeImages(report, choice.folder);
    context.note("wrote images to " + choice.folder);
  }
}

}  // namespace

void addDitherCommand(CLI::App& program, const CommandContext& context) {
  CLI::App& command = *program.add_subcommand("dither", "Score the dithers, and draw what they make of colours");
  const auto choice = std::make_shared<DitherChoice>();
  command.add_option("--dither", choice->methods, "Only these, separated by commas")
      ->delimiter(',')
      ->check(CLI::IsMember(ditherNames()))
      ->type_name("NAME,...");
  command.add_option("--profile", choice->profile, "The display: a name, or a profile of your own")
      ->type_name("NAME|FILE.json");
  command.add_option("--bits", choice->bits, "Bits a channel, in place of the profile's")
      ->check(CLI::Range(1, 8))
      ->type_name("COUNT");
  command.add_option("--even-light", choice->evenLightRadii, "Radii to even out light within; 0 for not at all")
      ->delimiter(',')
      ->check(radiusCheck())
      ->type_name("RADIUS,...");
  command.add_flag("--json", choice->json, "Print the figures as JSON");
  command.add_option("-o,--output", choice->folder, "A folder for images")->type_name("DIR");
  context.finish(command,
                 "  ocelli dither -o images\n"
                 "  ocelli dither --dither ordered,diffusion --bits 3 --even-light 0",
                 [choice, context] { run(*choice, context); });
}

}  // namespace ocelli
