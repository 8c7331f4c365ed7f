#include "oc_core/scene/rigged_loose_parts.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <iterator>
#include <map>
#include <utility>

#include "oc_core/base/check.h"
#include "oc_core/scene/loose_parts.h"

namespace ocelli {
namespace {

/// How a copy stands at rest.
struct RestingCopy {
  std::vector<glm::mat4> worldFromBone;
  std::vector<float> weights;        ///< of the morphs
  std::vector<glm::vec3> positions;  ///< in the world, of the vertices that the file has
};

class LooseRigger {
 public:
  explicit LooseRigger(SceneRecord& record)
      : record_(record), worldFromNode_(worldFromNodes(*record.rig, RigAnimation{}, 0)) {
    for (size_t i = 0; i < record.instances.size(); ++i) {
      copies_.push_back(restingCopy(i));
    }
  }

  const glm::vec3& place(size_t instance, uint32_t vertex) const {
    const TexturedMesh& part = record_.parts[record_.instances[instance].mesh];
    const std::vector<glm::vec3>& positions = copies_[instance].positions;
    if (vertex < positions.size()) {
      return positions[vertex];
    }
    // Baking has put it on an edge; for the size of the scene one of its ends will do.
    return place(instance, part.added[vertex - positions.size()].low);
  }

  /// A copy of its own for each that has some of the mesh.
  void add(const LooseMesh& loose) {
    std::map<uint32_t, std::vector<uint32_t>> verticesOf;
    std::vector<uint32_t> places(loose.origins.size());
    for (uint32_t v = 0; v < loose.origins.size(); ++v) {
      std::vector<uint32_t>& vertices = verticesOf[loose.origins[v].instance];
      places[v] = static_cast<uint32_t>(vertices.size());
      vertices.push_back(v);
    }
    std::map<uint32_t, size_t> partOf;
    for (const auto& [instance, vertices] : verticesOf) {
      partOf[instance] = record_.parts.size();
      addPart(loose, instance, vertices);
    }
    for (const glm::uvec3& t : loose.mesh.triangles) {
      const uint32_t instance = loose.origins[t.x].instance;
      const glm::uvec3 placed(places[t.x], places[t.y], places[t.z]);
      // Who plays it turns the triangles of mirrored copies round; these are as they must be.
      const bool mirrored = glm::determinant(glm::mat3(record_.instances[instance].worldFromMesh)) < 0;
      record_.parts[partOf[instance]].mesh.triangles.push_back(mirrored ? glm::uvec3(placed.x, placed.z, placed.y)
                                                                        : placed);
    }
  }

 private:
  RestingCopy restingCopy(size_t instance) const {
    const Instance& copy = record_.instances[instance];
    const RigPart& part = record_.rig->parts[copy.mesh];
    const TexturedMesh& mesh = record_.parts[copy.mesh];
    RestingCopy resting;
    for (const RigBone& bone : part.bones) {
      resting.worldFromBone.push_back(worldFromNode_[bone.node] * bone.boneFromMesh);
    }
    std::ranges::transform(part.morphs, std::back_inserter(resting.weights), &RigMorph::weight);
    const std::vector<glm::vec3> bound(mesh.mesh.positions.begin(),
                                       mesh.mesh.positions.end() - static_cast<ptrdiff_t>(mesh.added.size()));
    skin(part, bound, worldFromNode_, worldFromNode_[record_.rig->instanceNodes[instance]], resting.weights,
         resting.positions);
    return resting;
  }

  /// What moves a vertex at rest.
  glm::mat4 worldFromVertex(uint32_t instance, uint32_t vertex) const {
    const RigPart& part = record_.rig->parts[record_.instances[instance].mesh];
    const uint32_t first = part.first.empty() ? 0 : part.first[vertex];
    const uint32_t last = part.first.empty() ? 0 : part.first[vertex + 1];
    if (first == last) {
      return worldFromNode_[record_.rig->instanceNodes[instance]];
    }
    glm::mat4 sum(0);
    for (uint32_t i = first; i < last; ++i) {
      sum += part.weights[i].weight * copies_[instance].worldFromBone[part.weights[i].bone];
    }
    return sum;
  }

