#include "oc_core/explore/explore_picking.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <variant>

#include "oc_core/explore/explore_shapes.h"
#include "oc_core/multiperspective/ray_pieces.h"

namespace ocelli {
namespace {

/// The length of a segment up to where it passes the opening from the side that its normal points to.
std::optional<float> passes(const Portal& portal, const glm::vec3& from, const glm::vec3& to) {
  const float before = glm::dot(portal.normal, from - portal.center);
  const float after = glm::dot(portal.normal, to - portal.center);
  if (!(before > 0) || !(after <= 0)) {
    return std::nullopt;
  }
  const float share = before / (before - after);
  const glm::vec3 off = from + (to - from) * share - portal.center;
  const bool within = std::abs(glm::dot(off, portal.halfRight)) <= glm::dot(portal.halfRight, portal.halfRight) &&
                      std::abs(glm::dot(off, portal.halfUp)) <= glm::dot(portal.halfUp, portal.halfUp);
  return within ? std::optional(share * glm::distance(from, to)) : std::nullopt;
}

Portal reversed(const Portal& portal) {
  return {portal.center, -portal.normal, -portal.halfRight, portal.halfUp};
}

std::vector<Portal> portalsOfMaze(const Maze& maze) {
  std::vector<Portal> portals;
  for (int row = 0; row < maze.rows(); ++row) {
    for (int column = 0; column < maze.columns(); ++column) {
      for (const Direction direction : kDirections) {
        if (maze.isOpen({row, column}, direction)) {
          portals.push_back(maze.openingOf({row, column}, direction));
        }
      }
    }
  }
  return portals;
}

}  // namespace

std::vector<Portal> knownPortals(const ExploreScene& scene) {
  const SceneGuides& guides = scene.guides();
  if (!guides.portals.empty()) {
    return guides.portals;
  }
  if (guides.maze) {
    return portalsOfMaze(*guides.maze);
  }
  std::vector<Portal> portals;
  if (const WalkMap* map = scene.walkMap()) {
    for (const WalkPortal& each : map->portals) {
      if (!each.isJoint) {
        portals.push_back(each.opening);
        portals.push_back(reversed(each.opening));
      }
    }
  }
  return portals;
}

std::optional<ExplorePick> pickAt(const ExploreScene& scene, const ExploreFrame& frame, const glm::dvec2& pixel) {
  const PictureSpot spot = spotOf(frame, pixel);
  if (spot.camera == nullptr) {
    return std::nullopt;
  }
  const RayPath ray = std::visit([&](const auto& camera) { return camera.rayPath(spot.pixel); }, *spot.camera);
  if (ray.size() < 2) {
    return std::nullopt;
  }
  ExplorePick pick;
  RayPath::Position end{ray.size() - 2, 1};
  if (const std::optional<ExploreHit> hit = scene.cast(ray)) {
    end = ray.positionNear(hit->position);
    pick = {hit->position, hit->object, true, hit->normal.y >= kFloorNormal, {}, {}};
  }
  const std::vector<Portal> portals = knownPortals(scene);
  float soFar = 0;
  float nearest = 1e30f;
  for (size_t i = 0; i <= end.segment; ++i) {
    const glm::vec3 to = i == end.segment && pick.surface ? pick.position : ray[i + 1];
    for (const Portal& portal : portals) {
      const std::optional<float> length = passes(portal, ray[i], to);
      if (length && soFar + *length < nearest) {
        nearest = soFar + *length;
        pick.portal = portal;
      }
    }
    soFar += glm::distance(ray[i], to);
  }
  const std::vector<RayPiece> pieces =
      std::visit([&](const auto& camera) { return rayPieces(camera, spot.pixel); }, *spot.camera);
  size_t points = 0;
  for (size_t i = 0; i < pieces.size() && points <= end.segment; ++i) {
    pick.parts.push_back(pieces[i].part);
    points += pieces[i].points.size() - 1;
  }
  return pick.surface || pick.portal ? std::optional(pick) : std::nullopt;
}

}  // namespace ocelli
