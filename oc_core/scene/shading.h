// Simple diffuse shading, baked into vertex colours, so that what is seen later has contrast.
//
// One fixed directional light from the upper right in front, a weak one from the opposite side, and an ambient part:
//
//   shade(n) = kAmbient + (1 - kAmbient) max(0, n.l) + kBack max(0, -n.l)
//
// The weak light keeps triangles of the wrong winding visible, and the ambient part keeps everything above black,
// because black is invisible on an emissive display.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

#include "oc_core/scene/mesh.h"

namespace ocelli {

/// Faces that meet at a sharper angle than this keep separate normals, so that creases stay crisp.
inline constexpr double kCreaseDegrees = 50;

/// To the light, of length 1: l of the formula above.
glm::vec3 directionToLight();

/// The factor of the formula above, in (0, 1], for a unit normal.
float lambertShade(const glm::vec3& normal);

/// Whether two normals of faces, of any length, are closer than that. One without a length goes with any.
bool smoothTogether(const glm::vec3& a, const glm::vec3& b);

/// The normal of a triangle, as long as twice its area; zero where it has none.
glm::vec3 areaNormal(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c);

/// The shade of a sum of normals; 1 where there is none.
float shadeOfSum(const glm::vec3& normalSum);

/// Multiplies the colour of every vertex (white where there is none) with the shade of its normal: the area-weighted
/// mean of the normals of its faces. A vertex on a crease becomes one vertex for each smooth side; the copies stand at
/// the end. Triangles keep their order. Faces without an area leave the shade to their neighbours; a vertex with no
/// other is lit as if it faced the light. `unlit` may say 1 of vertices whose colours stay as they are, otherwise 0.
void bakeLambert(Mesh& mesh, std::span<const uint8_t> unlit = {});

}  // namespace ocelli
