// Curved ray cameras of random turns, for tests of what must hold for all of them.
#pragma once

#include "oc_core/base/error.h"
#include "tests/camera/random_graph_cameras.h"
#include "tests/camera/test_curved_cameras.h"

namespace ocelli::test {

/// Up to so many turns, one after the other, each to any side; those that do not fit are left out.
inline CurvedRayCamera randomCurved(Numbers& numbers, int turns) {
  CurvedRayCamera camera(smallCamera());
  const double width = camera.width();
  const double height = camera.height();
  double z = numbers.between(6, 9);
  for (int k = 0; k < turns; ++k) {
    const auto at = [&](double u, double v, double depth) { return *camera.unprojectExactly({u, v, depth}); };
    const glm::dvec3 middle = at(width / 2, height / 2, z);
    const glm::dvec3 along = glm::normalize(middle - at(width / 2, height / 2, z - 1e-3));
    double reach = 0;  // of the rays, from the middle one
    for (const double u : {0.0, width}) {
      for (const double v : {0.0, height}) {
        reach = std::max(reach, glm::distance(at(u, v, z), middle));
      }
    }
    const glm::dvec3 side = glm::normalize(glm::cross(along, randomVector(numbers, 1)));
    const double slope = numbers.between(0.1, 0.25);
    const double angle = numbers.between(-0.1, 0.4);
    const glm::dvec3 turned = along * std::cos(angle) + side * std::sin(angle);
    const double axis = numbers.between(1.3, 2) * reach;
    try {
      camera.bend(planesThrough(middle + side * axis, along - side * slope, along, along + side * slope),
                  middle - turned * numbers.between(0.8, 1.2) * z);
    } catch (const InputError&) {
      continue;  // as wanted
    }
    z += 2.2 * slope * (axis + reach) + 1;
  }
  return camera;
}

}  // namespace ocelli::test
