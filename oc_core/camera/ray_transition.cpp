#include "oc_core/camera/ray_transition.h"

#include <algorithm>
#include <cmath>

#include "oc_core/base/check.h"

namespace ocelli {
namespace {

/// Where a line crosses the plane through `on` with this normal.
std::optional<glm::dvec3> crossing(const glm::dvec3& point, const glm::dvec3& direction, const glm::dvec3& on,
                                   const glm::dvec3& normal) {
  const double along = glm::dot(normal, direction);
  if (std::abs(along) < 1e-12 * glm::length(normal) * glm::length(direction)) {
    return std::nullopt;
  }
  return point + direction * (glm::dot(normal, on - point) / along);
}

}  // namespace

double bernsteinRoot(double b0, double b1, double b2) {
  const double sign = std::abs(b0) > std::abs(b2) ? (b0 > 0 ? 1 : -1) : (b2 < 0 ? 1 : -1);
  b0 *= sign;
  b1 *= sign;
  b2 *= sign;
  if (!(b0 > 0) || !(b2 < 0)) {
    return b0 > 0 ? 1 : 0;
  }
  // For r = t / (1-t) it is b2 r^2 + 2 b1 r + b0 = 0. Of the two forms of its positive root the one that does not
  // cancel.
  const double root = std::sqrt(b1 * b1 - b0 * b2);
  const double numerator = b1 >= 0 ? b1 + root : b0;
  const double denominator = b1 >= 0 ? -b2 : root - b1;
  return numerator / (numerator + denominator);
}

glm::dvec3 RayTransition::Arc::at(double u) const {
  const glm::dvec3 b = glm::dvec3((1 - u) * (1 - u), 2 * u * (1 - u), u * u) * weights;
  return (t * b.x + s * b.y + q * b.z) / (b.x + b.y + b.z);
}

glm::dvec3 RayTransition::Arc::tangent(double u) const {
  // Of a rational curve N / w: (N' - N/w w') / w.
  const glm::dvec3 b = glm::dvec3((1 - u) * (1 - u), 2 * u * (1 - u), u * u) * weights;
  const glm::dvec3 slope = glm::dvec3(-2 * (1 - u), 2 - 4 * u, 2 * u) * weights;
  const double w = b.x + b.y + b.z;
  return (t * slope.x + s * slope.y + q * slope.z - at(u) * (slope.x + slope.y + slope.z)) / w;
}

RayTransition::RayTransition(const TransitionPlanes& planes, const glm::dvec3& before, const glm::dvec3& beyond,
                             const glm::dvec3& border, ArcModel model)
    : planes_(planes),
      before_(before),
      beyond_(beyond),
      border_(border),
      model_(model),
      straight_(glm::distance(before, beyond) < 1e-12 * (1 + glm::length(before))) {
  const glm::dvec3 along = glm::cross(planes.from.normal, planes.to.normal);
  lineDirection_ = glm::normalize(along);
  linePoint_ = (glm::cross(planes.to.normal, along) * planes.from.distance +
                glm::cross(along, planes.from.normal) * planes.to.distance) /
               glm::dot(along, along);
}

RayTransition::Arc RayTransition::arcOf(const glm::dvec3& s, const glm::dvec3& weights) const {
  return {planes_.from.crossing(before_, s), s, planes_.to.crossing(beyond_, s), weights};
}

std::optional<RayTransition::Epipolar> RayTransition::epipolarThrough(const glm::dvec3& point) const {
  const glm::dvec3 axis = glm::normalize(beyond_ - before_);
  Epipolar plane;
  plane.normal = glm::cross(axis, point - before_);
  const auto a = crossing(linePoint_, lineDirection_, before_, plane.normal);
  const auto s = crossing(border_, lineDirection_, before_, plane.normal);
  if (!a || !s) {
    return std::nullopt;
  }
  plane.a = *a;
  plane.b = arcOf(*s, glm::dvec3(1));
  // Distances from the axis, in the plane.
  const glm::dvec3 up = glm::normalize(glm::cross(plane.normal, axis));
  const auto height = [&](const glm::dvec3& p) { return glm::dot(up, p - before_); };
  plane.heights = {height(plane.b.t), height(plane.b.s), height(plane.b.q)};
  return plane;
}

RayTransition::Arc RayTransition::arcThrough(const glm::dvec3& s) const {
  if (straight_ || model_ == ArcModel::kBezier) {
    return arcOf(s, glm::dvec3(1));
  }
  const auto plane = epipolarThrough(s);
  if (!plane) {
    return arcOf(s, glm::dvec3(1));
  }
  // X goes to X + mu height(X) A, with weight 1 + mu height(X): what takes the S of b to this one.
  const glm::dvec3 towards = plane->a - plane->b.s;
  const double share = glm::dot(s - plane->b.s, towards) / glm::dot(towards, towards);
  const double mu = share / (1 - share) / plane->heights.y;
  return arcOf(s, 1.0 + mu * plane->heights);
}

double RayTransition::parameterOnLine(const Epipolar& plane, const glm::dvec3& point, const Arc& arc) {
  const glm::dvec3 side = glm::cross(plane.normal, point - plane.a);
  const auto beside = [&](const glm::dvec3& p) { return glm::dot(side, p - plane.a); };
  return bernsteinRoot(beside(arc.t), beside(arc.s), beside(arc.q));
}

std::optional<RayTransition::Place> RayTransition::find(const glm::dvec3& point) const {
  if (straight_) {
    const glm::dvec3 s = planes_.middle.crossing(before_, point);
    const Arc arc = arcOf(s, glm::dvec3(1));
    const double share = glm::distance(arc.t, point) / std::max(glm::distance(arc.t, arc.q), 1e-300);
    return Place{arc, parameterAt(arc, share)};
  }
  const auto plane = epipolarThrough(point);
  if (!plane) {
    return std::nullopt;
  }
  return model_ == ArcModel::kConic ? findConic(*plane, point) : findBezier(*plane, point);
}

std::optional<RayTransition::Place> RayTransition::findConic(const Epipolar& plane, const glm::dvec3& point) const {
  const double parameter = parameterOnLine(plane, point, plane.b);  // of P_n
  const glm::dvec3 onB = plane.b.at(parameter);
  // The collineation that takes P_n to P takes the S of b to that of the ray.
  const glm::dvec3 towards = plane.a - onB;
  const double share = glm::dot(point - onB, towards) / glm::dot(towards, towards);
  const double u = parameter;
  const double height = glm::dot(plane.heights, glm::dvec3((1 - u) * (1 - u), 2 * u * (1 - u), u * u));
  if (!(share < 1) || height == 0) {
    return std::nullopt;
  }
  const double mu = share / (1 - share) / height;
  const double weight = 1 + mu * plane.heights.y;
  if (!(weight > 0)) {
    return std::nullopt;
  }
  const glm::dvec3 s = (plane.b.s + plane.a * (mu * plane.heights.y)) / weight;
  return Place{arcOf(s, 1.0 + mu * plane.heights), parameter};
}

/// The rays of an epipolar plane lie one beside the other between A and b and beyond b, so the one through a point is
/// found by bisection along the line AP.
std::optional<RayTransition::Place> RayTransition::findBezier(const Epipolar& plane, const glm::dvec3& point) const {
  const glm::dvec3 outwards = plane.b.s - plane.a;
  const double wanted = glm::length(point - plane.a);
  const auto placeOf = [&](double share) {
    const Arc arc = arcOf(plane.a + outwards * share, glm::dvec3(1));
    return Place{arc, parameterOnLine(plane, point, arc)};
  };
  const auto isTooFar = [&](double share) {
    const Place place = placeOf(share);
    return glm::length(place.arc.at(place.parameter) - plane.a) > wanted;
  };
  constexpr double kMaxShare = 16;  // of the way from A to b: far beyond the border of the image
  double inner = 0;
  double outer = 1;
  while (!isTooFar(outer)) {
    if (outer > kMaxShare) {
      return std::nullopt;
    }
    inner = outer;
    outer *= 2;
  }
  for (double middle = (inner + outer) / 2; inner < middle && middle < outer; middle = (inner + outer) / 2) {
    (isTooFar(middle) ? outer : inner) = middle;
  }
  return placeOf(inner);
}

double RayTransition::fromStart(const Arc& arc, const glm::dvec3& point) const {
  return planes_.from.height(point) / glm::dot(planes_.from.normal, glm::normalize(arc.s - arc.t));
}

double RayTransition::toEnd(const Arc& arc, const glm::dvec3& point) const {
  return -planes_.to.height(point) / glm::dot(planes_.to.normal, glm::normalize(arc.q - arc.s));
}

double RayTransition::shareAt(const Place& place) const {
  const glm::dvec3 point = place.arc.at(place.parameter);
  const double from = fromStart(place.arc, point);
  const double to = toEnd(place.arc, point);
  return from + to > 0 ? std::clamp(from / (from + to), 0.0, 1.0) : 0;
}

void RayTransition::pointsOf(const Arc& arc, size_t count, ArcPoints& points) const {
  OC_CHECK(count >= 2 && count <= ArcPoints::kMaxCount, "an arc has 2 points or more, as many as a ray may have");
  // Both distances are linear, so a point's are the mean of those of the control points, with the same weights; t lies
  // on t0 and q on t2.
  const double fromS = fromStart(arc, arc.s);
  const double fromQ = fromStart(arc, arc.q);
  const double toT = toEnd(arc, arc.t);
  const double toS = toEnd(arc, arc.s);
  const auto last = static_cast<double>(count - 1);
  // Without std::clamp, and with a whole number that converts in vectors: compilers make vectors of this loop.
  for (size_t k = 0; k < count; ++k) {
    const double u = static_cast<double>(static_cast<int>(k)) / last;
    const double v = 1 - u;
    const double ofT = v * v * arc.weights.x;
    const double ofS = 2 * u * v * arc.weights.y;
    const double ofQ = u * u * arc.weights.z;
    const double scale = 1 / (ofT + ofS + ofQ);
    points.x[k] = (arc.t.x * ofT + arc.s.x * ofS + arc.q.x * ofQ) * scale;
    points.y[k] = (arc.t.y * ofT + arc.s.y * ofS + arc.q.y * ofQ) * scale;
    points.z[k] = (arc.t.z * ofT + arc.s.z * ofS + arc.q.z * ofQ) * scale;
    const double from = fromS * ofS + fromQ * ofQ;
    const double sum = from + toT * ofT + toS * ofS;
    const double share = from / sum;
    const double atMost = share < 1 ? share : 1;
    points.share[k] = sum > 0 && atMost > 0 ? atMost : 0;
  }
}

double RayTransition::parameterAt(const Arc& arc, double share) const {
  const double from = (1 - share) / glm::dot(planes_.from.normal, glm::normalize(arc.s - arc.t));
  const double to = share / glm::dot(planes_.to.normal, glm::normalize(arc.q - arc.s));
  // Heights above t0 and below t2 of a rational arc have its weights; those of its ends on the planes are 0.
  return bernsteinRoot(to * arc.weights.x * planes_.to.height(arc.t),
                       arc.weights.y * (from * planes_.from.height(arc.s) + to * planes_.to.height(arc.s)),
                       from * arc.weights.z * planes_.from.height(arc.q));
}

}  // namespace ocelli
