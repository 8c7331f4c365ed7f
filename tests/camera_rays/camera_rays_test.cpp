// Every camera of the registry leaves as a ray map, and comes back: its image is the same.
#include "oc_core/camera_rays/camera_rays.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oc_core/base/error.h"
#include "oc_core/ocri/ray_map_kind.h"
#include "oc_core/ocri/representation_kind.h"
#include "tests/camera/test_ray_maps.h"
#include "tests/camera_rays/images_of_rays.h"
#include "tests/ocri/test_scenes.h"

namespace ocelli::test {
namespace {

using testing::HasSubstr;

TEST(CameraRays, everyCameraThatBuildsImagesComesBack) {
  const Mesh mesh = boxBeforeWall();
  const RayScene scene(mesh);
  size_t cameras = 0;
  for (const CameraName& name : cameraNames()) {
    const CameraChoice choice = cameraChoice(name.name);
    if (!choice.hasImages()) {
      EXPECT_THROW(rayMapOf(choice, smallCamera(), mesh, 0), InputError) << name.name;
      continue;
    }
    const ReferenceImages images = buildReferenceImages(choice, smallCamera(), mesh);
    const std::vector<RayFunction> rays = cameraRays(choice, smallCamera(), mesh, images);
    ASSERT_EQ(rays.size(), images.size()) << name.name;
    for (size_t i = 0; i < rays.size(); ++i) {
      const RayMap map = rayMapOf(choice, smallCamera(), mesh, rays.size() == 1 ? 0 : static_cast<int>(i) + 1);
      EXPECT_EQ(map.notes().wrapsAround, images[i].wrapsAround) << name.name;
      const FragmentImage want = castRays(map.width(), map.height(), scene, rays[i]);
      expectSame(imageOf(throughAFile(map), mesh), want, mesh, map.notes().name);
      ++cameras;
    }
  }
  EXPECT_GT(cameras, 20u);
}

TEST(CameraRays, unionsNeedTheNumberOfAnImage) {
  const Mesh mesh = boxBeforeWall();
  const auto errorOf = [&](const char* name, int image) -> std::string {
    try {
      rayMapOf(cameraChoice(name), smallCamera(), mesh, image);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(errorOf("corners-4", 0), HasSubstr("has 5 images"));
  EXPECT_EQ(errorOf("corners-4", 5), "");
  EXPECT_THAT(errorOf("corners-4", 6), HasSubstr("from 1 to 5"));
  EXPECT_THAT(errorOf("ddoc", 2), HasSubstr("has 1 image"));
  EXPECT_THAT(errorOf("geometry", 0), HasSubstr("no rays"));
}

TEST(CameraRays, thoseOfTheViewAloneNeedNoScene) {
  for (const char* name : {"di", "gpc", "panorama", "cylinder"}) {
    const CameraChoice choice = cameraChoice(name);
    EXPECT_FALSE(needsScene(choice)) << name;
    EXPECT_EQ(rayMapOf(choice, smallCamera(), Mesh{}, 0).rayCount(), static_cast<size_t>(kWidth * kHeight)) << name;
  }
  EXPECT_TRUE(needsScene(cameraChoice("ddoc")));
}

TEST(CameraRays, aMapOfAMapIsTheSame) {
  const auto map = std::make_shared<const RayMap>(fisheyeMap(40));
  const RayMap again = rayMapOf(rayMapChoice(map), PinholeCamera(View{}, 40, 40), Mesh{}, 0);
  EXPECT_EQ(again.rayCount(), map->rayCount());
  EXPECT_EQ(again.ray(20, 13).path(), map->ray(20, 13).path());
}

/// The rays of a map in the world do not begin at the eye of the reference view: that eye may lie inside an object.
TEST(RayMapImage, rayMapsInTheWorldHaveNoEye) {
  Mesh mesh = boxBeforeWall();
  append(mesh, makeBox(glm::vec3(0.2f)), glm::translate(glm::mat4(1), View{}.eye));
  EXPECT_THROW(buildReferenceImages(cameraChoice("di"), smallCamera(), mesh), InputError) << "its eye is in the box";
  EXPECT_GT(imageOf(std::make_shared<const RayMap>(pushBroomMap({40, 30})), mesh).sampleCount(), 100u);
}

TEST(RayMapImage, aMapInTheViewIsPlacedThere) {
  RayMapNotes notes;
  notes.frame = RayFrame::kView;
  const auto lens = std::make_shared<const RayMap>(straightMap(
      {31, 31},
      [](double u, double v) { return std::pair(glm::dvec3(0), glm::dvec3((u - 15.5) / 60, (15.5 - v) / 60, -1)); }, 0,
      100, notes));
  View view;
  view.eye = {0.5f, 0, 6};
  view.target = {0.5f, 0, 0};
  view.fovVerticalDegrees = 30;
  const ReferenceImage image = buildReferenceImages(rayMapChoice(lens), PinholeCamera(view, 31, 31), wall(0)).front();
  ASSERT_TRUE(image.holds(15, 15));
  EXPECT_LT(glm::distance(image.position(15, 15), glm::vec3(0.5f, 0, 0)), 1e-5f);
  EXPECT_LT(glm::distance(image.position(21, 15), glm::vec3(1.1f, 0, 0)), 1e-5f) << "6 / 60 of the distance of 6";
  EXPECT_LT(glm::distance(image.position(15, 12), glm::vec3(0.5f, 0.3f, 0)), 1e-5f);
}

TEST(RayMapImage, otherWaysToDrawAreRefused) {
  const auto map = std::make_shared<const RayMap>(pushBroomMap({40, 30}));
  const Mesh mesh = boxBeforeWall();
  EXPECT_THROW(drawReferenceImage(Technique::kPoints, rayMapChoice(map), PinholeCamera(View{}, 40, 30), mesh),
               InputError);
  EXPECT_GT(
      drawReferenceImage(Technique::kRaycast, rayMapChoice(map), PinholeCamera(View{}, 40, 30), mesh).sampleCount(),
      100u);
}

}  // namespace
}  // namespace ocelli::test