  /// Without its triangles.
  void addPart(const LooseMesh& loose, uint32_t instance, const std::vector<uint32_t>& vertices) {
    const size_t source = record_.instances[instance].mesh;
    const RigPart& from = record_.rig->parts[source];
    TexturedMesh part;
    part.isUnlit = record_.parts[source].isUnlit;
    RigPart rigged;
    rigged.bones = from.bones;
    if (!from.first.empty()) {
      rigged.first.push_back(0);
    }
    for (const RigMorph& morph : from.morphs) {
      rigged.morphs.push_back({{}, morph.weight});
    }
    for (const uint32_t v : vertices) {
      const uint32_t vertex = loose.origins[v].vertex;
      const glm::vec3 offset = loose.mesh.positions[v] - copies_[instance].positions[vertex];
      part.mesh.positions.push_back(record_.parts[source].mesh.positions[vertex] + bound(instance, vertex, offset));
      part.mesh.colors.push_back(loose.mesh.color(v));
      if (!from.first.empty()) {
        rigged.weights.insert(rigged.weights.end(), from.weights.begin() + from.first[vertex],
                              from.weights.begin() + from.first[vertex + 1]);
        rigged.first.push_back(static_cast<uint32_t>(rigged.weights.size()));
      }
      for (size_t i = 0; i < from.morphs.size(); ++i) {
        rigged.morphs[i].offsets.push_back(from.morphs[i].offsets[vertex]);
      }
    }
    record_.instances.push_back({record_.parts.size(), record_.instances[instance].worldFromMesh});
    record_.rig->instanceNodes.push_back(record_.rig->instanceNodes[instance]);
    record_.parts.push_back(std::move(part));
    record_.rig->parts.push_back(std::move(rigged));
  }

  /// The offset from a vertex of the mesh that is `inWorld` at rest.
  glm::vec3 bound(uint32_t instance, uint32_t vertex, const glm::vec3& inWorld) const {
    const glm::mat3 linear(worldFromVertex(instance, vertex));
    // Relative to the size of its columns: below this, an inverse is mostly rounding.
    constexpr float kFlat = 1e-6f;
    const float size = std::max({glm::length(linear[0]), glm::length(linear[1]), glm::length(linear[2])});
    return std::abs(glm::determinant(linear)) > kFlat * size * size * size ? glm::inverse(linear) * inWorld : inWorld;
  }

  SceneRecord& record_;
  std::vector<glm::mat4> worldFromNode_;
  std::vector<RestingCopy> copies_;
};

}  // namespace

std::optional<PointFacts> addRiggedLooseParts(SceneRecord& record, const PointSceneOptions& options,
                                              const std::string& where, std::vector<std::string>& warnings,
                                              const Progress& progress) {
  OC_CHECK(record.rig.has_value(), "a rig moves them");
  if (std::ranges::none_of(record.instances, [&](const Instance& copy) {
        return !record.parts[copy.mesh].lines.empty() || !record.parts[copy.mesh].points.empty();
      })) {
    return std::nullopt;
  }
  LooseRigger rigger(record);
  std::vector<Instance> instances = record.instances;
  for (Instance& instance : instances) {
    instance.isLit = !record.parts[instance.mesh].isUnlit;
  }
  const LooseParts loose = makeLooseParts(
      instances, record.parts, [&](size_t instance, uint32_t vertex) { return rigger.place(instance, vertex); },
      options, where, progress);
  for (const LooseMesh& each : loose.meshes) {
    rigger.add(each);
  }
  warnings.insert(warnings.end(), loose.warnings.begin(), loose.warnings.end());
  return loose.facts;
}

}  // namespace ocelli
