#include "oc_core/scene/moving_scene.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "oc_core/base/check.h"
#include "oc_core/scene/scene.h"

namespace ocelli {

std::vector<double> evenTimes(double durationSeconds, size_t count) {
  OC_CHECK(count > 1, "the begin and the end are two times");
  std::vector<double> times;
  for (size_t i = 0; i < count; ++i) {
    times.push_back(durationSeconds * static_cast<double>(i) / static_cast<double>(count - 1));
  }
  return times;
}

double timeInMotion(double seconds, double durationSeconds, bool loop) {
  if (!loop) {
    return std::clamp(seconds, 0.0, durationSeconds);
  }
  const double rest = std::fmod(seconds, durationSeconds);
  return rest < 0 ? rest + durationSeconds : rest;
}

glm::mat4 unitFromMotion(const MovingScene& scene, const std::string& where) {
  const std::vector<double> times = scene.sampleTimes();
  Box box;
  MovedMesh moved;
  for (const double time : times) {
    scene.moveTo(time, moved);
    const Box one = boundsOf(moved.mesh);
    box.lower = glm::min(box.lower, one.lower);
    box.upper = glm::max(box.upper, one.upper);
  }
  OC_CHECK(!box.empty(), "a moving scene has vertices");
  const glm::dvec3 center = (glm::dvec3(box.lower) + glm::dvec3(box.upper)) * 0.5;
  double reach = 0;
  for (const double time : times) {
    scene.moveTo(time, moved);
    reach = std::max(reach, reachOf(moved.mesh, center));
  }
  return unitFromSphere(center, reach, where);
}

}  // namespace ocelli
