#include "oc_core/constructor/plan_polygon.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>

namespace ocelli {
namespace {

/// Of its area, or of a length of its size: less is rounding.
constexpr double kNothing = 1e-9;

/// How far to the right of the line from -> to a point lies.
double rightOfLine(const glm::dvec2& from, const glm::dvec2& to, const glm::dvec2& point) {
  return planCross(to - from, point - from) / glm::length(to - from);
}

/// The largest distance between the polygons beyond a side of `one`.
double gapBeyondSides(const PlanPolygon& one, const PlanPolygon& other) {
  double gap = -std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < one.size(); ++i) {
    double innermost = -std::numeric_limits<double>::infinity();
    for (const glm::dvec2& point : other) {
      innermost = std::max(innermost, rightOfLine(one[i], one[(i + 1) % one.size()], point));
    }
    gap = std::max(gap, -innermost);
  }
  return gap;
}

}  // namespace

double planArea(const PlanPolygon& polygon) {
  double twice = 0;
  for (size_t i = 1; i + 1 < polygon.size(); ++i) {
    twice += planCross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
  }
  return twice / 2;
}

PlanPolygon planHull(std::vector<glm::dvec2> points) {
  const auto before = [](const glm::dvec2& a, const glm::dvec2& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; };
  std::sort(points.begin(), points.end(), before);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) {
    return {};
  }
  const double size = glm::distance(points.front(), points.back());
  // The chain above and the one below, each from end to end.
  PlanPolygon hull;
  for (int chain = 0; chain < 2; ++chain) {
    const size_t first = hull.size();
    for (const glm::dvec2& point : points) {
      while (hull.size() >= first + 2 && !(rightOfLine(hull[hull.size() - 2], hull.back(), point) > kNothing * size)) {
        hull.pop_back();
      }
      hull.push_back(point);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull.size() >= 3 ? hull : PlanPolygon{};
}

PlanPolygon planRightOf(const PlanPolygon& polygon, const glm::dvec2& from, const glm::dvec2& to) {
  PlanPolygon kept;
  for (size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec2& a = polygon[i];
    const glm::dvec2& b = polygon[(i + 1) % polygon.size()];
    const double sideA = rightOfLine(from, to, a);
    const double sideB = rightOfLine(from, to, b);
    if (sideA >= 0) {
      kept.push_back(a);
    }
    if ((sideA > 0 && sideB < 0) || (sideA < 0 && sideB > 0)) {
      kept.push_back(a + (b - a) * (sideA / (sideA - sideB)));
    }
  }
  return kept.size() >= 3 && planArea(kept) > kNothing * planArea(polygon) ? kept : PlanPolygon{};
}

double planPenetration(const PlanPolygon& one, const PlanPolygon& other) {
  return one.empty() || other.empty() ? 0 : -std::max(gapBeyondSides(one, other), gapBeyondSides(other, one));
}

std::optional<std::pair<double, double>> planSpan(const PlanPolygon& polygon, const glm::dvec2& from,
                                                  const glm::dvec2& to, double rounding) {
  double begin = -std::numeric_limits<double>::infinity();
  double end = std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec2& a = polygon[i];
    const glm::dvec2& b = polygon[(i + 1) % polygon.size()];
    const double inside = rightOfLine(a, b, from) + rounding;
    const double slope = rightOfLine(a, b, to) + rounding - inside;
    if (std::abs(slope) <= kNothing * glm::distance(from, to)) {
      if (inside < 0) {
        return std::nullopt;
      }
    } else if (slope > 0) {
      begin = std::max(begin, -inside / slope);
    } else {
      end = std::min(end, -inside / slope);
    }
  }
  return begin < end ? std::optional(std::pair(begin, end)) : std::nullopt;
}

double planOutside(const PlanPolygon& polygon, const glm::dvec2& point) {
  double outside = -std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < polygon.size(); ++i) {
    outside = std::max(outside, -rightOfLine(polygon[i], polygon[(i + 1) % polygon.size()], point));
  }
  return outside;
}

}  // namespace ocelli
