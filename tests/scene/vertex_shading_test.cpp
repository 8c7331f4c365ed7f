#include "oc_core/scene/vertex_shading.h"

#include <gtest/gtest.h>

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>

#include "oc_core/base/conventions.h"
#include "oc_core/scene/scene.h"
#include "oc_core/scene/shading.h"
#include "oc_core/worlds/solids.h"

namespace ocelli {
namespace {

TEST(VertexShading, SplitsCreasesIntoCopiesAtTheEnd) {
  const Mesh box = makeBox(glm::vec3(1));
  Mesh split = box;
  const VertexShading shading(split);
  ASSERT_EQ(split.positions.size(), 24u);
  ASSERT_EQ(shading.sources().size(), 24u);
  for (uint32_t v = 0; v < 24; ++v) {
    EXPECT_EQ(split.positions[v], box.positions[shading.sources()[v]]);
    EXPECT_TRUE(v >= box.positions.size() || shading.sources()[v] == v);
  }
}

// Each face of a box has one shade, that of its normal, however the box is turned after it was split.
TEST(VertexShading, FollowsTheNormalsOfWhatMoves) {
  Mesh box = makeBox(glm::vec3(1, 2, 3));
  VertexShading shading(box);
  for (const double degrees : {0.0, 30.0, 90.0, 200.0}) {
    Mesh turned = box;
    transform(turned, glm::rotate(glm::mat4(1), static_cast<float>(radiansFromDegrees(degrees)), glm::vec3(0, 0, 1)));
    shading.shade(turned, {});
    for (const glm::uvec3& t : turned.triangles) {
      const glm::vec3& a = turned.positions[t.x];
      const glm::vec3 normal = glm::normalize(glm::cross(turned.positions[t.y] - a, turned.positions[t.z] - a));
      for (glm::length_t i = 0; i < 3; ++i) {
        // Two faces and their sum, rounded in single precision.
        EXPECT_NEAR(turned.colors[t[i]].x, lambertShade(normal), 1e-6f) << degrees;
      }
    }
  }
}

// What was smooth when it was split stays so: the vertices on the edge of a bent sheet have the shade of both sides.
TEST(VertexShading, KeepsTheCreasesThatTheMeshHad) {
  Mesh sheet;
  sheet.positions = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {-1, 0, 0}};
  sheet.triangles = {{0, 2, 1}, {0, 1, 3}};
  VertexShading shading(sheet);
  ASSERT_EQ(sheet.positions.size(), 4u) << "a flat sheet has no crease";
  sheet.positions[3] = {0, 0, -1};  // a right angle
  shading.shade(sheet, std::vector<glm::vec3>(4, glm::vec3(0.5f)));
  const glm::vec3 both = glm::normalize(glm::vec3(0, 0, 1) + glm::vec3(-1, 0, 0));
  EXPECT_NEAR(sheet.colors[0].x, 0.5f * lambertShade(both), 1e-6f);
  EXPECT_NEAR(sheet.colors[2].x, 0.5f * lambertShade({0, 0, 1}), 1e-6f);
  EXPECT_NEAR(sheet.colors[3].x, 0.5f * lambertShade({-1, 0, 0}), 1e-6f);
}

}  // namespace
}  // namespace ocelli
