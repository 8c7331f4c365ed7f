// A mesh in the memory of the GPU, uploaded once; its vertices can move.
#pragma once

#include <span>

#include "oc_core/gl/gl_object.h"
#include "oc_core/scene/mesh.h"

namespace ocelli {

class GlMesh {
 public:
  /// Throws GlError where the GPU has no room. Hold a GlScope.
  GlMesh(GlContext& context, const Mesh& mesh);

  /// So many vertices from `first` on stand elsewhere now. Hold a GlScope.
  void move(size_t first, std::span<const glm::vec3> positions) const;

  /// Tightly packed: three floats a vertex, three floats a vertex (linear RGB, white where the mesh has none), three
  /// indices (uint32) a triangle.
  const GlObject& positions() const { return positions_; }
  const GlObject& colors() const { return colors_; }
  const GlObject& triangles() const { return triangles_; }
  size_t vertexCount() const { return vertexCount_; }
  size_t triangleCount() const { return triangleCount_; }

  /// A vertex array for glDrawElements(): location 0 is the position, location 1 the colour. Location kDrawNumber is
  /// for a whole number an instance: a pass that needs it binds its buffer, enables it, and disables it again.
  const GlObject& vertexArray() const { return vertexArray_; }
  static constexpr uint32_t kDrawNumber = 2;

 private:
  GlContext* context_;
  size_t vertexCount_;
  size_t triangleCount_;
  GlObject positions_;
  GlObject colors_;
  GlObject triangles_;
  GlObject vertexArray_;
};

}  // namespace ocelli
