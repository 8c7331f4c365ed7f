#include "cli/scene_notes.h"

#include "display_sim/display_bounds.h"
#include "oc_core/scene/scene_light.h"

namespace ocelli {

void noteBlackScene(const Frame& frame, const Mesh& mesh) {
  if (isBlack(mesh)) {
    frame.note(
        "all of the scene is black: pictures of it are too, and a display that emits light shows nothing of it; give "
        "it colours at its vertices or in its materials");
  }
}

void noteSlicedScene(const Frame& frame, const Mesh& mesh, const DisplayProfile& profile) {
  noteBlackScene(frame, mesh);
  if (!liesWithin(mesh, profile)) {
    noteCutOffScene(frame);
  }
}

void noteCutOffScene(const Frame& frame) {
  frame.note("a part of the scene lies outside of the display and is cut off");
}

void noteDarkVolume(const Frame& frame, const Volume& volume) {
  if (volume.litVoxels() == 0) {
    frame.note("no voxel of the volume is lit: nothing of it shows");
  }
}

}  // namespace ocelli
