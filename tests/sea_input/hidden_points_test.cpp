// Which points of a proxy the kinds of reference images choose.
#include "oc_core/sea_input/hidden_points.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "oc_core/base/error.h"

namespace ocelli {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

void addWall(Mesh& mesh, float x, float halfSide) {
  const auto first = static_cast<uint32_t>(mesh.positions.size());
  for (int i = 0; i < 4; ++i) {
    mesh.positions.emplace_back(x, (i & 1) != 0 ? halfSide : -halfSide, (i & 2) != 0 ? halfSide : -halfSide);
  }
  mesh.triangles.push_back(glm::uvec3(0, 1, 2) + first);
  mesh.triangles.push_back(glm::uvec3(1, 3, 2) + first);
}

/// A small wall before a large one, on one side alone: most faces see nothing.
Mesh twoWalls() {
  Mesh mesh;
  addWall(mesh, 1, 0.3f);
  addWall(mesh, 2, 1.8f);
  return mesh;
}

/// Of points of the large wall, whether the small one hides them from the eye.
size_t hiddenPoints(const std::vector<glm::vec3>& points) {
  return static_cast<size_t>(std::count_if(points.begin(), points.end(), [](const glm::vec3& p) {
    return p.x > 1.5f && std::abs(p.y) < 0.58f && std::abs(p.z) < 0.58f;
  }));
}

TEST(HiddenPoints, OcclusionCamerasChooseSomeThatTheEyeDoesNotSee) {
  const SeaPose pose{{0, 0, 0}, glm::angleAxis(0.3, glm::dvec3(0, 1, 0))};
  const auto pointsOf = [&](const char* kind) { return hiddenPointsOf(kind, 128)(twoWalls(), pose, 0.15); };
  const std::vector<glm::vec3> seen = pointsOf("di");
  EXPECT_EQ(hiddenPoints(seen), 0u);
  for (const char* kind : {"ddoc", "cell", "ldi-2"}) {
    const std::vector<glm::vec3> points = pointsOf(kind);
    EXPECT_GT(hiddenPoints(points), 50u) << kind;
    for (const glm::vec3& point : points) {
      // On one of the walls, as far as an image tells.
      EXPECT_TRUE(std::abs(point.x - 1) < 0.02f || std::abs(point.x - 2) < 0.02f) << kind << " " << point.x;
    }
  }
}

TEST(HiddenPoints, ThereAreNoneWhereThereIsNoProxy) {
  EXPECT_TRUE(hiddenPointsOf("ddoc", 32)({}, {}, 1).empty());
}

TEST(HiddenPoints, NamesThatNoKindHasAreRefused) {
  EXPECT_THAT([] { hiddenPointsOf("periscope", 32); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("periscope"), HasSubstr("--hidden"))));
}

TEST(HiddenPoints, FacesHaveAboutThePixelsOfTheImage) {
  EXPECT_NEAR(faceSideFor({.width = 512, .height = 512}), 2 * 512 / 3.14159, 1);
  EXPECT_NEAR(faceSideFor({.width = 1024, .height = 512}), 2 * 512 / 3.14159, 1);
  EXPECT_EQ(faceSideFor({.kind = SeaProjectionKind::kPinhole, .width = 640, .height = 480, .focal = {500, 500}}), 1000);
}

}  // namespace
}  // namespace ocelli
