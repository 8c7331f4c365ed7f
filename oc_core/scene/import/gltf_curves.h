// The keys of a glTF file's animations as the file has them. Assimp leaves out how they go from key to key and the
// tangents of cubic splines, mixes up the keys of weights along these, has no weights below 0, and takes whole numbers
// for what they are not.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <tuple>
#include <vector>

namespace ocelli {

/// What moves one property of a node.
struct GltfCurve {
  std::string interpolation;  ///< "LINEAR", "STEP" or "CUBICSPLINE"
  std::vector<float> times;
  /// Of each time: its values; of a cubic spline the tangent before it, the values, and the tangent after it. Empty
  /// where GltfFile cannot read them.
  std::vector<float> keys;
  uint32_t width = 0;  ///< values of a key; 0 where there are no keys
};

/// By the animation (counted from 0), the name that Assimp gives the node, and the path ("translation", "rotation",
/// "scale", "weights").
using GltfCurves = std::map<std::tuple<unsigned, std::string, std::string>, GltfCurve>;

/// Reads a .gltf or .glb file (glTF 2.0, section 3.11). Empty where it cannot be read so.
GltfCurves readGltfCurves(const std::filesystem::path& path);

}  // namespace ocelli
