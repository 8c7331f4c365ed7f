#include "oc_core/render/triangle_part.h"

#include <limits>

#include "oc_core/base/parallel.h"

namespace ocelli {
namespace {

/// The places in [0, count) that `isWanted` holds for, in order.
template <class Predicate>
std::vector<uint32_t> placesWhere(size_t count, const Predicate& isWanted) {
  constexpr size_t kPartChunks = 64;
  std::vector<std::vector<uint32_t>> found(kPartChunks);
  parallelChunks(count, kPartChunks, [&](size_t chunk, size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      if (isWanted(i)) {
        found[chunk].push_back(static_cast<uint32_t>(i));
      }
    }
  });
  std::vector<uint32_t> places;
  for (const std::vector<uint32_t>& part : found) {
    places.insert(places.end(), part.begin(), part.end());
  }
  return places;
}

}  // namespace

TrianglePart selectTriangles(const Mesh& mesh, const PinholeCamera& reference,
                             const std::function<bool(const ImageBox&)>& isWanted) {
  constexpr float kNoImage = std::numeric_limits<float>::infinity();
  std::vector<glm::vec2> images(mesh.positions.size(), glm::vec2(kNoImage));
  parallelFor(images.size(), 1 << 13, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      if (const std::optional<ImagePoint> q = reference.project(mesh.positions[i])) {
        images[i] = {q->u, q->v};
      }
    }
  });
  std::vector<uint32_t> places = placesWhere(mesh.triangles.size(), [&](size_t i) {
    const glm::uvec3& t = mesh.triangles[i];
    const ImageBox box = boxAround(images[t.x], images[t.y], images[t.z]);
    return box.upper.x == kNoImage || isWanted(box);
  });
  constexpr uint32_t kUnused = 0xffffffffu;
  std::vector<uint32_t> newIndex(mesh.positions.size(), kUnused);
  std::vector<uint32_t> oldIndex;
  TrianglePart part;
  part.triangles.reserve(places.size());
  for (const uint32_t place : places) {
    glm::uvec3 kept;
    for (int corner = 0; corner < 3; ++corner) {
      const uint32_t vertex = mesh.triangles[place][corner];
      if (newIndex[vertex] == kUnused) {
        newIndex[vertex] = static_cast<uint32_t>(oldIndex.size());
        oldIndex.push_back(vertex);
      }
      kept[corner] = newIndex[vertex];
    }
    part.triangles.push_back(kept);
  }
  part.points.resize(oldIndex.size());
  parallelFor(oldIndex.size(), 1 << 13, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      part.points[i] = reference.cameraFromWorld(mesh.positions[oldIndex[i]]);
    }
  });
  part.meshTriangles = std::move(places);
  return part;
}

}  // namespace ocelli
