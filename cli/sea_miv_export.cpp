#include "cli/sea_miv_export.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "oc_core/depth_views/depth_views_folder.h"
#include "oc_core/miv/miv_writer.h"

namespace ocelli {
namespace {

namespace fs = std::filesystem;

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

}  // namespace

void exportMiv(const std::string& folder, const std::string& output, double unitsPerMetre,
               const CommandContext& context) {
  MivSequence sequence;
  sequence.content = plainName(fs::absolute(fs::path(output) / "").parent_path().filename().string());
  sequence.unitsPerMetre = unitsPerMetre;
  for (DepthView& view : readDepthViews(folder, context.progress())) {
    sequence.views.push_back(mivViewOf(std::move(view)));
  }
  writeMivSequence(output, sequence, context.progress());
  context.note(
      fmt::format("wrote {} views to {}: {}.json and raw video", sequence.views.size(), output, sequence.content));
}

}  // namespace ocelli
