// The curved ray camera (section 4.2): a pinhole whose rays turn, as often as wanted, from one viewpoint to the next
// along conics that are tangent to the straight pieces before and behind (ray_transition.h). So one image sees around
// corners, and what it shows bends smoothly instead of breaking.
//
// Every turn has three planes that meet in a line. Rays run straight up to the first, turn, and run straight on from
// the third, away from the viewpoint of the turn. Projection has a closed form: a point between turns is projected by
// one matrix, the product of those of all turns before it (Appendix A); a point in a turn is first moved along its ray
// to the middle plane.
//
// That is so with conics. With the text's first model, polynomial arcs, the arc through a point is searched for.
//
// z is measured along the ray as by the graph camera; along an arc it grows by the length of its control polygon, in
// proportion to RayTransition::shareAt(). Without turns, and where the viewpoints are one, it is the pinhole's z.
#pragma once

#include <vector>

#include "oc_core/camera/camera.h"
#include "oc_core/camera/exact_image_point.h"
#include "oc_core/camera/pinhole_camera.h"
#include "oc_core/camera/ray_transition.h"

namespace ocelli {

class CurvedRayCamera {
 public:
  static constexpr size_t kMostTurns = 16;

  /// A pinhole: rays do not turn.
  explicit CurvedRayCamera(const PinholeCamera& root, ArcModel model = ArcModel::kConic);

  /// Beyond all turns so far, every ray turns to come from `viewpoint`. Throws InputError, naming the turn by its
  /// number, where the planes do not meet in a line, where not every ray crosses them in order, behind the turn before
  /// and before zFar; where the viewpoint does not lie before the middle plane; where the line from one viewpoint to
  /// the next runs along the line of the planes, as some ray sees it; and where there are too many turns.
  void turn(const TransitionPlanes& planes, const glm::dvec3& viewpoint);

  int width() const { return root_.width(); }
  int height() const { return root_.height(); }
  const PinholeCamera& root() const { return root_; }
  ArcModel arcModel() const { return model_; }
  const std::vector<RayTransition>& turns() const { return turns_; }
  /// Rows 0, 1 and 3 give u, v and their weight of a point where rays run straight, after so many turns.
  const glm::dmat4& pixelFromWorld(size_t turns) const { return pixelFromWorld_[turns]; }

  /// Nothing for points that no ray passes, but those that the pinhole sees beyond the borders.
  std::optional<ExactImagePoint> projectExactly(const glm::dvec3& worldPoint) const;
  std::optional<glm::dvec3> unprojectExactly(const ExactImagePoint& imagePoint) const;

  std::optional<ImagePoint> project(const glm::vec3& worldPoint) const;
  std::optional<glm::vec3> unproject(const ImagePoint& q) const;
  /// Its arcs are polylines, whose corners lie on them.
  RayPath rayPath(const glm::vec2& pixel) const;

 private:
  /// A straight piece of a ray: along a direction whose length advances z by 1.
  struct Segment {
    glm::dvec3 from{0};
    glm::dvec3 direction{0};
    double z = 0;

    double zOf(const glm::dvec3& point) const { return z + glm::distance(from, point) / glm::length(direction); }
  };
  Segment rootSegment(const glm::dvec2& pixel) const;
  /// The arc that a segment ends with, at the next turn, and the segment behind that.
  RayTransition::Arc arcOf(const Segment& segment, size_t turn) const;
  Segment behind(const Segment& segment, const RayTransition::Arc& arc, size_t turn) const;
  std::optional<glm::dvec2> pixelOf(size_t turns, const glm::dvec3& point, double rounding) const;
  std::optional<ExactImagePoint> inStretch(size_t turns, const glm::dvec3& point, double rounding) const;
  std::optional<ExactImagePoint> inTurn(size_t turn, const glm::dvec3& point, double rounding) const;
  Segment segmentAfter(size_t turns, const glm::dvec2& pixel) const;

  PinholeCamera root_;
  ArcModel model_;
  std::vector<RayTransition> turns_;
  std::vector<glm::dmat4> pixelFromWorld_;  ///< after so many turns
};

static_assert(Camera<CurvedRayCamera>);

/// As for cameras that displace the image of a pinhole (distorted_pinhole.h): the one whose image it is.
inline const PinholeCamera& referenceOf(const CurvedRayCamera& camera) {
  return camera.root();
}

}  // namespace ocelli
