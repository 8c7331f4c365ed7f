#include "oc_core/isosurface/surface_fit.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "tests/isosurface/field_volumes.h"

namespace ocelli {
namespace {

TEST(SurfaceFit, PointsMoveToTheValueOfALinearField) {
  const glm::dvec3 slope(1, -2, 0.5);
  const VolumeScene scene =
      sceneOfField(glm::ivec3(8), [&](const glm::dvec3& p) { return glm::dot(p - glm::dvec3(3.5), slope); });
  const glm::vec3 start(3.6f, 3.4f, 3.5f);
  std::vector<glm::vec3> points{start};
  fitToField(points, *scene.volume, 0);
  // The nearest point of the plane, along its normal. Voxels are floats.
  const glm::dvec3 wanted =
      glm::dvec3(start) - slope * (glm::dot(glm::dvec3(start) - 3.5, slope) / glm::dot(slope, slope));
  EXPECT_LT(glm::distance(glm::dvec3(points[0]), wanted), 1e-5);
}

TEST(SurfaceFit, PointsStayWithinHalfAVoxel) {
  const VolumeScene scene = sceneOfField(glm::ivec3(8), [](const glm::dvec3& p) { return p.x; });
  // As near as it can get to where the field is 3.9.
  std::vector<glm::vec3> points{glm::vec3(3.1f, 3, 3)};
  fitToField(points, *scene.volume, 3.9);
  EXPECT_EQ(points[0], glm::vec3(3.6f, 3, 3));
}

TEST(SurfaceFit, PointsBeyondTheOutermostCentresGoToTheFaces) {
  const VolumeScene scene = sceneOfField(glm::ivec3(8), [](const glm::dvec3& p) { return p.x + p.y; });
  // No surface runs through the first one's cell; the second moves along the face alone.
  std::vector<glm::vec3> points{{3.5f, -0.25f, 7.25f}, {2.5f, -0.25f, 3}};
  fitToField(points, *scene.volume, 2.25);
  EXPECT_EQ(points[0], glm::vec3(3.5f, -0.5f, 7.5f));
  EXPECT_LT(glm::distance(points[1], glm::vec3(2.25f, -0.5f, 3)), 1e-5f);
}

TEST(SurfaceFit, WhereTheFieldIsFlatPointsStay) {
  const VolumeScene scene = sceneOfField(glm::ivec3(8), [](const glm::dvec3&) { return 1; });
  std::vector<glm::vec3> points{glm::vec3(3.25f)};
  fitToField(points, *scene.volume, 2);
  EXPECT_EQ(points[0], glm::vec3(3.25f));
}

}  // namespace
}  // namespace ocelli
