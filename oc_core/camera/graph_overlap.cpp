#include "oc_core/camera/graph_overlap.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <optional>
#include <sstream>

#include "oc_core/base/error.h"
#include "oc_core/camera/convex_polyhedron.h"
#include "oc_core/camera/frustum_pieces.h"

namespace ocelli {
namespace {

constexpr const char* kOverlaps = "graph camera, overlaps of its frusta";

/// A piece whose sides moved inwards, and what of the world it holds then.
struct Core {
  FrustumPiece piece;
  ConvexPolyhedron volume;
};

std::vector<Core> coresOf(const GraphCamera& camera, const ConvexPolyhedron& world, double inwards) {
  std::vector<Core> cores;
  for (FrustumPiece& piece : piecesOf(camera)) {
    ConvexPolyhedron volume = world;
    for (Plane& side : piece.sides) {
      side.distance -= inwards;
      volume.cut(side);
    }
    if (!volume.empty()) {
      cores.push_back({std::move(piece), std::move(volume)});
    }
  }
  return cores;
}

bool boxesMeet(const ConvexPolyhedron& a, const ConvexPolyhedron& b) {
  return glm::all(glm::lessThanEqual(a.lower(), b.upper())) && glm::all(glm::lessThanEqual(b.lower(), a.upper()));
}

std::optional<glm::dvec3> commonPoint(const Core& a, const Core& b) {
  if (!boxesMeet(a.volume, b.volume)) {
    return std::nullopt;
  }
  ConvexPolyhedron common = a.volume;
  for (const Plane& side : b.piece.sides) {
    common.cut(side);
    if (common.empty()) {
      return std::nullopt;
    }
  }
  return common.middle();
}

}  // namespace

std::vector<FrustumOverlap> overlapsOf(const GraphCamera& camera, const glm::dvec3& lower, const glm::dvec3& upper,
                                       double minOverlap) {
  const double diagonal = glm::distance(lower, upper);
  if (!glm::all(glm::lessThanEqual(lower, upper)) || !(diagonal > 0) || !std::isfinite(diagonal)) {
    throw InputError("the box of the world is empty, a point or not finite", kOverlaps,
                     "give its lower and its upper corner, such as those of the scene's bounds");
  }
  if (!(minOverlap > 0) || !std::isfinite(minOverlap)) {
    throw InputError("the least overlap is not positive or not finite", kOverlaps,
                     "give a share of the world's diagonal, such as 1e-4");
  }
  const std::vector<Core> cores = coresOf(camera, ConvexPolyhedron(lower, upper), minOverlap * diagonal / 2);
  std::vector<FrustumOverlap> overlaps;
  for (size_t i = 0; i < cores.size(); ++i) {
    for (size_t k = i + 1; k < cores.size(); ++k) {
      if (cores[i].piece.frustum != cores[k].piece.frustum) {
        if (const std::optional<glm::dvec3> point = commonPoint(cores[i], cores[k])) {
          overlaps.push_back({cores[i].piece.frustum, cores[k].piece.frustum, *point});
        }
      }
    }
  }
  const auto pair = [](const FrustumOverlap& overlap) { return std::pair(overlap.first, overlap.second); };
  std::stable_sort(overlaps.begin(), overlaps.end(), [&](const auto& a, const auto& b) { return pair(a) < pair(b); });
  const auto same = [&](const auto& a, const auto& b) { return pair(a) == pair(b); };
  overlaps.erase(std::unique(overlaps.begin(), overlaps.end(), same), overlaps.end());
  return overlaps;
}

void checkDisjoint(const GraphCamera& camera, const glm::dvec3& lower, const glm::dvec3& upper, double minOverlap) {
  const std::vector<FrustumOverlap> overlaps = overlapsOf(camera, lower, upper, minOverlap);
  if (overlaps.empty()) {
    return;
  }
  const FrustumOverlap& overlap = overlaps.front();
  const auto name = [&](int i) { return "\"" + camera.frusta()[static_cast<size_t>(i)].name + "\""; };
  std::ostringstream what;
  what << "frusta " << name(overlap.first) << " and " << name(overlap.second) << " both hold the point ("
       << overlap.point.x << ", " << overlap.point.y << ", " << overlap.point.z << ")";
  throw InputError(what.str(), "graph camera",
                   "move their planes or viewpoints apart, or end the rays of one with a limit before it");
}

}  // namespace ocelli
