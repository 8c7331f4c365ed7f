#include "oc_core/antialiasing/antialias_bins.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "oc_core/base/parallel.h"

namespace ocelli {
namespace {

constexpr size_t kChunks = 16;

}  // namespace

ImageBox boxOfTriangle(const ProjectedMesh& projected, const PinholeTriangles& parts, uint32_t triangle) {
  const glm::uvec3& t = projected.mesh().triangles[triangle];
  const ProjectedVertex& a = projected.vertex(t.x);
  const ProjectedVertex& b = projected.vertex(t.y);
  const ProjectedVertex& c = projected.vertex(t.z);
  if (a.inverseZ > 0 && b.inverseZ > 0 && c.inverseZ > 0) {
    return {{std::min({a.u, b.u, c.u}), std::min({a.v, b.v, c.v})},
            {std::max({a.u, b.u, c.u}), std::max({a.v, b.v, c.v})}};
  }
  ImageBox box{glm::vec2(1e30f), glm::vec2(-1e30f)};
  parts.forEachPartAnywhere(triangle, [&](const RasterVertex& p, const RasterVertex& q, const RasterVertex& r) {
    box.lower = glm::min(glm::min(box.lower, {p.u, p.v}), glm::min(glm::vec2(q.u, q.v), {r.u, r.v}));
    box.upper = glm::max(glm::max(box.upper, {p.u, p.v}), glm::max(glm::vec2(q.u, q.v), {r.u, r.v}));
  });
  return box;
}

AntialiasBins::AntialiasBins(const AntialiasView& view, const ProjectedMesh& projected)
    : parts_(projected),
      across_((view.width() + kBlock - 1) / kBlock),
      down_((view.height() + kBlock - 1) / kBlock),
      first_(static_cast<size_t>(across_) * static_cast<size_t>(down_) + 1) {
  const size_t blockCount = blocks();
  const size_t triangleCount = projected.mesh().triangles.size();
  std::vector<std::vector<size_t>> next(kChunks, std::vector<size_t>(blockCount));
  const auto forEachPair = [&](size_t begin, size_t end, const auto& visit) {
    for (size_t i = begin; i < end; ++i) {
      const auto triangle = static_cast<uint32_t>(i);
      // Snapping may move a vertex by half a step of its grid.
      constexpr float kSnap = 1.0f / 1024;
      ImageBox box = boxOfTriangle(projected, parts_, triangle);
      if (box.lower.x > box.upper.x) {
        continue;
      }
      box = view.imageBox({box.lower - kSnap, box.upper + kSnap});
      const PixelBounds pixels = pixelsOf(box, view.width(), view.height());
      for (int y = pixels.y0 / kBlock; y * kBlock < pixels.y1; ++y) {
        for (int x = pixels.x0 / kBlock; x * kBlock < pixels.x1; ++x) {
          visit(triangle, static_cast<size_t>(y) * static_cast<size_t>(across_) + static_cast<size_t>(x));
        }
      }
    }
  };
  parallelChunks(triangleCount, kChunks, [&](size_t chunk, size_t begin, size_t end) {
    forEachPair(begin, end, [&](uint32_t, size_t block) { ++next[chunk][block]; });
  });
  // Within a block, the triangles of the first chunk come first: they stay in their order.
  size_t total = 0;
  for (size_t block = 0; block < blockCount; ++block) {
    first_[block] = total;
    for (size_t chunk = 0; chunk < kChunks; ++chunk) {
      total += std::exchange(next[chunk][block], total);
    }
  }
  first_[blockCount] = total;
  triangles_.resize(total);
  parallelChunks(triangleCount, kChunks, [&](size_t chunk, size_t begin, size_t end) {
    forEachPair(begin, end, [&](uint32_t triangle, size_t block) { triangles_[next[chunk][block]++] = triangle; });
  });
}

}  // namespace ocelli
