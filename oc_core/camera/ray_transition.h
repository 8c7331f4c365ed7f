// The transition of the curved ray camera (section 4.2.2, Appendix B): where rays that come from one viewpoint, C0,
// bend into rays of another, C1, along conics that are tangent to both.
//
// Three planes t0, t1 and t2 that meet in a line l define it. A ray meets t0 at T and would meet t1 at S; the ray of C1
// through S meets t2 at Q. In an epipolar plane, one through C0 and C1, one ray is the quadratic Bezier arc over its T,
// S and Q (Equation 4.1). All others are images of that arc b under the perspective collineation whose centre is A, the
// point of l in the plane, and whose axis is the line C0C1; it takes t0, t1 and t2 into themselves. So they are
// rational Bezier arcs, over T, S and Q, whose weights are those that the collineation gives the control points of b.
//
// To project P is to find the point P_n of b on the line AP, a root of a quadratic; P and P_n then say which
// collineation it is, and that takes the S of b to the S of the ray. This is the construction of 4.2.2.1, but it holds
// up next to t2 too, where the line P_nQ_n of the text is not defined.
//
// The arc b is that of the rays through a line in t1 parallel to l: the border of the image, as far from l as any ray
// is (the text's "left-most" ray). Weights are positive then.
//
// The text's first model (section 4.2.1) has the same T, S and Q, and for every ray the polynomial arc over them. No
// closed form gives its projection, so the arc through a point is searched for: it is there to follow rays, and to
// compare with.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "oc_core/camera/plane.h"
#include "oc_core/camera/ray_path.h"

namespace ocelli {

/// Normals point the way that rays run.
struct TransitionPlanes {
  Plane from;    ///< t0
  Plane middle;  ///< t1
  Plane to;      ///< t2
};

enum class ArcModel {
  kConic,   ///< rational arcs, projected by a closed form
  kBezier,  ///< polynomial arcs (Equation 4.1), projected by bisection
};

/// The root in [0, 1] of the quadratic with these Bernstein coefficients, of which the first and the last differ in
/// sign, but for rounding at the ends.
double bernsteinRoot(double b0, double b1, double b2);

class RayTransition {
 public:
  /// Where a ray bends: its control points, and their weights.
  struct Arc {
    glm::dvec3 t{0};
    glm::dvec3 s{0};
    glm::dvec3 q{0};
    glm::dvec3 weights{1};

    glm::dvec3 at(double parameter) const;
    /// Its direction at the parameter, not normalised.
    glm::dvec3 tangent(double parameter) const;
    /// Length of the control polygon.
    double length() const { return glm::distance(t, s) + glm::distance(s, q); }
  };
  /// The arc that a point lies on, and where.
  struct Place {
    Arc arc;
    double parameter = 0;
  };

  /// `border` is a point of t1 that no ray passes farther away from l. The planes meet in a line, which is not parallel
  /// to the line C0C1.
  RayTransition(const TransitionPlanes& planes, const glm::dvec3& before, const glm::dvec3& beyond,
                const glm::dvec3& border, ArcModel model = ArcModel::kConic);

  const TransitionPlanes& planes() const { return planes_; }
  const glm::dvec3& before() const { return before_; }  ///< C0
  const glm::dvec3& beyond() const { return beyond_; }  ///< C1
  const glm::dvec3& border() const { return border_; }
  const glm::dvec3& linePoint() const { return linePoint_; }  ///< of l
  const glm::dvec3& lineDirection() const { return lineDirection_; }
  ArcModel model() const { return model_; }
  bool isStraight() const { return straight_; }  ///< C0 is C1: rays do not bend

  /// The arc of the ray that meets t1 at S.
  Arc arcThrough(const glm::dvec3& s) const;
  /// For a point between t0 and t2. Nothing where its epipolar plane holds no arc.
  std::optional<Place> find(const glm::dvec3& point) const;

  /// How far along an arc a point is, from 0 to 1: for a ray that does not bend, the share of its length. It grows
  /// along every arc.
  double shareAt(const Place& place) const;
  /// Points of an arc at equal steps of its parameter, its ends among them, and how far along it each is.
  struct ArcPoints {
    static constexpr size_t kMaxCount = RayPath::kMaxPoints;
    // Without initial values: there is room for as many as a ray may have, for every ray.
    std::array<double, kMaxCount> x;
    std::array<double, kMaxCount> y;
    std::array<double, kMaxCount> z;
    std::array<double, kMaxCount> share;
  };
  /// `count` of them, from 2 to the most: what Arc::at() and shareAt() say one by one, up to rounding.
  void pointsOf(const Arc& arc, size_t count, ArcPoints& points) const;
  /// The parameter at which the share is so much.
  double parameterAt(const Arc& arc, double share) const;

 private:
  /// What an epipolar plane holds: A, the control points of b, and how far these are from the line C0C1.
  struct Epipolar {
    glm::dvec3 normal{0};
    glm::dvec3 a{0};
    Arc b;
    glm::dvec3 heights{0};
  };
  std::optional<Epipolar> epipolarThrough(const glm::dvec3& point) const;
  Arc arcOf(const glm::dvec3& s, const glm::dvec3& weights) const;
  /// How far a point of an arc is behind t0, and before t2, along the arc's first and last way.
  double fromStart(const Arc& arc, const glm::dvec3& point) const;
  double toEnd(const Arc& arc, const glm::dvec3& point) const;
  /// Where an arc with weights of 1 meets the line from A through a point.
  static double parameterOnLine(const Epipolar& plane, const glm::dvec3& point, const Arc& arc);
  std::optional<Place> findConic(const Epipolar& plane, const glm::dvec3& point) const;
  std::optional<Place> findBezier(const Epipolar& plane, const glm::dvec3& point) const;

  TransitionPlanes planes_;
  glm::dvec3 before_;
  glm::dvec3 beyond_;
  glm::dvec3 linePoint_{0};
  glm::dvec3 lineDirection_{0};  ///< of l, and of the border in t1
  glm::dvec3 border_;
  ArcModel model_;
  bool straight_;
};

}  // namespace ocelli
