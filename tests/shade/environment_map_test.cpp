#include "oc_core/shade/environment_map.h"

#include <gtest/gtest.h>

#include "tests/ocri/test_scenes.h"

namespace ocelli {
namespace {

TEST(EnvironmentMap, showsWhatIsInEachDirection) {
  Mesh mesh;
  test::addQuad(mesh, {-1, -1, -2}, {1, -1, -2}, {1, 1, -2}, {-1, 1, -2}, {1, 0, 0});
  test::addQuad(mesh, {2, -1, -1}, {2, -1, 1}, {2, 1, 1}, {2, 1, -1}, {0, 1, 0});
  test::addQuad(mesh, {-1, -2, 1}, {1, -2, 1}, {1, -2, -1}, {-1, -2, -1}, {0, 0, 1});
  const glm::vec3 background(0.25f);
  const EnvironmentMap map({0, 0, 0}, mesh, 128, background);
  EXPECT_EQ(map.colorOf({0, 0, -1}), glm::vec3(1, 0, 0));
  EXPECT_EQ(map.colorOf({3, 0, 0}), glm::vec3(0, 1, 0));
  EXPECT_EQ(map.colorOf({0, -5, 0}), glm::vec3(0, 0, 1)) << "the pole";
  EXPECT_EQ(map.colorOf({0, 0, 1}), background) << "where the image wraps around";
  EXPECT_EQ(map.colorOf({0, 1, 0}), background);
  // The edge of the wall at 45 degrees, to within a pixel of 1.4 degrees.
  EXPECT_EQ(map.colorOf({-0.45f, 0, -1}), glm::vec3(1, 0, 0));
  EXPECT_EQ(map.colorOf({-0.55f, 0, -1}), background);
}

}  // namespace
}  // namespace ocelli
