// Where a bend of a curved ray camera shows points, as RayTransition::find() has it, but with all that points have in
// common worked out beforehand; and how straight it shows edges.
#pragma once

#include "oc_core/render/bend_bounds.h"
#include "oc_core/render/block_projection.h"

namespace ocelli {

/// The image of a point of a bend.
struct BendImage {
  glm::dvec2 pixel{0};
  /// Any weight would do; one between those before and behind the bend shows edges the straightest.
  double weight = 0;
  double behindFirst = 0;  ///< distance from the first plane of the bend
  double beforeLast = 0;   ///< from the last plane
  bool imaged = false;

  /// Of the bend that is passed, from 0 to 1: planes through the line that those of the bend have in common cut it off.
  double share() const { return behindFirst > 0 ? behindFirst / (behindFirst + beforeLast) : 0; }
};

class BendProjection {
 public:
  BendProjection(const CurvedRayCamera& camera, size_t bend);

  const BendBounds& bounds() const { return bounds_; }

  /// Of a point between the first and the last plane, but for rounding.
  BendImage project(const glm::dvec3& point) const;
  /// The same of all vertices of a block.
  void project(const BlockVertices& points, BendImages& images) const;

  /// How far the middle of an edge comes out from where a straight one, in perspective, would have it, pixels.
  double deviation(const BendImage& a, const BendImage& b, const BendImage& middle) const;
  /// At most that, for an edge whose ends come out so far apart, and which passes so large a share of the bend. Edges
  /// in a plane through the line of the bend do not bend, but come out of other proportions than weights tell. The
  /// factor is measured, on edges all over the bend.
  double greatestBend(double lengthPixels, double share) const { return bendFactor_ * bendScale(lengthPixels, share); }
  double bendFactor() const { return bendFactor_; }
  double widthPixels() const { return widthPixels_; }

 private:
  /// What bends grow with.
  double bendScale(double lengthPixels, double share) const {
    return share * (lengthPixels + widthPixels_ * share) + lengthPixels * lengthPixels / (16 * widthPixels_);
  }
  /// Whether all points are projected by the closed form.
  bool isClosedForm() const { return transition_.model() == ArcModel::kConic && !transition_.isStraight(); }
  BendSetup makeSetup() const;
  std::optional<glm::dvec3> middleOf(const glm::dvec3& point) const;
  double measureBends(const CurvedRayCamera& camera, size_t bend) const;

  RayTransition transition_;
  BendBounds bounds_;
  BendSetup setup_;
  double widthPixels_;
  double bendFactor_ = 0;
};

}  // namespace ocelli
