// What commands tell of a scene that shows less than its user may expect.
#pragma once

#include "cli/command.h"
#include "display_sim/frames/volume.h"
#include "oc_core/scene/mesh.h"

namespace ocelli {

/// Tells of a scene that is black.
void noteBlackScene(const CommandContext& context, const Mesh& mesh);
/// Tells of a scene that is sliced for this display: where it is black, and where a part of it is cut off.
void noteSlicedScene(const CommandContext& context, const Mesh& mesh, const DisplayProfile& profile);
/// Tells that the display is too small for the scene.
void noteCutOffScene(const CommandContext& context);
/// Tells of a volume in which nothing is lit.
void noteDarkVolume(const CommandContext& context, const Volume& volume);

}  // namespace ocelli
