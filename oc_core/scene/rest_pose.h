// Skins and morph targets of files that stand still.
#pragma once

#include "oc_core/scene/scene_record.h"

namespace ocelli {

/// Moves the vertices of copies whose mesh has bones, or morph targets with weights, to where the rig has them at rest.
/// Each such copy gets a mesh of its own, at the end; meshes without copies become empty, and the rig is gone.
void poseAtRest(SceneRecord& record);

}  // namespace ocelli
