#include "oc_core/volume_camera/volume_surfaces.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "oc_core/base/error.h"
#include "tests/base/temporary_folder.h"
#include "tests/volume_camera/ball_volume.h"

namespace ocelli::test {
namespace {

/// One triangle, counter-clockwise as seen from +z.
std::string triangleFile(const TemporaryFolder& folder) {
  return folder.write("one.obj", "v 0 0 0.5\nv 0.5 0 0.5\nv 0 0.25 0.5\nf 1 2 3\n").string();
}

SceneOptions unlit() {
  SceneOptions options;
  options.shading = Shading::kNone;
  return options;
}

TEST(VolumeSurfaces, StandWhereTheVolumesOwnCoordinatesSay) {
  const TemporaryFolder folder;
  VolumeScene scene = ballVolume();
  // Fitted: half as large, and moved up.
  const glm::dmat4 fit = glm::scale(glm::translate(glm::dmat4(1), glm::dvec3(0, 0.25, 0)), glm::dvec3(0.5));
  scene.worldFromIndex = fit * scene.worldFromIndex;
  addSurfaces(scene, triangleFile(folder), SurfaceFrame::kVolume, unlit());
  ASSERT_EQ(scene.surfaces.positions.size(), 3u);
  EXPECT_NEAR(glm::distance(scene.surfaces.positions[1], glm::vec3(0.25f, 0.25f, 0.25f)), 0, 1e-6);
}

TEST(VolumeSurfaces, OfAMeshAreThoseOfItsFile) {
  const TemporaryFolder folder;
  VolumeScene ofFile = ballVolume();
  ofFile.worldFromIndex = glm::scale(glm::dmat4(1), glm::dvec3(0.5)) * ofFile.worldFromIndex;
  VolumeScene ofMesh = ofFile;
  const SceneOptions lit{.fit = false};
  addSurfaces(ofFile, triangleFile(folder), SurfaceFrame::kVolume, lit);
  addSurfaces(ofMesh, loadScene(triangleFile(folder), {.fit = false, .shading = Shading::kNone}), SurfaceFrame::kVolume,
              true, "mesh");
  EXPECT_EQ(ofMesh.surfaces.positions, ofFile.surfaces.positions);
  EXPECT_EQ(ofMesh.surfaces.colors, ofFile.surfaces.colors);
}

TEST(VolumeSurfaces, OfPatientsAreTurnedUpright) {
  const TemporaryFolder folder;
  VolumeScene scene = ballVolume();
  scene.worldFromIndex = sceneFromPatient() * scene.worldFromIndex;
  addSurfaces(scene, triangleFile(folder), SurfaceFrame::kVolume, unlit());
  // Left, back, head: (0.5, 0, 0.5) of the patient is 0.5 to the right of who looks and 0.5 up.
  EXPECT_NEAR(glm::distance(scene.surfaces.positions[1], glm::vec3(0.5f, 0.5f, 0)), 0, 1e-6);
}

TEST(VolumeSurfaces, OfTheSceneStayWhereTheyAre) {
  const TemporaryFolder folder;
  VolumeScene scene = ballVolume();
  scene.worldFromIndex = glm::scale(glm::dmat4(1), glm::dvec3(0.5)) * scene.worldFromIndex;
  addSurfaces(scene, triangleFile(folder), SurfaceFrame::kScene, unlit());
  EXPECT_NEAR(glm::distance(scene.surfaces.positions[1], glm::vec3(0.5f, 0, 0.5f)), 0, 1e-6);
}

TEST(VolumeSurfaces, OutsideStaysOutsideWhereTheVolumeIsMirrored) {
  const TemporaryFolder folder;
  VolumeScene scene = ballVolume();
  scene.worldFromIndex = glm::scale(glm::dmat4(1), glm::dvec3(-1, 1, 1)) * scene.worldFromIndex;
  addSurfaces(scene, triangleFile(folder), SurfaceFrame::kVolume, unlit());
  const Mesh& mesh = scene.surfaces;
  const glm::uvec3 corners = mesh.triangles.front();
  EXPECT_GT(glm::cross(mesh.positions[corners.y] - mesh.positions[corners.x],
                       mesh.positions[corners.z] - mesh.positions[corners.x])
                .z,
            0);
}

TEST(VolumeSurfaces, AreLitWhereTheyStand) {
  const TemporaryFolder folder;
  VolumeScene still = ballVolume();
  VolumeScene turned = ballVolume();
  turned.worldFromIndex = glm::rotate(glm::dmat4(1), glm::radians(180.0), glm::dvec3(0, 1, 0)) * turned.worldFromIndex;
  addSurfaces(still, triangleFile(folder), SurfaceFrame::kVolume, {});
  addSurfaces(turned, triangleFile(folder), SurfaceFrame::kVolume, {});
  // The light is in front: what looks away from it is darker.
  EXPECT_GT(still.surfaces.color(0).x, turned.surfaces.color(0).x);
}

TEST(VolumeSurfaces, SeveralStandTogether) {
  const TemporaryFolder folder;
  VolumeScene scene = ballVolume();
  addSurfaces(scene, triangleFile(folder), SurfaceFrame::kVolume, unlit());
  addSurfaces(scene, triangleFile(folder), SurfaceFrame::kVolume, unlit());
  EXPECT_EQ(scene.surfaces.triangles.size(), 2u);
}

TEST(VolumeSurfaces, AreNoVolume) {
  VolumeScene scene = ballVolume();
  EXPECT_THROW(addSurfaces(scene, "builtin:volume,name=marschner-lobb", SurfaceFrame::kVolume, {}), InputError);
}

}  // namespace
}  // namespace ocelli::test
