// Openings of a place as near faces, and what cameras see of them. For the .cpp files of this room.
#pragma once

#include <array>
#include <glm/vec3.hpp>

#include "oc_core/feeds/feed_setup.h"
#include "oc_core/render/triangle_tree.h"
#include "oc_core/scene/portal.h"

namespace ocelli {

class PlaceWalls {
 public:
  /// The mesh must outlive it.
  explicit PlaceWalls(const Mesh& mesh) : tree_(mesh) {}

  /// How far it is from a point to the next wall along a unit vector; `reach` where there is none so near.
  double distance(const glm::dvec3& from, const glm::dvec3& direction, double reach) const;
  bool isFree(const glm::dvec3& from, const glm::dvec3& to) const;

 private:
  TriangleTree tree_;
};

/// Corners of an upright near face: the bottom and the top of one jamb, then the top and the bottom of the other.
using FaceCorners = std::array<glm::dvec3, 4>;

/// The opening as far as the walls around it, where these are near; moved by some centimetres to where it has both
/// jambs.
FaceCorners faceOf(const Portal& opening, const PlaceWalls& walls);

/// Whether the feed shows the middle of the opening.
bool seesMiddle(const Feed& feed, const Portal& opening, const PlaceWalls& walls);
/// Whether the feed sees it, from the same side as an eye that sees some of it.
bool looksThrough(const Feed& feed, const glm::dvec3& eye, const Portal& opening, const PlaceWalls& walls);

/// The angle between the normal of a face and the level way from its middle to an eye, 0 to pi / 2.
double angleTowards(const FaceCorners& face, const glm::dvec3& eye);
/// The face turned about the jamb that is nearer to the eye, by an angle, so that it faces the eye more; it ends at the
/// next wall.
FaceCorners turnedFace(const FaceCorners& face, const glm::dvec3& eye, double angle, const PlaceWalls& walls);

}  // namespace ocelli
