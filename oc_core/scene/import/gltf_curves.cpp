#include "oc_core/scene/import/gltf_curves.h"

#include <optional>
#include <utility>

#include "oc_core/scene/import/gltf_file.h"

namespace ocelli {
namespace {

/// Assimp calls a node without a name by its number.
std::string nameOfNode(const GltfFile& file, const GltfJson& index) {
  const std::string name = gltfText(gltfMember(file.element("nodes", index), "name"));
  return name.empty() && index.is_number_unsigned() ? "nodes[" + std::to_string(index.get<uint64_t>()) + "]" : name;
}

GltfCurve curveOf(GltfFile& file, const GltfJson& sampler) {
  GltfCurve curve;
  curve.interpolation = gltfText(gltfMember(sampler, "interpolation"));
  std::optional<std::vector<float>> times = file.numbers(gltfMember(sampler, "input"));
  std::optional<std::vector<float>> keys = file.numbers(gltfMember(sampler, "output"));
  if (!times || !keys) {
    return curve;
  }
  const size_t lists = times->size() * (curve.interpolation == "CUBICSPLINE" ? 3 : 1);
  if (keys->size() % lists != 0) {
    return curve;
  }
  curve.width = static_cast<uint32_t>(keys->size() / lists);
  curve.times = std::move(*times);
  curve.keys = std::move(*keys);
  return curve;
}

}  // namespace

GltfCurves readGltfCurves(const std::filesystem::path& path) {
  GltfFile file(path);
  GltfCurves found;
  unsigned number = 0;
  for (const GltfJson& animation : gltfMember(file.json(), "animations")) {
    for (const GltfJson& channel : gltfMember(animation, "channels")) {
      const GltfJson& sampler = gltfElement(gltfMember(animation, "samplers"), gltfMember(channel, "sampler"));
      const GltfJson& target = gltfMember(channel, "target");
      const std::string node = nameOfNode(file, gltfMember(target, "node"));
      if (sampler.is_object()) {
        found[{number, node, gltfText(gltfMember(target, "path"))}] = curveOf(file, sampler);
      }
    }
    ++number;
  }
  return found;
}

}  // namespace ocelli
