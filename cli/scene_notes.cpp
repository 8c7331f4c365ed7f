#include "cli/scene_notes.h"

#include "display_sim/slicing/display_bounds.h"
#include "oc_core/scene/scene_light.h"

namespace ocelli {

void noteBlackScene(const CommandContext& context, const Mesh& mesh) {
  if (isBlack(mesh)) {
    context.note(
        "all of the scene is black: images of it are too, and a display that emits light shows nothing of it; give "
        "it colours at its vertices or in its materials");
  }
}

void noteSlicedScene(const CommandContext& context, const Mesh& mesh, const DisplayProfile& profile) {
  noteBlackScene(context, mesh);
  if (!liesWithin(mesh, profile)) {
    noteCutOffScene(context);
  }
}

void noteCutOffScene(const CommandContext& context) {
  context.note("a part of the scene lies outside of the display and is cut off");
}

void noteDarkVolume(const CommandContext& context, const Volume& volume) {
  if (volume.litVoxels() == 0) {
    context.note("no voxel of the volume is lit: nothing of it shows");
  }
}

}  // namespace ocelli
