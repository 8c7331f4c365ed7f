// The proxy of a sea: about what its place is shaped like, by which images are warped into each other (dissertation,
// section 3.5.4.2.2). A dozen polygons do; the closer it is to the surfaces, the less residuals have to say.
#pragma once

#include <glm/vec3.hpp>
#include <memory>

#include "oc_core/render/blocked_rays.h"
#include "oc_core/render/raycast.h"
#include "oc_core/scene/mesh.h"

namespace ocelli {

class SeaProxy {
 public:
  /// World coordinates of the sea. A mesh without triangles is a proxy too: everything is far away then.
  explicit SeaProxy(Mesh mesh);

  const Mesh& mesh() const { return *mesh_; }
  const RayScene& rays() const { return *rays_; }
  const BlockedRays& blocked() const { return *blocked_; }
  /// Rays that meet nothing are taken to see something at this distance.
  float far() const { return far_; }

 private:
  std::unique_ptr<Mesh> mesh_;  ///< it stays where it is: the others point to it
  std::unique_ptr<RayScene> rays_;
  std::unique_ptr<BlockedRays> blocked_;
  float far_ = 1000;
};

}  // namespace ocelli
