#include "oc_core/depth_rays/stepped_image.h"

#include <gtest/gtest.h>

#include "oc_core/depth_rays/depth_image_target.h"
#include "oc_core/ocri/cast_representation.h"
#include "tests/depth_rays/sampled_scenes.h"

namespace ocelli {
namespace {

using test::smallCamera;

struct Stepped {
  CameraChoice choice;
  ReferenceImages images;
  std::vector<CameraMap> maps;

  Stepped(const char* name, const Mesh& mesh)
      : choice(cameraChoice(name)),
        images(buildReferenceImages(choice, smallCamera(), mesh)),
        maps(cameraMaps(choice, smallCamera(), mesh, images)) {}
};

TEST(SteppedImage, meetsAPlaneWhereItIs) {
  const Stepped stepped("di", test::tiltedPlane(0.5f));
  const SteppedImage image(stepped.images[0], stepped.maps[0], {.finePixels = 0.25});
  for (const glm::vec3 direction : {glm::vec3(0, 0, -9), glm::vec3(2, -1, -9), glm::vec3(-3, 1, -9)}) {
    const glm::vec3 origin(0.1f, 0.05f, 3);
    RayCost cost;
    const auto meeting = image.meet({origin, direction, 1}, cost);
    ASSERT_TRUE(meeting);
    const float share = -(origin.z + 0.5f * origin.y) / (direction.z + 0.5f * direction.y);
    // The image is looked up at pixels, not between them: half a pixel of 0.033, of a slope of a half.
    EXPECT_NEAR(meeting->share * 9, static_cast<double>(share) * 9, 0.03);
    EXPECT_EQ(meeting->opacity, 1);
    EXPECT_LE(cost.steps(), SteppedImage::maxSteps());
  }
}

// Its bounds have no depth of their own.
TEST(SteppedImage, meetsAWallThatFacesTheView) {
  const Stepped stepped("di", test::wall(0, 1));
  const SteppedImage image(stepped.images[0], stepped.maps[0]);
  RayCost cost;
  const auto meeting = image.meet({{0.1f, 0, 5}, {0, 0, -10}, 1}, cost);
  ASSERT_TRUE(meeting);
  EXPECT_NEAR(meeting->share, 0.5, 1e-6);
}

// Most of what the exact way meets first, the text's way meets near there, through the curved projections of occlusion
// cameras too; and the coarser the steps, the fewer there are.
TEST(SteppedImage, findsMostOfTheFirstHits) {
  const Mesh mesh = test::ballBeforePlane();
  for (const char* name : {"di", "rppc", "spoc", "ddoc", "eoc-h"}) {
    const Stepped stepped(name, mesh);
    const DepthImageTarget exact(stepped.images);
    size_t last = 0;
    for (const double fine : {1.0, 0.5, 0.25}) {
      const SteppedImage image(stepped.images[0], stepped.maps[0], {.finePixels = fine});
      Random random(17);
      size_t met = 0;
      size_t found = 0;
      RayCost cost;
      for (int i = 0; i < 1500; ++i) {
        const glm::vec3 origin(random.inRange(-1, 1), random.inRange(-1, 1), random.inRange(1, 3));
        const glm::vec3 aim(random.inRange(-0.8f, 0.8f), random.inRange(-0.8f, 0.8f), -0.4f);
        const StraightRay ray{origin, (aim - origin) * 3.0f, 1};
        const auto truth = exact.hit({ray.origin, ray.origin + ray.step});
        const auto meeting = image.meet(ray, cost);
        if (truth) {
          ++met;
          found += meeting && std::abs(meeting->share * static_cast<double>(glm::length(ray.step)) -
                                       static_cast<double>(truth->t)) < 0.15;
        }
      }
      ASSERT_GT(met, 100u) << name;
      EXPECT_GT(static_cast<double>(found), 0.8 * static_cast<double>(met)) << name << " " << fine;
      EXPECT_GT(cost.steps(), last) << name;
      last = cost.steps();
    }
  }
}

TEST(SteppedImage, fadesWhereItsOwnRaysGraze) {
  const Stepped stepped("di", test::ballBeforePlane());
  const SteppedImage image(stepped.images[0], stepped.maps[0], {.finePixels = 0.25});
  RayCost cost;
  const auto middle = image.meet({{0, 0, 3}, {0, 0, -3}, 1}, cost);
  const auto rim = image.meet({{0.488f, 0, 3}, {0, 0, -3}, 1}, cost);
  ASSERT_TRUE(middle && rim);
  EXPECT_EQ(middle->opacity, 1);
  EXPECT_LT(rim->opacity, 1);
}

TEST(SteppedImage, stepsAreBoundedForEveryRay) {
  const Stepped stepped("ddoc", test::boxBeforeWall());
  const SteppedImage image(stepped.images[0], stepped.maps[0], {.finePixels = 1e-9});
  Random random(4);
  for (int i = 0; i < 20; ++i) {
    const RayPath path = test::randomRay(random);
    RayCost cost;
    image.meet({path[0], path[1] - path[0], 1}, cost);
    EXPECT_LE(cost.steps(), SteppedImage::maxSteps());
  }
}

TEST(SteppedImage, anEmptyImageIsMetByNothing) {
  const ReferenceImage empty = blankReferenceImage("di", View{}, 5, 3);
  const CameraMap map = mapOf(empty.reference());
  RayCost cost;
  EXPECT_FALSE(SteppedImage(empty, map).meet({{0, 0, 5}, {0, 0, -9}, 1}, cost));
}

}  // namespace
}  // namespace ocelli
