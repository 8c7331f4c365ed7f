#include "oc_core/shade/environment_map.h"

#include <gtest/gtest.h>

#include "tests/ocri/test_scenes.h"

namespace ocelli {
namespace {

/// Of the weights of four pixels.
constexpr float kRounding = 1e-6f;

TEST(EnvironmentMap, showsWhatIsInEachDirection) {
  Mesh mesh;
  test::addQuad(mesh, {-1, -1, -2}, {1, -1, -2}, {1, 1, -2}, {-1, 1, -2}, {1, 0, 0});
  test::addQuad(mesh, {2, -1, -1}, {2, -1, 1}, {2, 1, 1}, {2, 1, -1}, {0, 1, 0});
  test::addQuad(mesh, {-1, -2, 1}, {1, -2, 1}, {1, -2, -1}, {-1, -2, -1}, {0, 0, 1});
  const glm::vec3 background(0.25f);
  const EnvironmentMap map({0, 0, 0}, mesh, 128, background);
  EXPECT_LT(glm::distance(map.colorOf({0, 0, -1}), glm::vec3(1, 0, 0)), kRounding);
  EXPECT_LT(glm::distance(map.colorOf({3, 0, 0}), glm::vec3(0, 1, 0)), kRounding);
  EXPECT_LT(glm::distance(map.colorOf({0, -5, 0}), glm::vec3(0, 0, 1)), kRounding) << "the pole";
  EXPECT_LT(glm::distance(map.colorOf({0, 0, 1}), background), kRounding) << "where the image wraps around";
  EXPECT_LT(glm::distance(map.colorOf({0, 1, 0}), background), kRounding);
  // The edge of the wall at 45 degrees, to within a pixel of 1.4 degrees.
  EXPECT_LT(glm::distance(map.colorOf({-0.45f, 0, -1}), glm::vec3(1, 0, 0)), kRounding);
  EXPECT_LT(glm::distance(map.colorOf({-0.55f, 0, -1}), background), kRounding);
}

}  // namespace
}  // namespace ocelli
