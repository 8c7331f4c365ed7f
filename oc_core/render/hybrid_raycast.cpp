#include "oc_core/render/hybrid_raycast.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <numeric>

#include "oc_core/render/depth_keys.h"

namespace ocelli {

RayPathTable::RayPathTable(int width, int height, const PinholeCamera& reference,
                           const std::function<RayPath(const glm::vec2&)>& rayPath)
    : width_(width), height_(height) {
  const auto rows = static_cast<size_t>(height);
  const auto across = static_cast<size_t>(width);
  std::vector<std::vector<glm::vec3>> pointsOfRow(rows);
  firstPoint_.assign(rows * across + 1, 0);
  parallelFor(rows, 1, [&](size_t begin, size_t end) {
    for (size_t y = begin; y < end; ++y) {
      for (size_t x = 0; x < across; ++x) {
        const RayPath path = rayPath({static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f});
        float z = 0;
        for (const glm::vec3& point : path) {
          glm::vec3& p = pointsOfRow[y].emplace_back(reference.cameraFromWorld(point));
          p.z = z = std::max(p.z, z);  // points next to each other may have been rounded past each other
        }
        firstPoint_[y * across + x + 1] = path.size();
      }
    }
  });
  std::partial_sum(firstPoint_.begin(), firstPoint_.end(), firstPoint_.begin());
  points_.resize(firstPoint_.back());
  parallelFor(rows, 1, [&](size_t begin, size_t end) {
    for (size_t y = begin; y < end; ++y) {
      std::copy(pointsOfRow[y].begin(), pointsOfRow[y].end(),
                points_.begin() + static_cast<std::ptrdiff_t>(firstPoint_[y * across]));
    }
  });
}

std::optional<RayPathTable::Meeting> RayPathTable::meet(size_t pixel, const std::array<glm::vec3, 3>& triangle) const {
  const auto pathBegin = points_.begin() + static_cast<std::ptrdiff_t>(firstPoint_[pixel]);
  const auto pathEnd = points_.begin() + static_cast<std::ptrdiff_t>(firstPoint_[pixel + 1]);
  const float zLeast = std::min({triangle[0].z, triangle[1].z, triangle[2].z});
  const float zGreatest = std::max({triangle[0].z, triangle[1].z, triangle[2].z});
  // The segments whose depths overlap those of the triangle.
  auto end = std::lower_bound(pathBegin, pathEnd, zLeast, [](const glm::vec3& p, float z) { return p.z < z; });
  if (end == pathBegin && end != pathEnd) {
    ++end;
  }
  const glm::dvec3 a(triangle[0]);
  const glm::dvec3 b(triangle[1]);
  const glm::dvec3 c(triangle[2]);
  const glm::dvec3 normal = glm::cross(b - a, c - a);
  for (; end != pathEnd && std::prev(end)->z <= zGreatest; ++end) {
    const glm::dvec3 p(*std::prev(end));
    const glm::dvec3 q(*end);
    const double height = glm::dot(normal, p - a);
    const double heightBeyond = glm::dot(normal, q - a);
    // Both ends on one side, or a segment in the plane of the triangle, which sees it edge on.
    if ((height > 0 && heightBeyond > 0) || (height < 0 && heightBeyond < 0) || height == heightBeyond) {
      continue;
    }
    // Signed volumes with each edge. Triangles that share an edge get the same number with the other sign, so that no
    // ray slips between them.
    const glm::dvec3 direction = q - p;
    const glm::dvec3 pa = a - p;
    const glm::dvec3 pb = b - p;
    const glm::dvec3 pc = c - p;
    const double wa = glm::dot(direction, glm::cross(pb, pc));
    const double wb = glm::dot(direction, glm::cross(pc, pa));
    const double wc = glm::dot(direction, glm::cross(pa, pb));
    const bool inside = (wa >= 0 && wb >= 0 && wc >= 0) || (wa <= 0 && wb <= 0 && wc <= 0);
    const double sum = wa + wb + wc;
    if (inside && sum != 0) {
      const double t = std::clamp(height / (height - heightBeyond), 0.0, 1.0);
      return Meeting{static_cast<float>(p.z + t * direction.z), static_cast<float>(wb / sum),
                     static_cast<float>(wc / sum)};
    }
  }
  return std::nullopt;
}

FragmentImage castTriangles(const RayPathTable& paths, size_t triangleCount,
                            const std::function<std::array<glm::vec3, 3>(size_t)>& cornersOf,
                            const std::function<PixelBox(const std::array<glm::vec3, 3>&)>& footprintOf) {
  FragmentImage fragments(paths.width(), paths.height());
  DepthKeys keys(fragments.size());
  parallelFor(triangleCount, 256, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const std::array<glm::vec3, 3> corners = cornersOf(i);
      const PixelBox box = footprintOf(corners);
      for (int y = box.y0; y <= box.y1; ++y) {
        for (int x = box.x0; x <= box.x1; ++x) {
          const size_t pixel = fragments.index(x, y);
          if (const std::optional<RayPathTable::Meeting> meeting = paths.meet(pixel, corners)) {
            keys.offer(pixel, DepthKeys::key(meeting->z, static_cast<uint32_t>(i)));
          }
        }
      }
    }
  });
  parallelFor(fragments.size(), 1 << 12, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      if (keys.covered(i)) {
        const uint32_t triangle = keys.triangle(i);
        const std::optional<RayPathTable::Meeting> meeting = paths.meet(i, cornersOf(triangle));
        fragments[i] = {meeting->z, triangle, meeting->b1, meeting->b2};
      }
    }
  });
  return fragments;
}

}  // namespace ocelli
