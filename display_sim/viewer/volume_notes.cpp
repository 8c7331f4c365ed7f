#include "display_sim/viewer/volume_notes.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace ocelli {

std::string volumeDetail(const ViewerState& state, const VolumeStatus& status) {
  const std::string name =
      state.volume.rays.empty() ? state.work.camera.name : std::filesystem::path(state.volume.rays).stem().string();
  return status.picture ? fmt::format("{}, {} x {}", name, status.picture->wanted.size.x, status.picture->wanted.size.y)
                        : name;
}

std::vector<std::string> volumeNotes(const ViewerFacts& facts) {
  const VolumeStatus& status = facts.volume;
  if (!status.error.empty()) {
    return {status.error};
  }
  if (!status.picture) {
    return {status.busy || facts.work.busy ? "in the making ..." : "nothing to show"};
  }
  std::string text;
  if (facts.showTimes) {
    text = fmt::format("{:.0f} ms, {:.1f} pictures a second", status.picture->milliseconds,
                       1000 / std::max(status.picture->milliseconds, 1.0));
  }
  if (!status.picture->isWhole) {
    text += text.empty() ? "small while it moves" : " (small while it moves)";
  }
  return text.empty() ? std::vector<std::string>{} : std::vector{text};
}

}  // namespace ocelli
