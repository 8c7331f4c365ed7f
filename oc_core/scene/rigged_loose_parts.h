// Lines and points of a file whose animation plays.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "oc_core/base/progress.h"
#include "oc_core/scene/scene_record.h"

namespace ocelli {

/// Gives the record, whose colours are baked and whose rig is there, further parts and copies for what its copies have
/// besides triangles: the geometry that they are at rest (loose_parts.h), each vertex of which is moved as the vertex
/// of the file that it stands at: by the same node, bones and morph targets. So tubes bend and panels turn with what
/// they are on, and grow with it. Returns what there is of points and lines; nothing where there is none.
///
/// What has no size at rest, as where a node is scaled to 0, has its geometry as if the node did nothing. Throws as
/// makeLooseParts() does; what it warns of goes to `warnings`.
std::optional<PointFacts> addRiggedLooseParts(SceneRecord& record, const PointSceneOptions& options,
                                              const std::string& where, std::vector<std::string>& warnings,
                                              const Progress& progress);

}  // namespace ocelli
