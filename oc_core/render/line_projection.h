// A mesh along the epipolar lines of a pinhole: its triangles in the image, the rows that cross them, and the spans
// that rows cut out of them (rasterize_spans.h).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "oc_core/base/parallel.h"
#include "oc_core/camera/epipolar_camera.h"
#include "oc_core/render/frustum_clip.h"
#include "oc_core/render/projected_mesh.h"

namespace ocelli {

/// A vertex in the base image.
struct LineVertex {
  float u = 0;
  float v = 0;
  float inverseZ = 0;  ///< 0 marks a vertex whose triangles have to be clipped
  float row = 0;       ///< coordinate of its epipolar line
};

/// A corner of a triangle, or of its clipped polygon, with its barycentric weights in the whole triangle.
struct LineCorner {
  LineVertex vertex;
  float b1 = 0;
  float b2 = 0;
};
using LineTriangle = std::array<LineCorner, 3>;

/// Where a line crosses the border of a triangle; weights of the corners, linear over the image.
struct LineCrossing {
  double position = 0;
  glm::dvec3 weights{0};
};

/// The part of a row that a triangle covers.
struct LineSpan {
  int row = 0;
  LineCrossing from;  ///< the lower position
  LineCrossing to;
  double fromInverseZ = 0;
  double toInverseZ = 0;
};

/// Rows that may cross a triangle; `last` may be beyond the last row of a ring.
struct LineRows {
  int first = 0;
  int last = -1;
};

class LineProjection {
 public:
  LineProjection(const PinholeCamera& base, const EpipolarLines& lines, const Mesh& mesh)
      : base_(base), lines_(lines), mesh_(mesh), projected_(base, mesh) {
    if (lines.isParallel()) {
      return;
    }
    for (int row = 0; row < lines.rowCount(); ++row) {
      directions_.push_back(lines.direction(row + 0.5));
    }
    rows_.resize(mesh.positions.size());
    parallelFor(rows_.size(), 1 << 13, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) {
        const ProjectedVertex& q = projected_.vertex(static_cast<uint32_t>(i));
        rows_[i] = q.inverseZ > 0 ? static_cast<float>(lines_.place({q.u, q.v}).row) : 0;
      }
    });
  }

  const ProjectedMesh& projected() const { return projected_; }
  const PinholeCamera& base() const { return base_; }
  const EpipolarLines& lines() const { return lines_; }

  /// Calls `body` for the pieces of a scene triangle: one, or as many as clipping leaves.
  template <class Body>
  void forPieces(uint32_t triangle, const Body& body) const {
    const glm::uvec3& t = mesh_.triangles[triangle];
    const LineTriangle whole{{{vertex(t.x), 0, 0}, {vertex(t.y), 1, 0}, {vertex(t.z), 0, 1}}};
    if (whole[0].vertex.inverseZ > 0 && whole[1].vertex.inverseZ > 0 && whole[2].vertex.inverseZ > 0) {
      body(whole);
      return;
    }
    const ClipPolygon polygon =
        clipToFrustum({base_.cameraFromWorld(mesh_.positions[t.x]), base_.cameraFromWorld(mesh_.positions[t.y]),
                       base_.cameraFromWorld(mesh_.positions[t.z])},
                      base_, kClipMargin);
    const auto corner = [&](size_t i) {
      const ClipVertex& clipped = polygon.vertices[i];
      return LineCorner{project(clipped.p), clipped.b1, clipped.b2};
    };
    for (size_t i = 2; i < polygon.count; ++i) {
      body(LineTriangle{{corner(0), corner(i - 1), corner(i)}});
    }
  }

  LineRows rowsOf(const LineTriangle& triangle) const {
    const float a = triangle[0].vertex.row;
    const float b = triangle[1].vertex.row;
    const float c = triangle[2].vertex.row;
    if (!lines_.isRing()) {
      const LineRows range = rowsBetween(std::min({a, b, c}), std::max({a, b, c}));
      return {std::max(range.first, 0), std::min(range.last, lines_.rowCount() - 1)};
    }
    const float toB = rowStep(a, b);
    const float toC = rowStep(a, c);
    const LineRows range = rowsBetween(a + std::min({0.0f, toB, toC}), a + std::max({0.0f, toB, toC}));
    const bool holdsEpipole = std::abs(toB + rowStep(b, c) + rowStep(c, a)) > static_cast<float>(lines_.rowCount()) / 2;
    return holdsEpipole || range.last - range.first >= lines_.rowCount() ? LineRows{0, lines_.rowCount() - 1} : range;
  }
  /// The row that the i-th of a range stands for.
  int row(int i) const {
    const int rows = lines_.rowCount();
    return i < 0 ? i + rows : i >= rows ? i - rows : i;
  }

  /// Positions that a triangle may reach on a row.
  glm::vec2 positionsOf(const LineTriangle& triangle, int row) const {
    if (lines_.isParallel()) {
      const auto [least, most] = std::minmax({triangle[0].vertex.u, triangle[1].vertex.u, triangle[2].vertex.u});
      return {least, most};
    }
    // Nothing of a triangle is nearer to the epipole than its nearest corner by more than half its longest side.
    double nearest = 1e30;
    double farthest = 0;
    double longest = 0;
    for (size_t i = 0; i < 3; ++i) {
      const glm::dvec2 a = fromEpipole(triangle[i].vertex);
      const double radius = glm::length(a);
      nearest = std::min(nearest, radius);
      farthest = std::max(farthest, radius);
      longest = std::max(longest, glm::distance(a, fromEpipole(triangle[(i + 1) % 3].vertex)));
    }
    const double a = lines_.positionAtRadius(row, std::max(nearest - longest / 2, 0.0));
    const double b = lines_.positionAtRadius(row, farthest);
    return {static_cast<float>(std::min(a, b)), static_cast<float>(std::max(a, b))};
  }

  /// The part of a row's centre line within the triangle; false for none.
  bool cut(const LineTriangle& triangle, int row, LineSpan& span) const {
    int count = 0;
    std::array<LineCrossing, 2> crossings;
    std::array<double, 3> side{};
    std::array<glm::dvec2, 3> p;
    const glm::dvec2 direction = lines_.isParallel() ? glm::dvec2(1, 0) : directions_[static_cast<size_t>(row)];
    for (size_t i = 0; i < 3; ++i) {
      const LineVertex& vertex = triangle[i].vertex;
      p[i] = lines_.isParallel() ? glm::dvec2(vertex.u, vertex.v - (row + 0.5)) : fromEpipole(vertex);
      side[i] = direction.x * p[i].y - direction.y * p[i].x;
    }
    for (size_t i = 0; i < 3; ++i) {
      size_t a = i;
      size_t b = (i + 1) % 3;
      if ((side[a] >= 0) == (side[b] >= 0)) {
        continue;
      }
      // The same crossing for both triangles at an edge: from the same end.
      if (side[a] < 0) {
        std::swap(a, b);
      }
      const double t = side[a] / (side[a] - side[b]);
      const double along = glm::dot(direction, p[a] + (p[b] - p[a]) * t);
      if (!lines_.isParallel() && along <= 0) {
        continue;  // on the line of the opposite angle
      }
      LineCrossing& crossing = crossings[static_cast<size_t>(count++)];
      crossing.position = lines_.isParallel() ? along : lines_.positionAtRadius(row, along);
      crossing.weights[static_cast<int>(a)] = 1 - t;
      crossing.weights[static_cast<int>(b)] = t;
    }
    if (count == 0) {
      return false;
    }
    if (count == 1) {
      // The triangle holds the epipole, where the line ends.
      const auto cross = [](const glm::dvec2& m, const glm::dvec2& n) { return m.x * n.y - m.y * n.x; };
      const glm::dvec3 areas(cross(p[1], p[2]), cross(p[2], p[0]), cross(p[0], p[1]));
      const double sum = areas.x + areas.y + areas.z;
      if (sum == 0) {
        return false;
      }
      constexpr double kEnd = 1e-3;  // pixels: x is infinite at the epipole itself
      crossings[1] = {lines_.positionAtRadius(row, kEnd), areas / sum};
    }
    if (crossings[0].position > crossings[1].position) {
      std::swap(crossings[0], crossings[1]);
    }
    span = {row, crossings[0], crossings[1], inverseZ(triangle, crossings[0].weights),
            inverseZ(triangle, crossings[1].weights)};
    return true;
  }

  static double inverseZ(const LineTriangle& triangle, const glm::dvec3& weights) {
    return weights.x * triangle[0].vertex.inverseZ + weights.y * triangle[1].vertex.inverseZ +
           weights.z * triangle[2].vertex.inverseZ;
  }

 private:
  LineVertex project(const glm::vec3& cameraPoint) const {
    const ImagePoint q = base_.imageFromCamera(cameraPoint);
    return {q.u, q.v, 1 / q.t, lines_.isParallel() ? q.v : static_cast<float>(lines_.place({q.u, q.v}).row)};
  }
  LineVertex vertex(uint32_t i) const {
    const ProjectedVertex& q = projected_.vertex(i);
    const bool within = q.u > -kClipMargin && q.v > -kClipMargin &&
                        q.u < static_cast<float>(base_.width()) + kClipMargin &&
                        q.v < static_cast<float>(base_.height()) + kClipMargin;
    return {q.u, q.v, within ? q.inverseZ : 0, lines_.isParallel() ? q.v : rows_[i]};
  }
  glm::dvec2 fromEpipole(const LineVertex& vertex) const { return glm::dvec2(vertex.u, vertex.v) - lines_.epipole(); }
  /// A row belongs to what crosses its centre; a little more for rounding.
  static LineRows rowsBetween(float least, float most) {
    constexpr float kRounding = 0.01f;
    return {static_cast<int>(std::ceil(least - 0.5f - kRounding)),
            static_cast<int>(std::floor(most - 0.5f + kRounding))};
  }
  /// From one row coordinate of a ring to another, the short way round.
  float rowStep(float from, float to) const {
    const float step = to - from;
    const auto rows = static_cast<float>(lines_.rowCount());
    return step > rows / 2 ? step - rows : step < -rows / 2 ? step + rows : step;
  }

  const PinholeCamera& base_;
  const EpipolarLines& lines_;
  const Mesh& mesh_;
  ProjectedMesh projected_;
  std::vector<float> rows_;  ///< of the vertices, where lines are not parallel
  std::vector<glm::dvec2> directions_;
};

}  // namespace ocelli
