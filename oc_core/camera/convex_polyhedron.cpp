#include "oc_core/camera/convex_polyhedron.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>

namespace ocelli {
namespace {

using Corners = std::vector<glm::dvec3>;

/// The corners of a face that are not beyond the plane, and those in it, which go to `cap` as well.
Corners cutFace(const Corners& face, const Plane& plane, Corners& cap) {
  Corners kept;
  for (size_t i = 0; i < face.size(); ++i) {
    const glm::dvec3& a = face[i];
    const glm::dvec3& b = face[(i + 1) % face.size()];
    const double heightA = plane.height(a);
    const double heightB = plane.height(b);
    if (heightA <= 0) {
      kept.push_back(a);
    }
    if (heightA == 0) {
      cap.push_back(a);
    }
    if ((heightA < 0 && heightB > 0) || (heightA > 0 && heightB < 0)) {
      // From the inner end, so that two faces cut the edge that they share alike.
      const glm::dvec3 crossing = heightA < 0 ? plane.crossing(a, b) : plane.crossing(b, a);
      kept.push_back(crossing);
      cap.push_back(crossing);
    }
  }
  return kept;
}

/// Points of a plane that are the corners of a convex polygon, put in order around it.
void order(Corners& corners, const glm::dvec3& normal) {
  glm::dvec3 middle(0);
  for (const glm::dvec3& corner : corners) {
    middle += corner / static_cast<double>(corners.size());
  }
  const glm::dvec3 right =
      glm::normalize(glm::cross(normal, std::abs(normal.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
  const glm::dvec3 up = glm::cross(normal, right);
  const auto angle = [&](const glm::dvec3& p) {
    return std::atan2(glm::dot(up, p - middle), glm::dot(right, p - middle));
  };
  std::sort(corners.begin(), corners.end(), [&](const auto& a, const auto& b) { return angle(a) < angle(b); });
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
}

}  // namespace

ConvexPolyhedron::ConvexPolyhedron(const glm::dvec3& lower, const glm::dvec3& upper) : lower_(lower), upper_(upper) {
  const auto corner = [&](int x, int y, int z) {
    return glm::dvec3(x ? upper.x : lower.x, y ? upper.y : lower.y, z ? upper.z : lower.z);
  };
  for (const int side : {0, 1}) {
    faces_.push_back({corner(side, 0, 0), corner(side, 1, 0), corner(side, 1, 1), corner(side, 0, 1)});
    faces_.push_back({corner(0, side, 0), corner(1, side, 0), corner(1, side, 1), corner(0, side, 1)});
    faces_.push_back({corner(0, 0, side), corner(1, 0, side), corner(1, 1, side), corner(0, 1, side)});
  }
}

void ConvexPolyhedron::cut(const Plane& plane) {
  std::vector<Face> kept;
  Face cap;
  bool isCut = false;
  for (const Face& face : faces_) {
    const auto beyond = [&](const glm::dvec3& corner) { return plane.height(corner) > 0; };
    isCut |= std::any_of(face.begin(), face.end(), beyond);
    Face left = cutFace(face, plane, cap);
    if (!left.empty()) {
      kept.push_back(std::move(left));
    }
  }
  if (!isCut) {
    return;
  }
  faces_ = std::move(kept);
  if (!cap.empty()) {
    order(cap, plane.normal);
    faces_.push_back(std::move(cap));
  }
  updateBounds();
}

glm::dvec3 ConvexPolyhedron::middle() const {
  glm::dvec3 sum(0);
  double count = 0;
  for (const Face& face : faces_) {
    for (const glm::dvec3& corner : face) {
      sum += corner;
      ++count;
    }
  }
  return sum / count;
}

void ConvexPolyhedron::updateBounds() {
  lower_ = glm::dvec3(std::numeric_limits<double>::infinity());
  upper_ = -lower_;
  for (const Face& face : faces_) {
    for (const glm::dvec3& corner : face) {
      lower_ = glm::min(lower_, corner);
      upper_ = glm::max(upper_, corner);
    }
  }
}

}  // namespace ocelli
