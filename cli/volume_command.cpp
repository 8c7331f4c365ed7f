// `ocelli volume`: look into a .svol file, check it, and turn it into files of other programs.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "cli/command.h"
#include "display_sim/export_nrrd.h"
#include "display_sim/export_png.h"
#include "display_sim/export_vti.h"
#include "display_sim/svol_file.h"
#include "oc_core/base/error.h"

namespace ocelli {
namespace {

std::string infoAsText(const std::string& path, const SvolSummary& summary) {
  const DisplayProfile& profile = summary.profile;
  return fmt::format(
      "{}\n  display     {}, radius {:g} m, {:g} rpm, {:g} refreshes a second\n  slices      {} of {}x{}\n"
      "  lit voxels  {}\n  bytes       {} ({:.1f}x compressed)\n",
      path, profile.name, profile.radiusMetres, profile.rotationsPerMinute, profile.refreshHertz(),
      profile.storedSlices(), profile.width, profile.height, summary.litVoxels, summary.fileBytes,
      static_cast<double>(summary.planeBytesTotal) / static_cast<double>(summary.fileBytes));
}

std::string infoAsJson(const SvolSummary& summary) {
  const nlohmann::ordered_json json = {{"profile", nlohmann::ordered_json::parse(jsonText(summary.profile))},
                                       {"slices", summary.profile.storedSlices()},
                                       {"lit_voxels", summary.litVoxels},
                                       {"file_bytes", summary.fileBytes},
                                       {"plane_bytes", summary.planeBytesTotal}};
  return json.dump(2) + "\n";
}

void addInfo(CLI::App& parent, const Frame& frame) {
  CLI::App& command = *parent.add_subcommand("info", "Show a volume's display and count its lit voxels");
  const auto path = std::make_shared<std::string>();
  const auto asJson = std::make_shared<bool>(false);
  command.add_option("VOLUME", *path, "A volume (.svol)")->required();
  command.add_flag("--json", *asJson, "Print the figures as JSON");
  frame.finish(command, "  ocelli volume info teapot.svol", [path, asJson, frame] {
    const SvolSummary summary = verifySvol(*path);
    frame.print(*asJson ? infoAsJson(summary) : infoAsText(*path, summary));
  });
}

void addVerify(CLI::App& parent, const Frame& frame) {
  CLI::App& command = *parent.add_subcommand("verify", "Check every byte of a volume; exit code 2 if it is damaged");
  const auto path = std::make_shared<std::string>();
  command.add_option("VOLUME", *path, "A volume (.svol)")->required();
  frame.finish(command, "  ocelli volume verify teapot.svol", [path, frame] {
    const SvolSummary summary = verifySvol(*path);
    frame.print(fmt::format("{}: all {} slices are whole\n", *path, summary.profile.storedSlices()));
  });
}

struct ExportChoice {
  std::string volume;
  std::string output;
  VtiOptions vti;
};

void runExport(const ExportChoice& choice, const Frame& frame) {
  const std::string extension = std::filesystem::path(choice.output).extension();
  if (extension != ".vti" && extension != ".nrrd" && !extension.empty() &&
      !std::filesystem::is_directory(choice.output)) {
    throw InputError("volumes have no form with this ending", choice.output,
                     "a name that ends in .vti or .nrrd, or a folder for PNG files");
  }
  const Volume volume = readSvol(choice.volume);
  if (extension == ".vti") {
    exportVti(choice.output, volume, choice.vti, frame.progress());
  } else if (extension == ".nrrd") {
    exportNrrd(choice.output, volume, frame.progress());
  } else {
    exportPngStack(choice.output, volume, frame.progress());
  }
  frame.note(fmt::format("wrote {}", choice.output));
}

void addExport(CLI::App& parent, const Frame& frame) {
  CLI::App& command = *parent.add_subcommand("export", "Write a volume for ParaView, as NRRD, or as PNG files");
  const auto choice = std::make_shared<ExportChoice>();
  command.add_option("VOLUME", choice->volume, "A volume (.svol)")->required();
  command.add_option("-o,--output", choice->output, "A file, or a folder that gets a PNG file for each slice")
      ->required()
      ->type_name("OUT.vti|OUT.nrrd|DIR");
  command.add_option("--cells", choice->vti.cellsAcross, "Cells of a .vti across the display")->type_name("COUNT");
  frame.finish(command,
               "  ocelli volume export teapot.svol -o slices\n"
               "  ocelli volume export teapot.svol --cells 512 -o teapot.vti",
               [choice, frame] { runExport(*choice, frame); });
}

}  // namespace

void addVolumeCommand(CLI::App& program, const Frame& frame) {
  CLI::App& command = *program.add_subcommand("volume", "Look into a .svol file, check it, export it");
  command.require_subcommand(1);
  addInfo(command, frame);
  addVerify(command, frame);
  addExport(command, frame);
}

}  // namespace ocelli
