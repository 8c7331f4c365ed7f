#include "display_sim/dither/even_light.h"

#include <gtest/gtest.h>

#include <numbers>

#include "display_sim/slicing/exact_slicer.h"
#include "tests/display_sim_slicing/test_profiles.h"

namespace ocelli {
namespace {

using test::smallProfile;

/// Of a slice whose plane is z = 0.
float weightAt(const SweepGeometry& sweep, double evenRadius, const glm::dvec3& normal, float radius) {
  return evenLightWeight(EvenLight(sweep, evenRadius).facing(normal, 0), radius);
}

TEST(EvenLight, lightForAreaIsThatOfCellFaces) {
  const SweepGeometry sweep(smallProfile(100, 200, 100));
  const double column = 0.01;
  const double row = 0.02;
  const double arc = 0.4 * std::numbers::pi / 100;
  EXPECT_NEAR(litCellsPerArea(sweep, {1, 0, 0}, 0.4), 1 / (row * arc), 1e-6);
  EXPECT_NEAR(litCellsPerArea(sweep, {0, 1, 0}, 0.4), 1 / (column * arc), 1e-6);
  EXPECT_NEAR(litCellsPerArea(sweep, {0, 0, -1}, 0.4), 1 / (column * row), 1e-6);
}

// The weight times the cells for an area is the same for all directions and radii within the chosen one.
TEST(EvenLight, weighedCellsForAreaAreTheSameEverywhereWithin) {
  const SweepGeometry sweep(smallProfile(198, 768, 768));
  for (const double even : {0.1, 0.5, 1.0}) {
    const double target = std::min({litCellsPerArea(sweep, {1, 0, 0}, even), litCellsPerArea(sweep, {0, 1, 0}, even),
                                    litCellsPerArea(sweep, {0, 0, 1}, even)});
    for (const glm::dvec3& direction : {glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1),
                                        glm::dvec3(1, -2, 0.5), glm::dvec3(-1, 0, 3)}) {
      const glm::dvec3 normal = glm::normalize(direction);
      for (const double radius : {0.01, 0.05, 0.1, 0.4, 0.9}) {
        const float weight = weightAt(sweep, even, normal, static_cast<float>(radius));
        EXPECT_GT(weight, 0.0f);
        EXPECT_LE(weight, 1.0f);
        if (radius <= even) {
          EXPECT_NEAR(weight * litCellsPerArea(sweep, normal, radius) / target, 1, 1e-5);
        }
      }
    }
  }
}

TEST(EvenLight, leavesTheRimAlone) {
  const SweepGeometry sweep(smallProfile(198, 768, 768));
  EXPECT_EQ(weightAt(sweep, 0.5, {1, 0, 0}, 0.5f), 1.0f);
  EXPECT_EQ(weightAt(sweep, 0.5, {1, 0, 0}, 0.9f), 1.0f);
  EXPECT_LT(weightAt(sweep, 0.5, {1, 0, 0}, 0.4f), 0.81f);
}

TEST(EvenLight, trianglesWithoutAreaCountAsUpward) {
  EXPECT_EQ(unitNormal({1, 2, 3}, {1, 2, 3}, {1, 2, 3}), glm::dvec3(0, 1, 0));
  EXPECT_EQ(unitNormal({0, 0, 0}, {2, 0, 0}, {0, 3, 0}), glm::dvec3(0, 0, 1));
}

TEST(EvenLight, aColumnOnTheAxisHasARadius) {
  EXPECT_GT(EvenLight::columnRadius(SweepGeometry(smallProfile(10, 33, 10)), 16), 0.0f);
  EXPECT_FLOAT_EQ(EvenLight::columnRadius(SweepGeometry(smallProfile(10, 32, 10)), 16), 0.5f / 16);
}

}  // namespace
}  // namespace ocelli
