// Where a turn of a curved ray camera shows points, as RayTransition::find() has it, but with all that points have in
// common worked out beforehand; and how straight it shows edges.
#pragma once

#include "oc_core/render/turn_bounds.h"

namespace ocelli {

/// The image of a point of a turn.
struct TurnImage {
  glm::dvec2 pixel{0};
  /// Any weight would do; one between those before and behind the turn shows edges the straightest.
  double weight = 0;
  double behindFirst = 0;  ///< distance from the first plane of the turn
  double beforeLast = 0;   ///< from the last plane
  bool imaged = false;

  /// Of the turn that is passed, from 0 to 1: planes through the line that those of the turn have in common cut it off.
  double share() const { return behindFirst > 0 ? behindFirst / (behindFirst + beforeLast) : 0; }
};

class TurnProjection {
 public:
  TurnProjection(const CurvedRayCamera& camera, size_t turn);

  const TurnBounds& bounds() const { return bounds_; }

  /// Of a point between the first and the last plane, but for rounding.
  TurnImage project(const glm::dvec3& point) const;

  /// How far the middle of an edge comes out from where a straight one, in perspective, would have it, pixels.
  double bend(const TurnImage& a, const TurnImage& b, const TurnImage& middle) const;
  /// At most that, for an edge whose ends come out so far apart, and which passes so large a share of the turn. Edges
  /// in a plane through the line of the turn do not bend, but come out of other proportions than weights tell. The
  /// factor is measured, on edges all over the turn.
  double greatestBend(double lengthPixels, double share) const { return bendFactor_ * bendScale(lengthPixels, share); }
  double bendFactor() const { return bendFactor_; }
  double widthPixels() const { return widthPixels_; }

 private:
  /// What bends grow with.
  double bendScale(double lengthPixels, double share) const {
    return share * (lengthPixels + widthPixels_ * share) + lengthPixels * lengthPixels / (16 * widthPixels_);
  }
  std::optional<glm::dvec3> middleOf(const glm::dvec3& point) const;
  double measureBends(const CurvedRayCamera& camera, size_t turn) const;

  RayTransition transition_;
  TurnBounds bounds_;
  // Places are taken from C0.
  glm::dvec3 origin_;
  glm::dvec3 beyond_;  ///< C1
  glm::dvec3 axis_;
  glm::dvec3 linePoint_;
  glm::dvec3 lineDirection_;
  glm::dvec3 border_;
  HalfSpace from_;
  HalfSpace to_;
  double widthPixels_;
  double bendFactor_ = 0;
};

}  // namespace ocelli
