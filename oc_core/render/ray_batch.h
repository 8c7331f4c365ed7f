// The rays of pixels side by side that take the same way, as PixelRay (pixel_ray.h) follows each: by the same steps, so
// that z is the same, bit by bit. Loops over lanes become vector instructions.
#pragma once

#include <array>
#include <cmath>

#include "oc_core/render/pixel_ray.h"

namespace ocelli {

class RayBatch {
 public:
  static constexpr int kLanes = 16;
  using Lanes = std::array<double, kLanes>;
  struct Points {
    Lanes x{};
    Lanes y{};
    Lanes z{};

    void set(int lane, const glm::dvec3& p) {
      const auto i = static_cast<size_t>(lane);
      x[i] = p.x;
      y[i] = p.y;
      z[i] = p.z;
    }
  };

  /// Of kLanes pixels of row `y`, from `x` on, which may be more than there are.
  RayBatch(const PixelRays& rays, int x, int y) {
    Lanes squares;
    const glm::dvec3 eye = rays.eye();
    for (int i = 0; i < kLanes; ++i) {
      from_.set(i, eye);
      direction_.set(i, rays.direction({x + i + 0.5, y + 0.5}));
    }
    squareLengths(direction_, squares);
    forEachLane([&](size_t i) { perLength_[i] = 1 / std::sqrt(squares[i]); });
  }

  /// From where they cross a plane they run on, away from a viewpoint.
  void bend(const Plane& plane, const glm::dvec3& viewpoint) {
    Points at;
    cross(plane, at);
    zOf(at, z_);
    from_ = at;
    forEachLane([&](size_t i) {
      direction_.x[i] = at.x[i] - viewpoint.x;
      direction_.y[i] = at.y[i] - viewpoint.y;
      direction_.z[i] = at.z[i] - viewpoint.z;
    });
  }
  void cross(const Plane& plane, Points& at) const {
    Lanes heights;
    Lanes slopes;
    heightsOver(plane, from_, heights);
    dots(plane.normal, direction_, slopes);
    forEachLane([&](size_t i) {
      const double share = heights[i] / slopes[i];
      at.x[i] = from_.x[i] - direction_.x[i] * share;
      at.y[i] = from_.y[i] - direction_.y[i] * share;
      at.z[i] = from_.z[i] - direction_.z[i] * share;
    });
  }
  /// z of points of their last pieces.
  void zOf(const Points& points, Lanes& z) const {
    Points between;
    forEachLane([&](size_t i) {
      between.x[i] = points.x[i] - from_.x[i];
      between.y[i] = points.y[i] - from_.y[i];
      between.z[i] = points.z[i] - from_.z[i];
    });
    Lanes squares;
    squareLengths(between, squares);
    forEachLane([&](size_t i) { z[i] = z_[i] + std::sqrt(squares[i]) * perLength_[i]; });
  }
  /// The cosines between the rays and the normal of a plane.
  void cosines(const Plane& plane, Lanes& cosines) const {
    Lanes squares;
    squareLengths(direction_, squares);
    Points unit;
    forEachLane([&](size_t i) {
      const double perLength = 1 / std::sqrt(squares[i]);
      unit.x[i] = direction_.x[i] * perLength;
      unit.y[i] = direction_.y[i] * perLength;
      unit.z[i] = direction_.z[i] * perLength;
    });
    dots(plane.normal, unit, cosines);
  }

  static void heightsOver(const Plane& plane, const Points& points, Lanes& heights) {
    dots(plane.normal, points, heights);
    forEachLane([&](size_t i) { heights[i] = heights[i] - plane.distance; });
  }
  template <class Visit>
  static void forEachLane(const Visit& visit) {
    for (size_t i = 0; i < kLanes; ++i) {
      visit(i);
    }
  }

 private:
  static void dots(const glm::dvec3& a, const Points& b, Lanes& dots) {
    forEachLane([&](size_t i) { dots[i] = a.x * b.x[i] + a.y * b.y[i] + a.z * b.z[i]; });
  }
  static void squareLengths(const Points& p, Lanes& squares) {
    forEachLane([&](size_t i) { squares[i] = p.x[i] * p.x[i] + p.y[i] * p.y[i] + p.z[i] * p.z[i]; });
  }

  Points from_;
  Points direction_;
  Lanes perLength_{};
  Lanes z_{};
};

}  // namespace ocelli
