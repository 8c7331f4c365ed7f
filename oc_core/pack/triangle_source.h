// Where the triangles of a scene come from that need not fit into memory.
#pragma once

#include <functional>

#include "oc_core/scene/mesh.h"

namespace ocelli {

class TriangleSource {
 public:
  virtual ~TriangleSource() = default;

  /// Calls `visit` for each part of the scene, always the same ones in the same order. A part is gone after its call.
  virtual void forEachPart(const std::function<void(const Mesh& part)>& visit) const = 0;
};

/// One mesh, which must outlive it.
class MeshSource final : public TriangleSource {
 public:
  explicit MeshSource(const Mesh& mesh) : mesh_(mesh) {}
  void forEachPart(const std::function<void(const Mesh& part)>& visit) const override { visit(mesh_); }

 private:
  const Mesh& mesh_;
};

}  // namespace ocelli
