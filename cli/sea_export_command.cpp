#include "cli/sea_export_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>

#include "cli/scene_options.h"
#include "oc_core/base/error.h"
#include "oc_core/depth_views/depth_views_folder.h"
#include "oc_core/miv/miv_writer.h"

namespace ocelli {
namespace {

namespace fs = std::filesystem;

struct SeaExportChoice {
  std::string folder;
  std::string miv;
  std::optional<double> metre;
};

/// Without what is no part of the names of such files.
std::string plainName(std::string name) {
  std::replace_if(
      name.begin(), name.end(),
      [](char c) {
        return !((c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-' || c == '_');
      },
      '_');
  return name;
}

MivView mivViewOf(DepthView view) {
  return {plainName(view.name), view.image.view, view.image.isPlaced(), std::move(view.image.color),
          std::move(view.image.t)};
}

void runSeaExport(const SeaExportChoice& choice, const CommandContext& context) {
  MivSequence sequence;
  sequence.content = plainName(fs::absolute(fs::path(choice.miv) / "").parent_path().filename().string());
  sequence.unitsPerMetre = choice.metre.value_or(1);
  for (DepthView& view : readDepthViews(choice.folder, context.progress())) {
    sequence.views.push_back(mivViewOf(std::move(view)));
  }
  writeMivSequence(choice.miv, sequence, context.progress());
  context.note(
      fmt::format("wrote {} views to {}: {}.json and raw video", sequence.views.size(), choice.miv, sequence.content));
}

}  // namespace

void addSeaExportCommand(CLI::App& sea, const CommandContext& context) {
  CLI::App& command =
      *sea.add_subcommand("export", "Write views with depth for the test model of MPEG immersive video");
  const auto choice = std::make_shared<SeaExportChoice>();
  command.add_option("FOLDER", choice->folder, "Views with depth, as ocelli ocri build --from takes them")->required();
  command.add_option("--miv", choice->miv, "Folder for raw video and the JSON file of cameras")
      ->required()
      ->type_name("OUT");
  addMetreOption(command, choice->metre);
  command.get_option("--metre")->description("How many units of the views a metre has; 1 where it is not given");
  context.finish(command,
                 "  ocelli sea export views --miv content\n"
                 "  ocelli sea export views --metre 10 --miv content",
                 [choice, context] { runSeaExport(*choice, context); });
}

}  // namespace ocelli
