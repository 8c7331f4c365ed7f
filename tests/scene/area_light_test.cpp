#include "oc_core/scene/area_light.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>

#include "oc_core/base/error.h"

namespace ocelli {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(AreaLight, shinesAtItsTarget) {
  for (const glm::vec3 target : {glm::vec3(0, 0, 0), glm::vec3(3, 2, 1), glm::vec3(1, -5, 3)}) {
    const AreaLight light = areaLightTowards({1, 5, 3}, target, 2, 1, false, 30, "test");
    EXPECT_LT(glm::distance(light.direction(), glm::normalize(target - glm::vec3(1, 5, 3))), 1e-6f);
    EXPECT_NEAR(glm::dot(light.right, light.up), 0, 1e-6f);
    EXPECT_NEAR(glm::length(light.right), 1, 1e-6f);
  }
  EXPECT_NEAR(areaLightTowards({1, 5, 3}, {0, 0, 0}, 2, 1, false, 0, "test").right.y, 0, 1e-6f) << "level";
  EXPECT_THAT(
      [] {
        areaLightTowards({1, 1, 1}, {1, 1, 1}, 1, 1, false, 0, "the place");
      },
      ThrowsMessage<InputError>(HasSubstr("the place")));
}

TEST(AreaLight, isThatOfItsPanel) {
  for (const bool isDisc : {false, true}) {
    const AreaLight light = areaLightTowards({1, 2, 3}, {0, 0.5f, 0}, 0.8f, 0.5f, isDisc, 20, "test");
    const AreaLight found = areaLightOfPanel(panelOf(light), "test");
    EXPECT_EQ(found.isDisc, isDisc);
    EXPECT_LT(glm::distance(found.center, light.center), 2e-3f);
    EXPECT_LT(glm::distance(found.direction(), light.direction()), 1e-5f);
    if (!isDisc) {
      EXPECT_NEAR(found.width, 0.8f, 1e-5f);
      EXPECT_NEAR(found.height, 0.5f, 1e-5f);
      EXPECT_NEAR(std::abs(glm::dot(found.right, light.right)), 1, 1e-5f);
    }
  }
}

TEST(AreaLight, isNoneOfWhatIsNotFlat) {
  Mesh bent = panelOf(areaLightTowards({0, 2, 0}, {0, 0, 0}, 1, 1, false, 0, "test"));
  bent.positions[0].y += 0.3f;
  EXPECT_THAT([&] { areaLightOfPanel(bent, "bent.obj"); }, ThrowsMessage<InputError>(HasSubstr("not flat")));
  Mesh point = panelOf(areaLightTowards({0, 2, 0}, {0, 0, 0}, 0, 0, false, 0, "test"));
  EXPECT_THAT([&] { areaLightOfPanel(point, "x.obj"); }, ThrowsMessage<InputError>(HasSubstr("no area")));
}

}  // namespace
}  // namespace ocelli
