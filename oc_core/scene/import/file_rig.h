// The animations of a scene that Assimp has read, with the nodes, bones and morph targets that they move.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "oc_core/scene/scene_record.h"

struct aiNode;
struct aiScene;

namespace ocelli {

/// Nothing where there is no animation that takes some time, and no bone and no morph target. `record` has the parts of
/// the scene's meshes, one each, and the copies of them; `instanceNodes` are the nodes of these.
///
/// What a file says that cannot be is left out, so that the rest plays: keys and weights that are no numbers, keys that
/// do not go forward in time, bones and channels of nodes that are not there. Weights are scaled so that their sum is
/// 1; a node without a key for its position, rotation or scale keeps that of the file. Throws InputError where a node
/// or a bone is placed by what is no number.
///
/// Keys of glTF files are read by gltf_curves.h, all others are Assimp's. Where cubic splines cannot be read (sparse
/// accessors), a warning says that they are straight lines.
std::optional<Rig> readFileRig(const aiScene& scene, const SceneRecord& record,
                               const std::vector<const aiNode*>& instanceNodes, const std::filesystem::path& path);

}  // namespace ocelli
