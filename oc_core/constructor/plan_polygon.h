// Convex polygons in the plan: points are (x, z) of the scene, seen from above with x to the right and z down, so that
// positive angles run clockwise. All results are the same whatever the unit.
#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace ocelli {

/// Corners clockwise as seen from above.
using PlanPolygon = std::vector<glm::dvec2>;

/// Positive where `b` lies clockwise of `a`.
inline double planCross(const glm::dvec2& a, const glm::dvec2& b) {
  return a.x * b.y - a.y * b.x;
}

double planArea(const PlanPolygon& polygon);

/// The smallest one around the points; empty where they lie on a line.
PlanPolygon planHull(std::vector<glm::dvec2> points);

/// What lies to the right of the line from -> to, who looks along it; empty where that is a 1e-9th of the polygon or
/// less.
PlanPolygon planRightOf(const PlanPolygon& polygon, const glm::dvec2& from, const glm::dvec2& to);

/// How deep two of them lie in each other: how far one must be moved for them to touch only. 0 or less where they are
/// apart.
double planPenetration(const PlanPolygon& one, const PlanPolygon& other);

/// The part of the line through two points, from the first one on, that lies in the polygon or on its border, give or
/// take `rounding`: how far from `from` it begins and ends, in distances of the two points. Nothing where it misses.
std::optional<std::pair<double, double>> planSpan(const PlanPolygon& polygon, const glm::dvec2& from,
                                                  const glm::dvec2& to, double rounding);

/// How far outside of the polygon a point lies, 0 or less within.
double planOutside(const PlanPolygon& polygon, const glm::dvec2& point);

}  // namespace ocelli
