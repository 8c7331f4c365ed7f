#include "oc_core/render/turn_projection.h"

#include <algorithm>
#include <cmath>

#include "oc_core/base/random.h"

namespace ocelli {
namespace {

/// Beyond this, coordinates of images are as good as none, pixels.
constexpr double kMostPixels = 1e6;
/// Weights are at least this share of those in the middle plane.
constexpr double kLeastWeight = 0.05;
/// Edges to measure bends on, and room for what they leave out.
constexpr int kMeasured = 1000;
constexpr double kRoom = 2;

HalfSpace moved(const HalfSpace& space, const glm::dvec3& origin) {
  return {glm::dvec3(space), glm::dot(space, glm::dvec4(origin, 1))};
}
double height(const HalfSpace& space, const glm::dvec3& p) {
  return glm::dot(glm::dvec3(space), p) + space.w;
}

}  // namespace

TurnProjection::TurnProjection(const CurvedRayCamera& camera, size_t turn)
    : bounds_(camera, turn),
      straight_(camera.turns()[turn].isStraight()),
      origin_(camera.turns()[turn].before()),
      beyond_(camera.turns()[turn].beyond() - origin_),
      axis_(straight_ ? glm::dvec3(0) : glm::normalize(beyond_)),
      linePoint_(camera.turns()[turn].linePoint() - origin_),
      lineDirection_(camera.turns()[turn].lineDirection()),
      border_(camera.turns()[turn].border() - origin_),
      from_(moved(beyond(camera.turns()[turn].planes().from), origin_)),
      to_(moved(beyond(camera.turns()[turn].planes().to), origin_)),
      widthPixels_(camera.width() / 4.0),
      bendFactor_(measureBends(camera, turn)) {}

TurnImage TurnProjection::project(const glm::dvec3& point) const {
  TurnImage image;
  const glm::dvec3 p = point - origin_;
  image.behindFirst = std::max(height(from_, p), 0.0);
  image.beforeLast = std::max(-height(to_, p), 0.0);
  glm::dvec3 middle = p;  // of the ray
  if (!straight_) {
    // As RayTransition::find(): the epipolar plane, A, the control points of b, and the collineation that takes b to
    // the arc of the point.
    const glm::dvec3 normal = glm::cross(axis_, p);
    const double along = glm::dot(normal, lineDirection_);
    if (!(along * along > 1e-24 * glm::dot(normal, normal))) {
      return image;
    }
    const double perAlong = 1 / along;
    const glm::dvec3 a = linePoint_ - lineDirection_ * (glm::dot(normal, linePoint_) * perAlong);
    const glm::dvec3 s = border_ - lineDirection_ * (glm::dot(normal, border_) * perAlong);
    const glm::dvec3 t = s * (from_.w / (from_.w - height(from_, s)));
    const double heightBeyond = height(to_, beyond_);
    const double heightS = height(to_, s);
    const glm::dvec3 q = (s * heightBeyond - beyond_ * heightS) / (heightBeyond - heightS);
    const glm::dvec3 up = glm::cross(normal, axis_);
    const glm::dvec3 side = glm::cross(normal, p - a);
    const double u = bernsteinRoot(glm::dot(side, t - a), glm::dot(side, s - a), glm::dot(side, q - a));
    const double bt = (1 - u) * (1 - u);
    const double bs = 2 * u * (1 - u);
    const double bq = u * u;
    const glm::dvec3 onB = t * bt + s * bs + q * bq;
    const glm::dvec3 towards = a - onB;
    const double share = glm::dot(p - onB, towards) / glm::dot(towards, towards);
    const double heightMiddle = glm::dot(up, s);
    const double mu = share / (1 - share) * heightMiddle / glm::dot(up, onB);
    if (!(share < 1) || !(1 + mu > 0)) {
      return image;
    }
    middle = (s + a * mu) / (1 + mu);
  }
  const glm::dvec4 h = bounds_.before() * glm::dvec4(middle + origin_, 1);
  image.pixel = {h.x / h.w, h.y / h.w};
  const auto weightBy = [&](const glm::dmat4& m) {
    const double weight = m[0][3] * point.x + m[1][3] * point.y + m[2][3] * point.z + m[3][3];
    return std::max(weight, kLeastWeight * h.w);
  };
  const double share = image.share();
  image.weight = (1 - share) * weightBy(bounds_.before()) + share * weightBy(bounds_.after());
  image.imaged = h.w > 0 && std::abs(image.pixel.x) < kMostPixels && std::abs(image.pixel.y) < kMostPixels;
  return image;
}

double TurnProjection::bend(const TurnImage& a, const TurnImage& b, const TurnImage& middle) const {
  // In perspective the middle comes nearer to the end that is farther away.
  const glm::dvec2 straight = (a.pixel * a.weight + b.pixel * b.weight) / (a.weight + b.weight);
  return glm::distance(middle.pixel, straight);
}

/// The largest ratio of the bend of an edge to what greatestBend() takes it to grow with.
double TurnProjection::measureBends(const CurvedRayCamera& camera, size_t turn) const {
  // Points all over the turn: on a curve over the control points of some ray.
  Random random(1);
  const auto anyPoint = [&] {
    const double u = static_cast<double>(random.inRange(0, static_cast<float>(camera.width())));
    const double v = static_cast<double>(random.inRange(0, static_cast<float>(camera.height())));
    const TurnCorners c = cornersOf(camera, turn, {u, v});
    const double share = static_cast<double>(random.inRange(0, 1));
    return c.t * ((1 - share) * (1 - share)) + c.s * (2 * share * (1 - share)) + c.q * (share * share);
  };
  double most = 0;
  for (int i = 0; i < kMeasured; ++i) {
    const glm::dvec3 a = anyPoint();
    // Short edges and long ones.
    const glm::dvec3 b = a + (anyPoint() - a) * static_cast<double>(random.inRange(0.02f, 1));
    const TurnImage imageA = project(a);
    const TurnImage imageB = project(b);
    const TurnImage middle = project((a + b) * 0.5);
    const double share = std::abs(imageA.share() - imageB.share());
    const double scale = bendScale(glm::distance(imageA.pixel, imageB.pixel), share);
    if (imageA.imaged && imageB.imaged && middle.imaged && scale > 1e-6) {
      most = std::max(most, bend(imageA, imageB, middle) / scale);
    }
  }
  return kRoom * most;
}

}  // namespace ocelli
