#include "oc_core/worlds/indoor_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vector_relational.hpp>
#include <limits>

#include "oc_core/base/conventions.h"

namespace ocelli {
namespace {

constexpr float kOffSurface = 0.003f;  // metres: how far from its surface light is gathered
constexpr float kAmbientReach = 1.3f;  // metres: beyond, things do not keep reflected light away
constexpr int kLampSteps = 3;          // samples of a lamp along each side
constexpr size_t kSkyRays = 40;

/// Where a ray enters the box between two corners, seen from its beginning.
inline float entryOf(const glm::vec3& lower, const glm::vec3& upper, const glm::vec3& inverse) {
  const glm::vec3 a = lower * inverse;
  const glm::vec3 b = upper * inverse;
  const glm::vec3 near = glm::min(a, b);
  const glm::vec3 far = glm::max(a, b);
  const float in = std::max(std::max(near.x, near.y), std::max(near.z, 0.0f));
  const float out = std::min(std::min(far.x, far.y), far.z);
  return in <= out ? in : std::numeric_limits<float>::infinity();
}

glm::vec3 inverseOf(const glm::vec3& along) {
  const auto safe = [](float x) { return 1 / (std::abs(x) > 1e-9f ? x : std::copysign(1e-9f, x)); };
  return {safe(along.x), safe(along.y), safe(along.z)};
}

/// Directions around +z, as many in equal parts of a cosine: a spiral.
std::array<glm::vec3, kSkyRays> skyDirections() {
  std::array<glm::vec3, kSkyRays> directions;
  for (size_t i = 0; i < kSkyRays; ++i) {
    const float sine2 = (static_cast<float>(i) + 0.5f) / static_cast<float>(kSkyRays);
    const auto turn = static_cast<float>(i) * 2.39996323f;  // the golden angle
    const float sine = std::sqrt(sine2);
    directions[i] = {sine * std::cos(turn), sine * std::sin(turn), std::sqrt(1 - sine2)};
  }
  return directions;
}

}  // namespace

float IndoorLight::Occluder::entry(const glm::vec3& from, const glm::vec3& along, const glm::vec3& inverse) const {
  const float outer = entryOf(bounds.lower - from, bounds.upper - from, inverse);
  if (!isTurned || outer == std::numeric_limits<float>::infinity()) {
    return outer;
  }
  const glm::vec3 origin(boxFromWorld * glm::vec4(from, 1));
  return entryOf(-half - origin, half - origin, inverseOf(glm::vec3(boxFromWorld * glm::vec4(along, 0))));
}

void IndoorLight::addOccluder(const glm::vec3& size, const glm::mat4& worldFromBox) {
  Occluder occluder{{}, glm::inverse(worldFromBox), size * 0.5f};
  for (glm::length_t axis = 0; axis < 3; ++axis) {
    const glm::vec3 along = glm::abs(glm::vec3(worldFromBox[axis]));
    occluder.isTurned = occluder.isTurned || std::max({along.x, along.y, along.z}) < 0.9999f;
  }
  for (int i = 0; i < 8; ++i) {
    const glm::vec3 corner((i & 1) != 0 ? 0.5f : -0.5f, (i & 2) != 0 ? 0.5f : -0.5f, (i & 4) != 0 ? 0.5f : -0.5f);
    occluder.bounds.add(glm::vec3(worldFromBox * glm::vec4(corner * size, 1)));
  }
  occluders_.push_back(occluder);
}

float IndoorLight::received(const RoomLamp& lamp, const glm::vec3& from, const glm::vec3& normal) const {
  const glm::vec3 half = glm::abs(lamp.halfU) + glm::abs(lamp.halfV) + 0.03f;
  const glm::vec3 lower = glm::min(from, lamp.center - half);
  const glm::vec3 upper = glm::max(from, lamp.center + half);
  std::vector<const Occluder*> between;
  for (const Occluder& box : occluders_) {
    if (glm::all(glm::lessThanEqual(box.bounds.lower, upper)) &&
        glm::all(glm::lessThanEqual(lower, box.bounds.upper))) {
      between.push_back(&box);
    }
  }
  float sum = 0;
  for (int i = 0; i < kLampSteps * kLampSteps; ++i) {
    const float u = (static_cast<float>(i % kLampSteps) + 0.5f) * 2 / kLampSteps - 1;
    const float v = (static_cast<float>(i / kLampSteps) + 0.5f) * 2 / kLampSteps - 1;
    const glm::vec3 to = lamp.center + lamp.halfU * u + lamp.halfV * v + lamp.normal * 0.03f;
    const glm::vec3 d = to - from;
    const float distance2 = std::max(glm::dot(d, d), 0.02f);
    const float facing = glm::dot(d, normal) * -glm::dot(d, lamp.normal);
    if (glm::dot(d, normal) <= 0 || facing <= 0) {
      continue;
    }
    const glm::vec3 inverse = inverseOf(d);
    if (std::none_of(between.begin(), between.end(),
                     [&](const Occluder* box) { return box->entry(from, d, inverse) < 0.999f; })) {
      sum += facing / (distance2 * distance2);
    }
  }
  return sum / (kLampSteps * kLampSteps);
}

float IndoorLight::openness(const glm::vec3& point, const glm::vec3& normal) const {
  static const std::array<glm::vec3, kSkyRays> sky = skyDirections();
  std::vector<const Occluder*> near;
  for (const Occluder& box : occluders_) {
    const glm::vec3 nearest = glm::clamp(point, box.bounds.lower, box.bounds.upper);
    if (glm::distance(nearest, point) < kAmbientReach) {
      near.push_back(&box);
    }
  }
  if (near.empty()) {
    return 1;
  }
  const glm::vec3 beside =
      glm::normalize(glm::cross(normal, std::abs(normal.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0)));
  const glm::vec3 other = glm::cross(normal, beside);
  float closed = 0;
  for (const glm::vec3& direction : sky) {
    const glm::vec3 along = beside * direction.x + other * direction.y + normal * direction.z;
    const glm::vec3 inverse = inverseOf(along);
    float nearest = kAmbientReach;
    for (const Occluder* box : near) {
      nearest = std::min(nearest, box->entry(point, along, inverse));
    }
    const float part = 1 - nearest / kAmbientReach;
    closed += part * part;
  }
  return 1 - closed / static_cast<float>(kSkyRays);
}

glm::vec3 IndoorLight::at(const glm::vec3& point, const glm::vec3& normal) const {
  const glm::vec3 from = point + normal * kOffSurface;
  glm::vec3 sum = ambient_ * openness(from, normal);
  for (const RoomLamp& lamp : lamps_) {
    const float area = 4 * glm::length(lamp.halfU) * glm::length(lamp.halfV);
    sum += lamp.power * (received(lamp, from, normal) * area / static_cast<float>(kPi));
  }
  // As film does it: bright light saturates softly, and nothing is black.
  const glm::vec3 soft = 1.25f * (1.0f - glm::exp(-sum));
  return glm::max(soft, glm::vec3(0.07f));
}

}  // namespace ocelli
