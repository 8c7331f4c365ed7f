#include "oc_core/explore/explore_walker.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "oc_core/base/conventions.h"

namespace ocelli {
namespace {

constexpr int kFeelers = 12;      // level rays around the walker
constexpr int kSlides = 3;        // walls that one step can slide along
constexpr double kMaxDrop = 2.5;  // metres: one does not walk over higher edges
constexpr double kMaxRise = 2.5;  // metres a second, by which the eye follows the floor
constexpr double kNearMetres = 0.05;
constexpr double kFarSizes = 2;  // of the scene, beyond it

/// Less a whole number of turns: in [-180, 180).
double turnOf(double degrees) {
  return degrees - 360 * std::floor((degrees + 180) / 360);
}

}  // namespace

glm::dvec3 lookOf(const WalkerView& view) {
  const double pitch = radiansFromDegrees(view.pitchDegrees);
  return headingOf(view) * std::cos(pitch) + glm::dvec3(0, std::sin(pitch), 0);
}

glm::dvec3 headingOf(const WalkerView& view) {
  const double heading = radiansFromDegrees(view.headingDegrees);
  return {std::sin(heading), 0, -std::cos(heading)};
}

double headingDegreesOf(const glm::dvec3& direction, double otherwise) {
  return direction.x == 0 && direction.z == 0 ? otherwise : degreesFromRadians(std::atan2(direction.x, -direction.z));
}

WalkerView between(const WalkerView& from, const WalkerView& to, double share) {
  return {glm::mix(from.eye, to.eye, share),
          from.headingDegrees + turnOf(to.headingDegrees - from.headingDegrees) * share,
          glm::mix(from.pitchDegrees, to.pitchDegrees, share)};
}

PinholeCamera walkerCamera(const WalkerView& view, const ExploreScene& scene, double fovHorizontalDegrees, int width,
                           int height) {
  const Box& bounds = scene.bounds();
  const double size = static_cast<double>(glm::length(bounds.size()));
  View pinhole;
  pinhole.eye = glm::vec3(view.eye);
  // Far away, so that rounding of the eye does not turn the view.
  pinhole.target = glm::vec3(view.eye + lookOf(view) * size);
  const double slope = std::tan(radiansFromDegrees(fovHorizontalDegrees) / 2) * height / width;
  pinhole.fovVerticalDegrees = degreesFromRadians(2 * std::atan(slope));
  pinhole.zNear = static_cast<float>(kNearMetres * scene.metre());
  pinhole.zFar = static_cast<float>(glm::distance(view.eye, glm::dvec3(bounds.center())) + kFarSizes * size);
  return {pinhole, width, height};
}

ExploreWalker::ExploreWalker(const ExploreScene& scene, const WalkerOptions& options)
    : scene_(scene), options_(options) {
  jump(openPlace(scene, options));
}

void ExploreWalker::jump(const WalkerView& view) {
  view_ = view;
  const double metre = scene_.metre();
  const std::optional<glm::vec3> floor = floorBelow(
      view.eye - glm::dvec3(0, (options_.eyeHeight - options_.stepHeight) * metre, 0), options_.stepHeight + kMaxDrop);
  overFloor_ = floor.has_value();
  if (floor && !options_.fly) {
    view_.eye.y = static_cast<double>(floor->y) + options_.eyeHeight * metre;
  }
}

std::optional<glm::vec3> ExploreWalker::floorBelow(const glm::dvec3& point, double reach) const {
  const std::optional<ExploreHit> hit =
      scene_.cast(glm::vec3(point), {0, -1, 0}, static_cast<float>(reach * scene_.metre()));
  return hit && hit->normal.y >= kFloorNormal ? std::optional(hit->position) : std::nullopt;
}

void ExploreWalker::turn(const WalkInput& input, double seconds) {
  const double turned = options_.turnDegrees * seconds;
  view_.headingDegrees = turnOf(view_.headingDegrees + input.turnRight * turned + input.pointerDegrees.x);
  view_.pitchDegrees = std::clamp(view_.pitchDegrees + input.lookUp * turned + input.pointerDegrees.y,
                                  -options_.maxPitch, options_.maxPitch);
}

/// Level rays around the body, at the knee, the middle and the eye: none may come nearer to a wall than the radius.
glm::dvec3 ExploreWalker::slid(glm::dvec3 move) const {
  const double metre = scene_.metre();
  const double radius = options_.radius * metre;
  const double eyeHeight = options_.eyeHeight * metre;
  const std::array<double, 3> below{eyeHeight - options_.stepHeight * metre * 1.1, eyeHeight / 2, 0};
  const double length = glm::length(move);
  for (int slide = 0; slide < kSlides; ++slide) {
    glm::dvec3 pushed(0);
    double deepest = 1e-9 * metre;
    for (const double drop : below) {
      const glm::dvec3 from = view_.eye - glm::dvec3(0, drop, 0);
      for (int feeler = 0; feeler <= kFeelers; ++feeler) {
        const double angle = 2 * kPi * feeler / kFeelers;
        const glm::dvec3 direction = feeler == kFeelers ? move / std::max(glm::length(move), 1e-30)
                                                        : glm::dvec3(std::cos(angle), 0, std::sin(angle));
        if (!(glm::length(direction) > 0.5)) {
          continue;
        }
        const std::optional<ExploreHit> hit =
            scene_.cast(glm::vec3(from), glm::vec3(direction), static_cast<float>(radius + length));
        if (!hit || std::abs(hit->normal.y) >= kFloorNormal) {
          continue;
        }
        const glm::dvec3 normal = glm::normalize(glm::dvec3(hit->normal.x, 0, hit->normal.z));
        const double after = glm::dot(from + move - glm::dvec3(hit->position), normal);
        if (radius - after > deepest && glm::dot(move, normal) < 0) {
          deepest = radius - after;
          pushed = normal * std::min(radius - after, -glm::dot(move, normal));
        }
      }
    }
    if (pushed == glm::dvec3(0)) {
      return move;
    }
    atWall_ = true;
    move += pushed;
  }
  return glm::dvec3(0);
}

void ExploreWalker::step(const WalkInput& input, double seconds) {
  turn(input, seconds);
  atWall_ = false;
  const double metre = scene_.metre();
  const double way = options_.speed * (input.fast ? options_.fastFactor : 1) * metre * seconds;
  const glm::dvec3 heading = headingOf(view_);
  const glm::dvec3 right(-heading.z, 0, heading.x);
  if (options_.fly) {
    view_.eye += (lookOf(view_) * input.forward + right * input.right + glm::dvec3(0, input.up, 0)) * way;
    overFloor_ = false;
    return;
  }
  const glm::dvec3 move = (heading * input.forward + right * input.right) * way;
  const double kneeDrop = (options_.eyeHeight - options_.stepHeight) * metre;
  const auto floorAt = [&](const glm::dvec3& eye) {
    return floorBelow(eye - glm::dvec3(0, kneeDrop, 0), options_.stepHeight + kMaxDrop);
  };
  glm::dvec3 done = move == glm::dvec3(0) ? move : slid(move);
  if (overFloor_ && done != glm::dvec3(0)) {
    // Not over an edge; along it where that is possible.
    const std::array<glm::dvec3, 3> tries{done, glm::dvec3(done.x, 0, 0), glm::dvec3(0, 0, done.z)};
    const auto stays = std::find_if(tries.begin(), tries.end(),
                                    [&](const glm::dvec3& each) { return floorAt(view_.eye + each).has_value(); });
    atWall_ = atWall_ || stays != tries.begin();
    done = stays == tries.end() ? glm::dvec3(0) : *stays;
  }
  view_.eye += done;
  const std::optional<glm::vec3> floor = floorAt(view_.eye);
  overFloor_ = floor.has_value();
  if (floor) {
    const double wanted = static_cast<double>(floor->y) + options_.eyeHeight * metre;
    const double most = kMaxRise * metre * seconds;
    view_.eye.y += std::clamp(wanted - view_.eye.y, -most, most);
  } else {
    view_.eye.y += input.up * way;
  }
}

PinholeCamera ExploreWalker::camera(int width, int height) const {
  return walkerCamera(view_, scene_, options_.fovHorizontal, width, height);
}

}  // namespace ocelli
