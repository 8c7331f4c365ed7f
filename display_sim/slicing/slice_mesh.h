// A mesh made ready for the fast slicer (slicer.h): cut into chunks of triangles whose vertices lie together, so that a
// chunk is sliced without leaving the CPU's cache. Made once; vertices may then move, frame after frame.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "oc_core/scene/mesh.h"

namespace ocelli {

/// Light is counted in steps of 1 / kLightSteps.
inline constexpr int kLightSteps = 1 << 15;

/// The same mesh with neighbours in space one after the other, triangles and vertices, without vertices of no triangle.
/// Makes slicing several times faster where the order is random; worth it for what is sliced often.
Mesh orderedForSlicing(const Mesh& mesh);
/// The triangles of the mesh alone in that order, for vertices that stay where they are in its arrays.
std::vector<glm::uvec3> trianglesForSlicing(const Mesh& mesh);

/// Triangles and vertices first, first + 1, ... of the mesh's arrays.
struct SliceChunk {
  uint32_t firstVertex = 0;
  uint32_t vertices = 0;
  uint32_t firstTriangle = 0;
  uint32_t triangles = 0;
  uint32_t version = 0;  ///< changes whenever a vertex of it moves, or changes its colour
};

class SliceMesh {
 public:
  static constexpr size_t kChunkTriangles = 4096;
  static constexpr size_t kChunkVertices = 3 * kChunkTriangles;
  /// Arrays of vertices go on for so many elements more than there are, for those who read whole vectors.
  static constexpr size_t kPadding = 64;
  static_assert(kChunkVertices <= 1 << 16, "a corner is a vertex of its chunk in 16 bits");

  /// `mesh` is validated, its positions in display radii.
  explicit SliceMesh(const Mesh& mesh);

  /// New places for the vertices of the mesh that this was made from, in its order; as many as it had.
  void setPositions(std::span<const glm::vec3> positions);
  /// New colours for them; as many, or none, which stands for white.
  void setColors(std::span<const glm::vec3> colors);

  size_t triangleCount() const { return corners_.size() / 3; }
  std::span<const SliceChunk> chunks() const { return chunks_; }

  /// Coordinates of vertices, in display radii.
  const float* x() const { return x_.data(); }
  const float* y() const { return y_.data(); }
  const float* z() const { return z_.data(); }
  /// Whether all vertices are white; then there are no colours.
  bool white() const { return red_.empty(); }
  /// Linear light of vertices, whole numbers from 0 to kLightSteps. Only what is 0 in the mesh is 0 here.
  const float* red() const { return red_.data(); }
  const float* green() const { return green_.data(); }
  const float* blue() const { return blue_.data(); }
  /// Three for each triangle: vertices counted from their chunk's first.
  const uint16_t* corners() const { return corners_.data(); }

  /// Of a vertex of a chunk.
  glm::vec3 position(size_t vertex) const { return {x_[vertex], y_[vertex], z_[vertex]}; }
  glm::vec3 color(size_t vertex) const;

 private:
  class Builder;

  std::vector<SliceChunk> chunks_;
  std::vector<uint32_t> sources_;  ///< of each vertex: which one of the mesh it copies
  size_t sourceCount_ = 0;
  std::vector<uint16_t> corners_;
  std::vector<float> x_;
  std::vector<float> y_;
  std::vector<float> z_;
  std::vector<float> red_;
  std::vector<float> green_;
  std::vector<float> blue_;
};

}  // namespace ocelli
