// The proxy of a sea: about what its place is shaped like, by which images are warped into each other (dissertation,
// section 3.5.4.2.2). A dozen polygons do; the closer it is to the surfaces, the less residuals have to say.
#pragma once

#include <glm/vec3.hpp>
#include <memory>
#include <mutex>

#include "oc_core/render/blocked_rays.h"
#include "oc_core/render/raycast.h"
#include "oc_core/scene/mesh.h"

namespace ocelli {

class SeaProxy {
 public:
  /// World coordinates of the sea. A mesh without triangles is a proxy too: everything is far away then.
  explicit SeaProxy(Mesh mesh);

  const Mesh& mesh() const { return *mesh_; }
  /// These are made when the first of them is asked for; any thread may ask.
  const RayScene& rays() const { return structures().rays; }
  const BlockedRays& blocked() const { return structures().blocked; }
  /// Rays that meet nothing are taken to see something at this distance.
  float far() const { return far_; }

 private:
  struct Structures {
    explicit Structures(const Mesh& mesh) : rays(mesh), blocked(mesh) {}

    RayScene rays;
    BlockedRays blocked;
  };
  const Structures& structures() const;

  std::unique_ptr<Mesh> mesh_;  ///< it stays where it is: the structures point to it
  mutable std::once_flag isMade_;
  mutable std::unique_ptr<Structures> structures_;
  float far_ = 1000;
};

}  // namespace ocelli
