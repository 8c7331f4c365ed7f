// How the animations of a glTF file go from key to key, which Assimp does not hand over.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <tuple>

namespace ocelli {

/// Of an animation (counted from 0), the name of a node and a path ("translation", "rotation", "scale", "weights"):
/// "STEP" or "CUBICSPLINE". What is not listed is LINEAR.
using GltfInterpolations = std::map<std::tuple<unsigned, std::string, std::string>, std::string>;

/// Reads a .gltf or .glb file (glTF 2.0, sections 3.11 and 4.4). Empty where it cannot be read so.
GltfInterpolations readGltfInterpolations(const std::filesystem::path& path);

}  // namespace ocelli
