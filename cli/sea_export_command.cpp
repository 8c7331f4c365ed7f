// `ocelli sea export`: seas as files of other programs.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/scene_options.h"
#include "cli/sea_command.h"
#include "cli/sea_miv_export.h"
#include "oc_core/base/error.h"
#include "oc_core/sea/sea_folder.h"
#include "oc_core/sea_page/sea_page.h"

namespace ocelli {
namespace {

struct SeaExportChoice {
  std::string file;
  std::string folder;
  std::string page;
  int every = 1;
  std::string miv;
  std::optional<double> metre;
};

/// A box around the proxy, where it holds all places: what a page warps by.
std::optional<Box> boxOfProxy(const SeaFile& sea, const std::vector<SeaPagePlace>& places) {
  const Box box = boundsOf(sea.proxy().mesh());
  const bool holdsAll = !box.empty() && std::ranges::all_of(places, [&](const SeaPagePlace& place) {
    return contains(box, glm::vec3(place.eye));
  });
  return holdsAll ? std::optional(box) : std::nullopt;
}

void writePage(const SeaFile& sea, const SeaExportChoice& choice, const CommandContext& context) {
  if (sea.settings().projection.kind != SeaProjectionKind::kPanorama) {
    throw InputError("a page shows images of all directions, and those of this sea are of pinholes", choice.file,
                     "export it with --folder");
  }
  SeaPage page;
  page.title = std::filesystem::path(choice.file).stem().string();
  std::vector<uint32_t> images;
  for (uint32_t image = 0; image < sea.count(); image += static_cast<uint32_t>(choice.every)) {
    const SeaPose pose = sea.pose(image);
    images.push_back(image);
    page.places.push_back(
        {pose.position, pose.worldFromCamera * glm::dvec3(0, 0, -1), pose.worldFromCamera * glm::dvec3(0, 1, 0)});
  }
  page.proxy = boxOfProxy(sea, page.places);
  writeSeaPage(
      page,
      [&](size_t place) {
        sea.release();
        return sea.image(images[place]);
      },
      choice.page, context.progress());
  context.clearProgress();
  context.note(fmt::format("wrote {} images and the page {}", images.size(),
                           (std::filesystem::path(choice.page) / "index.html").string()));
}

void runExport(const SeaExportChoice& choice, const CommandContext& context) {
  const auto ways =
      std::ranges::count(std::array{choice.folder.empty(), choice.page.empty(), choice.miv.empty()}, false);
  if (ways != 1) {
    throw InputError("it is not said as what the sea is written, or said twice", "sea export",
                     "give one of --folder, --page and --miv");
  }
  if (choice.every != 1 && choice.page.empty()) {
    throw InputError("only pages leave images out", "--every", "leave it out, or give --page");
  }
  if (choice.metre && choice.miv.empty()) {
    throw InputError("only --miv asks for metres", "--metre", "leave it out, or give --miv");
  }
  if (!choice.miv.empty()) {
    exportMiv(choice.file, choice.miv, choice.metre.value_or(1), context);
    return;
  }
  const SeaFile sea(choice.file);
  if (!choice.page.empty()) {
    writePage(sea, choice, context);
    return;
  }
  writeSeaFolder(sea, choice.folder, context.progress());
  context.clearProgress();
  context.note("wrote " + std::to_string(sea.count()) + " images, their places and the proxy to " + choice.folder);
}

}  // namespace

void addSeaExportCommand(CLI::App& sea, const CommandContext& context) {
  CLI::App& command = *sea.add_subcommand("export", "Write a sea as files of other programs");
  const auto choice = std::make_shared<SeaExportChoice>();
  command.add_option("SEA", choice->file, "The sea; of --miv a folder of views with depth")
      ->required()
      ->type_name("FILE.sea|FOLDER");
  command
      .add_option("--folder", choice->folder,
                  "Its images as PNG, a table of their places and the proxy, in a folder that is made")
      ->type_name("FOLDER");
  command
      .add_option("--page", choice->page,
                  "A page that walks through it in a browser, without a server: open index.html of this folder")
      ->type_name("FOLDER");
  command.add_option("--every", choice->every, "Of a page: take every so many images only")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str()
      ->type_name("N");
  command
      .add_option("--miv", choice->miv,
                  "Raw video and a JSON file of cameras, which MPEG's test model of immersive video reads")
      ->type_name("FOLDER");
  addMetreOption(command, choice->metre);
  command.get_option("--metre")->description(
      "Of --miv: how many units of the views a metre has; 1 where it is not given");
  context.finish(command,
                 "  ocelli sea export museum.sea --folder museum/\n"
                 "  ocelli sea export museum.sea --page walk --every 4\n"
                 "  ocelli sea export views --miv content",
                 [choice, context] { runExport(*choice, context); });
}

}  // namespace ocelli
