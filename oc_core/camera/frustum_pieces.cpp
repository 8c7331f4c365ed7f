#include "oc_core/camera/frustum_pieces.h"

#include "oc_core/base/check.h"

namespace ocelli {
namespace {

using Frustum = GraphCamera::Frustum;
using Part = GraphCamera::Part;

Plane reversed(const Plane& plane) {
  return {-plane.normal, -plane.distance};
}

/// A part without the part that a child takes, as convex polygons.
std::vector<Part> without(Part part, const Part& taken) {
  std::vector<Part> left;
  for (size_t i = 0; i < taken.size() && !part.empty(); ++i) {
    auto [inner, outer] = GraphCamera::cut(part, taken[i], taken[(i + 1) % taken.size()]);
    if (!outer.empty()) {
      left.push_back(std::move(outer));
    }
    part = std::move(inner);
  }
  return left;
}

/// The plane of the rays that pass the edge a -> b of a part. An image point in homogeneous coordinates lies to its
/// right where cross(b - a, (u, v) - a w) is positive, as its weight is beyond the frustum's plane.
Plane sideThrough(const Frustum& frustum, const glm::dvec2& a, const glm::dvec2& b) {
  const glm::dvec2 along = b - a;
  const glm::dvec4 inner =
      glm::transpose(frustum.pixelFromWorld) * glm::dvec4(-along.y, along.x, 0, along.y * a.x - along.x * a.y);
  const double length = glm::length(glm::dvec3(inner));
  return {-glm::dvec3(inner) / length, inner.w / length};
}

FrustumPiece pieceOf(const GraphCamera& camera, int frustum, int child, const Part& part) {
  const Frustum& holder = camera.frusta()[static_cast<size_t>(frustum)];
  FrustumPiece piece{frustum, child, {reversed(holder.plane)}};
  for (size_t i = 0; i < part.size(); ++i) {
    piece.sides.push_back(sideThrough(holder, part[i], part[(i + 1) % part.size()]));
  }
  if (child >= 0) {
    piece.sides.push_back(camera.frusta()[static_cast<size_t>(child)].plane);
  } else {
    piece.sides.insert(piece.sides.end(), holder.limits.begin(), holder.limits.end());
  }
  return piece;
}

}  // namespace

std::vector<FrustumPiece> piecesOf(const GraphCamera& camera, int frustum) {
  OC_CHECK(frustum >= 0 && static_cast<size_t>(frustum) < camera.frusta().size(), "there is no such frustum");
  const Frustum& holder = camera.frusta()[static_cast<size_t>(frustum)];
  std::vector<FrustumPiece> pieces;
  std::vector<Part> rest{holder.part};
  for (const int child : holder.children) {
    const Part& taken = camera.frusta()[static_cast<size_t>(child)].part;
    pieces.push_back(pieceOf(camera, frustum, child, taken));
    std::vector<Part> left;
    for (const Part& part : rest) {
      for (Part& remaining : without(part, taken)) {
        left.push_back(std::move(remaining));
      }
    }
    rest = std::move(left);
  }
  for (const Part& part : rest) {
    pieces.push_back(pieceOf(camera, frustum, -1, part));
  }
  return pieces;
}

std::vector<FrustumPiece> piecesOf(const GraphCamera& camera) {
  std::vector<FrustumPiece> pieces;
  for (size_t i = 0; i < camera.frusta().size(); ++i) {
    for (FrustumPiece& piece : piecesOf(camera, static_cast<int>(i))) {
      pieces.push_back(std::move(piece));
    }
  }
  return pieces;
}

}  // namespace ocelli
