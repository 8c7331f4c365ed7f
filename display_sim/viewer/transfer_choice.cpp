#include "display_sim/viewer/transfer_choice.h"

#include <algorithm>

#include "oc_core/base/error.h"
#include "oc_core/volume/transfer_presets.h"

namespace ocelli {
namespace {

/// All values of the volume and of the points.
ValueAxis axisFor(const LoadedVolume& volume, const TransferEditor& editor) {
  const ValueRange& bounds = volume.histogram.bounds;
  return axisBetween(std::min(bounds.least, editor.points().front().value),
                     std::max(bounds.greatest, editor.points().back().value));
}

void requireVolume(bool isThere) {
  if (!isThere) {
    throw InputError("the scene is no volume, so it has no transfer function", "the viewer",
                     "open a volume, such as builtin:volume,name=marschner-lobb");
  }
}

}  // namespace

void takeVolume(ViewerState& state, const LoadedVolume& volume) {
  VolumeShown& shown = state.volume;
  shown = {.on = shown.on, .rays = shown.rays};
  shown.transfer.emplace(volume.scene.appearance);
  state.work.appearance = shown.transfer->appearance();  // with which it was sliced
  state.work.kept = shown.kept;
  shown.values = shown.axis = axisFor(volume, *shown.transfer);
}

void chooseTransfer(ViewerState& state, const LoadedVolume* volume, const std::string& nameOrFile) {
  requireVolume(volume != nullptr && state.volume.transfer);
  VolumeShown& shown = state.volume;
  const VolumeScene& scene = volume->scene;
  shown.transfer->replace(appearanceOf(transferByName(nameOrFile), *scene.volume, scene.voxelSpacing()), true);
  shown.values = shown.axis = axisFor(*volume, *shown.transfer);
}

std::string transferFileText(const ViewerState& state) {
  requireVolume(state.volume.transfer.has_value());
  return transferToJsonText(describe(*state.volume.transfer->appearance()));
}

}  // namespace ocelli
