// A state of the viewer with a small volume whose transfer function's pane is active.
#pragma once

#include "display_sim/viewer/transfer_choice.h"

namespace ocelli::test {

inline constexpr const char* kSmallVolume = "builtin:volume,name=marschner-lobb";

/// 2 x 2 x 2 voxels of the values 0 to 100, mostly 0.
inline LoadedVolume eightVoxels() {
  VolumeGrid grid;
  grid.size = glm::ivec3(2);
  auto volume = std::make_shared<const ScalarVolume>(grid, std::vector<float>{0, 0, 0, 0, 0, 25, 50, 100});
  VolumeHistogram histogram = histogramOf(*volume);
  VolumeScene scene{
      .volume = std::move(volume),
      .appearance = {TransferFunction({{0, {0, 0, 1}, 0}, {50, {0, 1, 0}, 0.5}, {100, {1, 0, 0}, 1}}, 1)}};
  return {std::move(scene), std::move(histogram)};
}

inline ViewerState transferState() {
  ViewerState state = viewerState(kSmallVolume, {}, cameraChoice("di"), View{}, 64, 48, "test");
  takeVolume(state, eightVoxels());
  state.active = Pane::kTransfer;
  return state;
}

}  // namespace ocelli::test
