#include "oc_core/ambient/three_frusta.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

#include "oc_core/base/conventions.h"
#include "oc_core/base/error.h"
#include "oc_core/camera/exact_image_point.h"

namespace ocelli {
namespace {

const glm::dvec3 kUp(0, 1, 0);
/// Of the scene's extents along the headings, the least difference that makes it long: rounder scenes are never split
/// in their middle as much.
constexpr double kMinLength = 0.25;
/// Behind the scene, in halves of its extent.
constexpr double kBehindAll = 1.05;

double smoothed(double share) {
  const double x = std::clamp(share, 0.0, 1.0);
  return x * x * (3 - 2 * x);
}

glm::dvec3 headingOf(int i) {
  const double angle = 2 * std::numbers::pi * i / SplitCurve::kHeadings;
  return {std::cos(angle), 0, std::sin(angle)};
}

/// Of a table by heading, periodic.
double between(const std::vector<double>& values, const glm::dvec3& direction) {
  const double turn = std::atan2(direction.z, direction.x) / (2 * std::numbers::pi);
  const double place = (turn - std::floor(turn)) * SplitCurve::kHeadings;
  const auto first = static_cast<size_t>(place) % values.size();
  const double share = place - std::floor(place);
  return values[first] * (1 - share) + values[(first + 1) % values.size()] * share;
}

glm::dvec3 turnedAbout(const glm::dvec3& point, const glm::dvec3& axisPoint, double radians) {
  const glm::dmat4 turn = glm::rotate(glm::dmat4(1), radians, kUp);
  return axisPoint + glm::dvec3(turn * glm::dvec4(point - axisPoint, 0));
}

/// The parts of the image to the left and right of a line through two of its points; one is empty where the line
/// misses it.
std::array<GraphCamera::Part, 2> partsBeside(const GraphCamera::Part& whole, const glm::dvec2& a, const glm::dvec2& b) {
  auto [one, other] = GraphCamera::cut(whole, a, b);
  const glm::dvec2 across(b.y - a.y, a.x - b.x);
  const bool firstIsRight = -across.x >= 0;  // the first half lies to the right of a -> b, v growing downwards
  return firstIsRight ? std::array{other, one} : std::array{one, other};
}

}  // namespace

SplitCurve::SplitCurve(const Mesh& mesh) {
  if (mesh.positions.empty()) {
    throw InputError("a scene without vertices has no splitting point", "ambient light", "choose another scene");
  }
  center_ = glm::dvec3(boundsOf(mesh).center());
  halfExtent_.resize(kHeadings);
  for (int i = 0; i < kHeadings; ++i) {
    double& half = halfExtent_[static_cast<size_t>(i)];
    for (const glm::vec3& position : mesh.positions) {
      half = std::max(half, std::abs(glm::dot(glm::dvec3(position) - center_, headingOf(i))));
    }
  }
  const auto [least, most] = std::minmax_element(halfExtent_.begin(), halfExtent_.end());
  const double range = std::max(*most - *least, kMinLength * *most);
  for (const double half : halfExtent_) {
    const double lengthwise = range > 0 ? smoothed((half - *least) / range) : 0;
    share_.push_back((1 - lengthwise) * kBehindAll);
  }
}

double SplitCurve::share(const glm::dvec3& viewDirection) const {
  return between(share_, viewDirection);
}

double SplitCurve::offset(const glm::dvec3& viewDirection) const {
  return share(viewDirection) * between(halfExtent_, viewDirection);
}

glm::dvec3 SplitCurve::pointFor(const glm::dvec3& viewDirection) const {
  return pointAt(viewDirection, share(viewDirection));
}

glm::dvec3 SplitCurve::pointAt(const glm::dvec3& viewDirection, double share) const {
  const glm::dvec3 level(viewDirection.x, 0, viewDirection.z);
  const double length = glm::length(level);
  return length > 0 ? center_ + level * (share * between(halfExtent_, viewDirection) / length) : center_;
}

GraphCamera threeFrusta(const PinholeCamera& view, const glm::dvec3& splittingPoint, const Box& world,
                        const ThreeFrustaOptions& options) {
  GraphCamera camera(view);
  const glm::dvec3 eye(view.eye());
  const glm::dvec3 forward(view.forward());
  const glm::dvec3 level(forward.x, 0, forward.z);
  if (glm::length(level) < 1e-3) {
    throw InputError("the view looks straight up or down: no vertical plane lies before it", "ambient light",
                     "tilt the view, or use horizons of the view alone");
  }
  const Plane plane = Plane::through(splittingPoint, level);
  if (!(plane.height(eye) < 0)) {
    throw InputError("the splitting point does not lie before the eye", "ambient light",
                     "move the eye away from the scene");
  }
  double farthest = -1;
  for (const glm::vec3& corner : cornersOf(world)) {
    farthest = std::max(farthest, plane.height(glm::dvec3(corner)));
  }
  if (farthest <= 0) {
    return camera;
  }
  glm::dvec3 way = splittingPoint - eye;
  way.y = 0;
  const Plane middle = Plane::through(splittingPoint, glm::cross(glm::normalize(way), kUp));  // towards the right
  const glm::dmat4 pixels = camera.frusta()[GraphCamera::kRoot].pixelFromWorld;
  const auto imageOf = [&](const glm::dvec3& point) {
    const glm::dvec4 q = pixels * glm::dvec4(point, 1);
    return glm::dvec2(q) / q.w;
  };
  // Both before the eye, however the view is tilted.
  const double height = 0.25 * -plane.height(eye) * std::min(1.0, glm::length(level));
  const std::array<GraphCamera::Part, 2> parts =
      partsBeside(camera.frusta()[GraphCamera::kRoot].part, imageOf(splittingPoint + kUp * height),
                  imageOf(splittingPoint - kUp * height));
  const double turn = radiansFromDegrees(options.turnDegrees);
  for (const bool left : {true, false}) {
    const GraphCamera::Part& part = parts[left ? 0 : 1];
    if (part.empty()) {
      continue;
    }
    const glm::dvec3 viewpoint = turnedAbout(eye, splittingPoint, left ? -turn : turn);
    const int frustum = camera.bend(GraphCamera::kRoot, {plane, viewpoint}, left ? "left" : "right", part);
    camera.limit(frustum, left ? middle : Plane{-middle.normal, -middle.distance});
  }
  return camera;
}

PinholeCamera withBorder(const PinholeCamera& view, int pixels) {
  OC_CHECK(pixels >= 0, "a border has no negative width");
  View wider = view.view();
  const int height = view.height() + 2 * pixels;
  const double growth = static_cast<double>(height) / view.height();
  const double tangent = std::tan(radiansFromDegrees(wider.resolvedFovVerticalDegrees()) / 2) * growth;
  wider.fovVerticalDegrees = 2 * degreesFromRadians(std::atan(tangent));
  wider.centerShift /= static_cast<float>(growth);
  return {wider, view.width() + 2 * pixels, height};
}

}  // namespace ocelli
