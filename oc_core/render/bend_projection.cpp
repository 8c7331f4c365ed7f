#include "oc_core/render/bend_projection.h"

#include <algorithm>
#include <cmath>

#include "oc_core/base/random.h"

namespace ocelli {
namespace {

/// Image coordinates beyond this, in pixels, are of no use.
constexpr double kMaxPixels = 1e6;
/// Weights are at least this share of those in the middle plane.
constexpr double kMinWeight = 0.05;
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

BendProjection::BendProjection(const CurvedRayCamera& camera, size_t bend)
    : transition_(camera.bends()[bend]),
      bounds_(camera, bend),
      setup_(makeSetup()),
      widthPixels_(camera.width() / 4.0),
      bendFactor_(measureBends(camera, bend)) {}

BendSetup BendProjection::makeSetup() const {
  const glm::dvec3 origin = transition_.before();
  const glm::dvec3 beyondOrigin = transition_.beyond() - origin;
  return {origin,
          beyondOrigin,
          transition_.isStraight() ? glm::dvec3(0) : glm::normalize(beyondOrigin),
          transition_.linePoint() - origin,
          transition_.lineDirection(),
          transition_.border() - origin,
          moved(beyond(transition_.planes().from), origin),
          moved(beyond(transition_.planes().to), origin),
          bounds_.slab()[0],
          bounds_.slab()[1],
          bounds_.before(),
          bounds_.after(),
          kMaxPixels,
          kMinWeight};
}

/// Where the ray of a point meets the middle plane.
std::optional<glm::dvec3> BendProjection::middleOf(const glm::dvec3& point) const {
  if (!isClosedForm()) {
    const std::optional<RayTransition::Place> place = transition_.find(point);
    return place ? std::optional(place->arc.s) : std::nullopt;
  }
  // As RayTransition::find(): the epipolar plane, A, the control points of b, and the collineation that takes b to the
  // arc of the point.
  const glm::dvec3 p = point - setup_.origin;
  const glm::dvec3 normal = glm::cross(setup_.axis, p);
  const double along = glm::dot(normal, setup_.lineDirection);
  if (!(along * along > 1e-24 * glm::dot(normal, normal))) {
    return std::nullopt;
  }
  const double perAlong = 1 / along;
  const glm::dvec3 a = setup_.linePoint - setup_.lineDirection * (glm::dot(normal, setup_.linePoint) * perAlong);
  const glm::dvec3 s = setup_.border - setup_.lineDirection * (glm::dot(normal, setup_.border) * perAlong);
  const glm::dvec3 t = s * (setup_.from.w / (setup_.from.w - height(setup_.from, s)));
  const double heightBeyond = height(setup_.to, setup_.beyond);
  const double heightS = height(setup_.to, s);
  const glm::dvec3 q = (s * heightBeyond - setup_.beyond * heightS) / (heightBeyond - heightS);
  const glm::dvec3 up = glm::cross(normal, setup_.axis);
  const glm::dvec3 side = glm::cross(normal, p - a);
  const double u = bernsteinRoot(glm::dot(side, t - a), glm::dot(side, s - a), glm::dot(side, q - a));
  const glm::dvec3 onB = t * ((1 - u) * (1 - u)) + s * (2 * u * (1 - u)) + q * (u * u);
  const glm::dvec3 towards = a - onB;
  const double share = glm::dot(p - onB, towards) / glm::dot(towards, towards);
  const double mu = share / (1 - share) * glm::dot(up, s) / glm::dot(up, onB);
  const bool isHeld = share < 1 && 1 + mu > 0;
  return isHeld ? std::optional(setup_.origin + (s + a * mu) / (1 + mu)) : std::nullopt;
}

BendImage BendProjection::project(const glm::dvec3& point) const {
  BendImage image;
  image.behindFirst = std::max(height(bounds_.slab()[0], point), 0.0);
  image.beforeLast = std::max(height(bounds_.slab()[1], point), 0.0);
  const std::optional<glm::dvec3> middle = middleOf(point);
  if (!middle) {
    return image;
  }
  const glm::dvec4 h = bounds_.before() * glm::dvec4(*middle, 1);
  image.pixel = {h.x / h.w, h.y / h.w};
  const auto weightBy = [&](const glm::dmat4& m) {
    const double weight = m[0][3] * point.x + m[1][3] * point.y + m[2][3] * point.z + m[3][3];
    return std::max(weight, kMinWeight * h.w);
  };
  const double share = image.share();
  image.weight = (1 - share) * weightBy(bounds_.before()) + share * weightBy(bounds_.after());
  image.imaged = h.w > 0 && std::abs(image.pixel.x) < kMaxPixels && std::abs(image.pixel.y) < kMaxPixels;
  return image;
}

void BendProjection::project(const BlockVertices& points, BendImages& images) const {
  if (isClosedForm()) {
    projectBlock(setup_, points, images);
    return;
  }
  for (size_t i = 0; i < points.size(); ++i) {
    const BendImage image = project(glm::dvec3(points.position(i)));
    images.u[i] = image.pixel.x;
    images.v[i] = image.pixel.y;
    images.weight[i] = image.weight;
    images.behindFirst[i] = image.behindFirst;
    images.beforeLast[i] = image.beforeLast;
    images.share[i] = image.share();
    images.imaged[i] = image.imaged ? ~uint64_t{0} : 0;
    const glm::dvec4 p(points.position(i), 1);
    images.outside[i] = (glm::dot(setup_.first, p) < 0 ? BendImages::kBeforeFirst : 0) |
                        (glm::dot(setup_.last, p) < 0 ? BendImages::kBeyondLast : 0);
  }
  images.findCells(points.size());
}

double BendProjection::deviation(const BendImage& a, const BendImage& b, const BendImage& middle) const {
  // In perspective the middle comes nearer to the end that is farther away.
  const glm::dvec2 straight = (a.pixel * a.weight + b.pixel * b.weight) / (a.weight + b.weight);
  return glm::distance(middle.pixel, straight);
}

/// The largest ratio of the bend of an edge to what greatestBend() takes it to grow with.
double BendProjection::measureBends(const CurvedRayCamera& camera, size_t bend) const {
  // Points all over the bend: on a curve over the control points of some ray.
  Random random(1);
  const auto anyPoint = [&] {
    const double u = static_cast<double>(random.inRange(0, static_cast<float>(camera.width())));
    const double v = static_cast<double>(random.inRange(0, static_cast<float>(camera.height())));
    const BendCorners c = cornersOf(camera, bend, {u, v});
    const double share = static_cast<double>(random.inRange(0, 1));
    return c.t * ((1 - share) * (1 - share)) + c.s * (2 * share * (1 - share)) + c.q * (share * share);
  };
  double most = 0;
  for (int i = 0; i < kMeasured; ++i) {
    const glm::dvec3 a = anyPoint();
    // Short edges and long ones.
    const glm::dvec3 b = a + (anyPoint() - a) * static_cast<double>(random.inRange(0.02f, 1));
    const BendImage imageA = project(a);
    const BendImage imageB = project(b);
    const BendImage middle = project((a + b) * 0.5);
    const double share = std::abs(imageA.share() - imageB.share());
    const double scale = bendScale(glm::distance(imageA.pixel, imageB.pixel), share);
    if (imageA.imaged && imageB.imaged && middle.imaged && scale > 1e-6) {
      most = std::max(most, deviation(imageA, imageB, middle) / scale);
    }
  }
  return kRoom * most;
}

}  // namespace ocelli
