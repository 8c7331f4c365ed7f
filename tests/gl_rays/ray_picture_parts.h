// Scenes of `ocelli shade` as pictures on the GPU take them, and how far two pictures are apart.
#pragma once

#include <algorithm>
#include <vector>

#include "oc_core/gl_rays/gl_ray_picture.h"
#include "oc_core/image/png_file.h"
#include "oc_core/shade/shaded_scene.h"

namespace ocelli::test {

/// All that is seen at once but the objects that send rays on.
inline Mesh directPart(const ShadedScene& scene, const std::vector<SpecularObject>& senders) {
  Mesh direct;
  for (const Mesh* part : {&scene.cast, &scene.billboards, &scene.surroundings}) {
    append(direct, *part);
  }
  for (const std::vector<SpecularObject>* all : {&scene.mirrors, &scene.lenses}) {
    for (const SpecularObject& object : *all) {
      if (all != &senders) {
        append(direct, object.mesh);
      }
    }
  }
  return direct;
}

/// All mirrors as one.
struct MirrorMesh {
  explicit MirrorMesh(const std::vector<SpecularObject>& mirrors) {
    for (const SpecularObject& mirror : mirrors) {
      append(mesh, mirror.mesh);
      normals.insert(normals.end(), mirror.normals.begin(), mirror.normals.end());
    }
  }
  Mesh mesh;
  std::vector<glm::vec3> normals;
};

/// A picture that GlRayPicture makes; each of its pixels is opaque.
Image<glm::vec3> readPicture(GlContext& context, const GlObject& picture, const PinholeCamera& camera);

/// Pixels whose colours differ by more than one level of 255, which is rounding.
inline size_t differingPixels(const Image<glm::vec3>& a, const Image<glm::vec3>& b) {
  const Image<Rgb8> p = srgbFromLinear(a);
  const Image<Rgb8> q = srgbFromLinear(b);
  size_t differing = 0;
  for (size_t i = 0; i < p.size(); ++i) {
    const glm::ivec3 step = glm::abs(glm::ivec3(p[i]) - glm::ivec3(q[i]));
    differing += std::max({step.x, step.y, step.z}) > 1;
  }
  return differing;
}

}  // namespace ocelli::test
