// `ocelli sea export`: seas as files of other programs.
#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "cli/sea_command.h"
#include "oc_core/sea/sea_folder.h"

namespace ocelli {
namespace {

struct SeaExportChoice {
  std::string file;
  std::string folder;
};

void runExport(const SeaExportChoice& choice, const CommandContext& context) {
  const SeaFile sea(choice.file);
  writeSeaFolder(sea, choice.folder, context.progress());
  context.clearProgress();
  context.note("wrote " + std::to_string(sea.count()) + " images, their places and the proxy to " + choice.folder);
}

}  // namespace

void addSeaExportCommand(CLI::App& sea, const CommandContext& context) {
  CLI::App& command = *sea.add_subcommand("export", "Write a sea as files of other programs");
  const auto choice = std::make_shared<SeaExportChoice>();
  command.add_option("SEA", choice->file, "The sea")->required()->type_name("FILE.sea");
  command
      .add_option("--folder", choice->folder,
                  "Its images as PNG, a table of their places and the proxy, in a folder that is made")
      ->required()
      ->type_name("FOLDER");
  context.finish(command, "  ocelli sea export museum.sea --folder museum/",
                 [choice, context] { runExport(*choice, context); });
}

}  // namespace ocelli
