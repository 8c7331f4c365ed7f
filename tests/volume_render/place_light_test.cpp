// The renderer's copy of the lighting rule, in vectors, against the rule.
#include <gtest/gtest.h>

#include "oc_core/volume_render/volume_renderer.h"
#include "tests/volume_render/place_lights.h"

namespace ocelli {
namespace {

TEST(PlaceLight, ofVectorsIsThatOfTheRule) {
  for (const test::LightCase& each : test::lightCases()) {
    test::expectPlaceLights(renderVolume(test::placeCamera(), each.scene, test::placeOptions()), each);
  }
}

TEST(GradientLight, inSinglePrecisionIsThatInDouble) {
  const VolumeShading shading{.isOn = true, .ambient = 0.1, .diffuse = 0.4, .specular = 0.5, .shininess = 9};
  const GradientLight<double> exact = gradientLight(glm::dmat4(0.3), shading, {0, 2});
  const GradientLight<float> single = singleLight(exact, 0.5);
  for (const glm::dvec3& gradient :
       {glm::dvec3(0), glm::dvec3(1e-4, 0, 0), glm::dvec3(0.1, -0.3, 0.2), glm::dvec3(0, 7, 0)}) {
    const glm::dvec3 direction = glm::normalize(glm::dvec3(0.1, 0.2, -1));
    const PlaceLight<double> expected = exact.at(gradient, direction);
    const PlaceLight<float> got = single.at(glm::vec3(gradient * 2.0), glm::vec3(direction));
    // Some roundings of numbers around 1.
    EXPECT_NEAR(got.factor, expected.factor, 1e-6);
    EXPECT_NEAR(got.added, expected.added, 1e-6);
    EXPECT_EQ(single.factorAt(glm::vec3(gradient * 2.0)), got.factor);
  }
}

}  // namespace
}  // namespace ocelli
