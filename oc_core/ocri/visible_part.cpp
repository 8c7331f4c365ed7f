#include "oc_core/ocri/visible_part.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "oc_core/base/parallel.h"

namespace ocelli {
namespace {

constexpr float kBehindFootprints = 10;
constexpr float kSmallTrianglePixels = 1;

/// The farthest depth of the 3x3 samples around each.
Image<float> farthestAround(const Image<float>& z) {
  Image<float> farthest(z.width(), z.height(), 0);
  parallelFor(static_cast<size_t>(z.height()), 8, [&](size_t begin, size_t end) {
    for (size_t row = begin; row < end; ++row) {
      const int y = static_cast<int>(row);
      for (int x = 0; x < z.width(); ++x) {
        for (int v = y - 1; v <= y + 1; ++v) {
          for (int u = x - 1; u <= x + 1; ++u) {
            const bool empty = !z.contains(u, v) || z(u, v) <= 0;
            farthest(x, y) = std::max(farthest(x, y), empty ? std::numeric_limits<float>::infinity() : z(u, v));
          }
        }
      }
    }
  });
  return farthest;
}

bool shows(const Image<float>& farthest, const ImagePoint& q, float focalPixels) {
  // Compared as floats: an image point may be too far out for an integer.
  if (!(q.u >= 0 && q.v >= 0 && q.u < static_cast<float>(farthest.width()) &&
        q.v < static_cast<float>(farthest.height()))) {
    return true;
  }
  return q.z * (1 - kBehindFootprints / focalPixels) <= farthest(static_cast<int>(q.u), static_cast<int>(q.v));
}

}  // namespace

Mesh visiblePart(const Mesh& mesh, const DdocCamera& camera, const Image<float>& seen, const Image<float>& distorted) {
  const PinholeCamera& reference = camera.reference();
  const Image<float> farthestSeen = farthestAround(seen);
  const Image<float> farthestDistorted = farthestAround(distorted);

  struct VertexState {
    ImagePoint image;
    bool shown = true;  // a vertex without an image is up to the renderer
  };
  std::vector<VertexState> states(mesh.positions.size());
  parallelFor(states.size(), 1 << 13, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      if (const std::optional<ImagePoint> q = reference.project(mesh.positions[i])) {
        states[i] = {*q, shows(farthestSeen, *q, reference.focalPixels()) ||
                             shows(farthestDistorted, camera.distort(*q), reference.focalPixels())};
      }
    }
  });
  const auto isSmall = [&](const ImagePoint& a, const ImagePoint& b) {
    return std::abs(a.u - b.u) <= kSmallTrianglePixels && std::abs(a.v - b.v) <= kSmallTrianglePixels;
  };

  constexpr uint32_t kUnused = 0xffffffffu;
  std::vector<uint32_t> newIndex(mesh.positions.size(), kUnused);
  Mesh part;
  for (const glm::uvec3& t : mesh.triangles) {
    const VertexState& a = states[t.x];
    const VertexState& b = states[t.y];
    const VertexState& c = states[t.z];
    if (!a.shown && !b.shown && !c.shown && isSmall(a.image, b.image) && isSmall(b.image, c.image) &&
        isSmall(c.image, a.image)) {
      continue;
    }
    glm::uvec3 kept;
    for (int i = 0; i < 3; ++i) {
      uint32_t& index = newIndex[t[i]];
      if (index == kUnused) {
        index = static_cast<uint32_t>(part.positions.size());
        part.positions.push_back(mesh.positions[t[i]]);
      }
      kept[i] = index;
    }
    part.triangles.push_back(kept);
  }
  return part;
}

}  // namespace ocelli
