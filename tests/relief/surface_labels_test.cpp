#include "oc_core/relief/surface_labels.h"

#include <gtest/gtest.h>

#include "tests/relief/small_reliefs.h"

namespace ocelli {
namespace {

TEST(SurfaceLabels, nameTrianglesAndPlaces) {
  const Mesh mesh = test::table();
  const SurfaceLabels labels(mesh);
  const Mesh labelled = labels.labelledMesh();
  ASSERT_EQ(labelled.triangles.size(), mesh.triangles.size());
  for (size_t i = 0; i < labelled.triangles.size(); ++i) {
    const glm::uvec3& t = labelled.triangles[i];
    // As renderers interpolate.
    const glm::vec3 label = labelled.color(t.x) * 0.25f + labelled.color(t.y) * 0.35f + labelled.color(t.z) * 0.4f;
    EXPECT_NEAR(label.x, static_cast<float>(i), 1e-3f);
    const ReliefSurface surface = labels.surfaceOf(label);
    EXPECT_NEAR(glm::distance(surface.color, mesh.color(mesh.triangles[i].x)), 0, 1e-5f);
    const glm::uvec3& own = mesh.triangles[i];
    const glm::vec3 normal = glm::normalize(
        glm::cross(mesh.positions[own.y] - mesh.positions[own.x], mesh.positions[own.z] - mesh.positions[own.x]));
    // Boxes have creases of 90 degrees: each face keeps its own normal.
    EXPECT_NEAR(glm::dot(glm::normalize(surface.normal), normal), 1, 1e-5f);
  }
}

// Numbers up to the limit survive the rounding of interpolation.
TEST(SurfaceLabels, theLargestNumberIsToldApart) {
  const auto number = static_cast<float>(SurfaceLabels::kMaxTriangles - 1);
  Random random(3);
  for (int i = 0; i < 100'000; ++i) {
    const float b1 = random.inRange(0, 1);
    const float b2 = random.inRange(0, 1 - b1);
    EXPECT_EQ(std::lround(number * (1 - b1 - b2) + number * b1 + number * b2), std::lround(number));
  }
}

TEST(SurfaceLabels, roundBodiesAreSmooth) {
  const Mesh sphere = makeSphere(48);
  const SurfaceLabels labels(sphere);
  const glm::uvec3& t = labels.mesh().triangles[300];
  const glm::vec3 middle =
      (labels.mesh().positions[t.x] + labels.mesh().positions[t.y] + labels.mesh().positions[t.z]) / 3.0f;
  const ReliefSurface surface = labels.surfaceOf(300, 1.0f / 3, 1.0f / 3);
  // A face of 7.5 degrees: its normals are within a tenth of that of the sphere's.
  EXPECT_GT(glm::dot(glm::normalize(surface.normal), glm::normalize(middle)), std::cos(0.013f));
}

}  // namespace
}  // namespace ocelli
