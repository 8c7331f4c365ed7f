// What depth images stand for where the rays of one object go: what is cast, mirrors that are cast among it, and what
// of it sends rays on once more (section 3.5.2.3.1: second-order rays, by normals that depth images hold).
//
// DEVIATION: the text has one depth image an object that is reflected. Here each object that sends rays has images of
// its own, of all that is cast but itself: so mirrors are seen in each other, and a ray meets no sample of the mirror
// that it comes from.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "oc_core/shade/shaded_scene.h"

namespace ocelli {

struct CastObjects {
  std::shared_ptr<const Mesh> mesh;  ///< that of the scene where no mirror is cast
  /// Of each vertex: the normal of a mirror, of the length 2^i for ShadedScene::mirrors[i], so that a reference image
  /// can hold it in the place of a colour; 0 for what does not mirror. Empty where nothing does. The lengths are a
  /// factor apart, since interpolation between normals that differ shortens them by one.
  std::vector<glm::vec3> mirrorNormals = {};
};

/// Without `sender`, where that is one of the mirrors. Throws InputError for more than kMaxCastMirrors.
inline constexpr size_t kMaxCastMirrors = 64;

/// Without `sender`, where that is one of the mirrors. The scene must outlive what this gives. Throws InputError for
/// more than kMaxCastMirrors.
CastObjects castObjects(const ShadedScene& scene, const SpecularObject* sender);

/// A mirror that a ray has met.
struct MetMirror {
  uint32_t mirror = 0;  ///< its number in ShadedScene::mirrors
  glm::vec3 normal{0};  ///< unit
};

/// From a mirror normal, interpolated between vertices or samples; nothing where it is of no mirror.
std::optional<MetMirror> metMirror(const glm::vec3& mirrorNormal);

/// `direction` reflected at it, whatever side the normal is on; unit.
glm::vec3 reflectedAt(const MetMirror& met, const glm::vec3& direction);

}  // namespace ocelli
