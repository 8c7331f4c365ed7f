// How well projection and unprojection of cameras whose rays turn undo each other.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "oc_core/camera/exact_image_point.h"

namespace ocelli::test {

/// The same numbers on every platform.
class Numbers {
 public:
  double between(double least, double most) {
    return least + (most - least) * static_cast<double>(generator_()) / 4294967295.0;
  }

 private:
  std::mt19937 generator_{7};
};

struct InverseErrors {
  double pixel = 0;  ///< of u and v, relative to the image's size; of z, relative to z
  double point = 0;  ///< relative to z
};

/// The worst of 10^6 random image points with z from 5 to 30; `visit` gets the world point of each.
template <class Camera, class Visit>
InverseErrors worstInverse(const Camera& camera, const Visit& visit) {
  Numbers numbers;
  InverseErrors worst;
  for (int i = 0; i < 1000000 && !testing::Test::HasFailure(); ++i) {
    const ExactImagePoint q{numbers.between(0, camera.width()), numbers.between(0, camera.height()),
                            numbers.between(5, 30)};
    const auto point = camera.unprojectExactly(q);
    const auto back = point ? camera.projectExactly(*point) : std::nullopt;
    const auto again = back ? camera.unprojectExactly(*back) : std::nullopt;
    EXPECT_TRUE(again) << q.u << ' ' << q.v << ' ' << q.t;
    if (again) {
      visit(*point);
      worst.point = std::max(worst.point, glm::distance(*again, *point) / q.t);
      worst.pixel = std::max({worst.pixel, std::abs(back->u - q.u) / camera.width(),
                              std::abs(back->v - q.v) / camera.height(), std::abs(back->t - q.t) / q.t});
    }
  }
  return worst;
}

}  // namespace ocelli::test
