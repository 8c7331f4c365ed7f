#include "oc_core/volume_camera/guided_volume.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>

#include "oc_core/constructor/camera_constructors.h"
#include "oc_core/worlds/solids.h"
#include "tests/volume_camera/ball_volume.h"

namespace ocelli::test {
namespace {

TEST(GuidedVolume, IsTheBoxOfTheVoxels) {
  const GuidedScene guided = guidedVolume(ballVolume());
  const Box box = boundsOf(guided.mesh);
  // Half a voxel of 1/16 beyond the outermost centres.
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(box.lower[i], -1 - 1.0 / 32, 1e-6);
    EXPECT_NEAR(box.upper[i], 1 + 1.0 / 32, 1e-6);
  }
  EXPECT_EQ(guided.mesh.triangles.size(), 12u);
  EXPECT_EQ(guided.objectOfTriangle, std::vector<uint32_t>(12, 0));
}

TEST(GuidedVolume, TurnsWithTheVolume) {
  VolumeScene scene = ballVolume();
  scene.worldFromIndex =
      glm::rotate(glm::dmat4(1), glm::radians(45.0), glm::dvec3(0, 1, 0)) * scene.volume->grid().worldFromIndex;
  const Box box = boundsOf(guidedVolume(scene).mesh);
  EXPECT_NEAR(box.upper.x, std::sqrt(2.0) * (1 + 1.0 / 32), 1e-5);
  EXPECT_NEAR(box.upper.y, 1 + 1.0 / 32, 1e-5);
}

TEST(GuidedVolume, SurfacesAreAnObjectToLookAround) {
  VolumeScene scene = ballVolume();
  append(scene.surfaces, makeBox(glm::vec3(0.2f)));
  const GuidedScene guided = guidedVolume(scene);
  EXPECT_EQ(std::count(guided.objectOfTriangle.begin(), guided.objectOfTriangle.end(), kSurfacesObject), 12);
  const PinholeCamera reference(View{.fovVerticalDegrees = 60}, 64, 48);
  const MultiperspectiveCamera target = constructCamera(
      "target",
      [&] {
        GuidedScene withTarget = guided;
        withTarget.guides.target = SceneTarget{2, {{-0.1f, -0.1f, -0.9f}, {0.1f, 0.1f, -0.7f}}};
        return withTarget;
      }(),
      reference);
  // The surfaces hide it from a straight ray, so that the rays bend.
  EXPECT_FALSE(std::get<CurvedRayCamera>(target).bends().empty());
}

}  // namespace
}  // namespace ocelli::test
