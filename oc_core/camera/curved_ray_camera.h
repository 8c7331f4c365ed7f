// The curved ray camera (section 4.2): a pinhole whose rays bend, as often as wanted, from one viewpoint to the next
// along conics that are tangent to the straight pieces before and behind (ray_transition.h). So one image sees around
// corners, and what it shows bends smoothly instead of breaking.
//
// Every bend has three planes that meet in a line. Rays run straight up to the first, bend, and run straight on from
// the third, away from the viewpoint of the bend. Projection has a closed form: a point between bends is projected by
// one matrix, the product of those of all bends before it (Appendix A); a point in a bend is first moved along its ray
// to the middle plane.
//
// That is so with conics. With the text's first model, polynomial arcs, the arc through a point is searched for.
//
// t is measured along the ray as by the graph camera; along an arc it grows by the length of its control polygon, in
// proportion to RayTransition::shareAt(). Without bends, and where the viewpoints are one, it is the pinhole's z.
#pragma once

#include <vector>

#include "oc_core/camera/camera.h"
#include "oc_core/camera/exact_image_point.h"
#include "oc_core/camera/pinhole_camera.h"
#include "oc_core/camera/ray_hull.h"
#include "oc_core/camera/ray_transition.h"

namespace ocelli {

class CurvedRayCamera {
 public:
  static constexpr size_t kMaxBends = 16;
  static constexpr size_t kArcPoints = 24;  ///< of an arc in a ray path

  /// A pinhole: rays do not bend.
  explicit CurvedRayCamera(const PinholeCamera& root, ArcModel model = ArcModel::kConic);

  /// Beyond all bends so far, every ray bends to come from `viewpoint`. Throws InputError, naming the bend by its
  /// number, where the planes do not meet in a line, where not every ray crosses them in order, behind the bend before
  /// and before zFar; where the viewpoint does not lie before the middle plane; where the line from one viewpoint to
  /// the next runs along the line of the planes, as some ray sees it; and where there are too many bends.
  void bend(const TransitionPlanes& planes, const glm::dvec3& viewpoint);

  int width() const { return root_.width(); }
  int height() const { return root_.height(); }
  const PinholeCamera& root() const { return root_; }
  ArcModel arcModel() const { return model_; }
  const std::vector<RayTransition>& bends() const { return bends_; }
  /// Rows 0, 1 and 3 give u, v and their weight of a point where rays run straight, after so many bends.
  const glm::dmat4& pixelFromWorld(size_t bends) const { return pixelFromWorld_[bends]; }

  /// Nothing for points that no ray passes, but those that the pinhole sees beyond the borders.
  std::optional<ExactImagePoint> projectExactly(const glm::dvec3& worldPoint) const;
  std::optional<glm::dvec3> unprojectExactly(const ExactImagePoint& imagePoint) const;

  std::optional<ImagePoint> project(const glm::vec3& worldPoint) const;
  std::optional<glm::vec3> unproject(const ImagePoint& q) const;
  /// Its arcs are polylines, whose corners lie on them: so many, where the path has room.
  RayPath rayPath(const glm::vec2& pixel, size_t arcPoints = kArcPoints) const;
  /// Of any arcs, however many corners their polylines have (ray_hull.h).
  HullPieces hullOf(const glm::dvec2& lower, const glm::dvec2& upper) const;
  /// The fewest corners for which no polyline is farther than `deviation` from its arc, in the unit of the world, as
  /// rays all over the image tell; at most kArcPoints.
  size_t arcPointsWithin(double deviation) const;

 private:
  /// A straight piece of a ray: along a direction whose length advances t by 1.
  struct Segment {
    glm::dvec3 from{0};
    glm::dvec3 direction{0};
    double t = 0;

    double tOf(const glm::dvec3& point) const { return t + glm::distance(from, point) / glm::length(direction); }
  };
  Segment rootSegment(const glm::dvec2& pixel) const;
  /// The arc that a segment ends with, at the next bend, and the segment behind that.
  RayTransition::Arc arcOf(const Segment& segment, size_t bend) const;
  Segment behind(const Segment& segment, const RayTransition::Arc& arc, size_t bend) const;
  /// As many as wanted, where a path has room for them.
  size_t arcPointsWithRoom(size_t wanted) const;
  /// How far the polylines of a pixel's ray are from its arcs.
  double deviationOf(const glm::dvec2& pixel, size_t arcPoints) const;
  std::optional<glm::dvec2> pixelOf(size_t bends, const glm::dvec3& point, double rounding) const;
  std::optional<ExactImagePoint> inSegment(size_t bends, const glm::dvec3& point, double rounding) const;
  std::optional<ExactImagePoint> inBend(size_t bend, const glm::dvec3& point, double rounding) const;
  Segment segmentAfter(size_t bends, const glm::dvec2& pixel) const;

  PinholeCamera root_;
  ArcModel model_;
  std::vector<RayTransition> bends_;
  std::vector<glm::dmat4> pixelFromWorld_;  ///< after so many bends
};

static_assert(Camera<CurvedRayCamera>);

inline HullPieces hullOf(const CurvedRayCamera& camera, const glm::dvec2& lower, const glm::dvec2& upper) {
  return camera.hullOf(lower, upper);
}

/// As for cameras that displace the image of a pinhole (distorted_pinhole.h): the one whose image it is.
inline const PinholeCamera& referenceOf(const CurvedRayCamera& camera) {
  return camera.root();
}

}  // namespace ocelli
