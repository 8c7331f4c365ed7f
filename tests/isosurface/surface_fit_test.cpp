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
  std::vector<glm::vec3> points{glm::vec3(3)};
  fitToField(points, *scene.volume, 6);
  EXPECT_EQ(points[0], glm::vec3(3.5f, 3, 3));
}

TEST(SurfaceFit, PointsBeyondTheOutermostCentresStay) {
  const VolumeScene scene = sceneOfField(glm::ivec3(8), [](const glm::dvec3& p) { return p.x + p.y; });
  const glm::vec3 onFace(3, -0.5f, 3);
  std::vector<glm::vec3> points{onFace};
  fitToField(points, *scene.volume, 2.9);
  EXPECT_EQ(points[0], onFace);
}

TEST(SurfaceFit, WhereTheFieldIsFlatPointsStay) {
  const VolumeScene scene = sceneOfField(glm::ivec3(8), [](const glm::dvec3&) { return 1; });
  std::vector<glm::vec3> points{glm::vec3(3.25f)};
  fitToField(points, *scene.volume, 2);
  EXPECT_EQ(points[0], glm::vec3(3.25f));
}

TEST(SurfaceFit, GradientsAreThoseOfALinearFieldAtTheBordersToo) {
  const glm::dvec3 slope(1, -2, 0.5);
  const VolumeScene scene = sceneOfField(glm::ivec3(8), [&](const glm::dvec3& p) { return glm::dot(p, slope); });
  for (const glm::dvec3& p : {glm::dvec3(3.3, 4.1, 2.2), glm::dvec3(0, 7, 0.2)}) {
    EXPECT_LT(glm::distance(indexGradient(*scene.volume, p), slope), 1e-5);
  }
  const VolumeScene flat = sceneOfField({8, 8, 1}, [&](const glm::dvec3& p) { return glm::dot(p, slope); });
  EXPECT_EQ(indexGradient(*flat.volume, {3, 3, 0}).z, 0);
}

}  // namespace
}  // namespace ocelli
