#include "oc_core/depth_rays/depth_image_target.h"

#include <gtest/gtest.h>

#include <limits>

#include "oc_core/render/raycast.h"
#include "tests/depth_rays/sampled_scenes.h"

namespace ocelli {
namespace {

using test::smallCamera;

DepthImageTarget depthImageOf(const Mesh& mesh) {
  return DepthImageTarget({buildDepthImage(smallCamera(), mesh)});
}

TEST(DepthImageTarget, isMetWhereItsPlaneIs) {
  const DepthImageTarget target = depthImageOf(test::tiltedPlane(0.5f));
  for (const glm::vec3 direction : {glm::vec3(0, 0, -9), glm::vec3(2, -1, -9), glm::vec3(-3, 1, -9)}) {
    const glm::vec3 origin(0.1f, 0.05f, 3);
    const auto hit = target.hit({origin, origin + direction});
    ASSERT_TRUE(hit);
    // z = -y / 2 on the plane.
    const float share = -(origin.z + 0.5f * origin.y) / (direction.z + 0.5f * direction.y);
    const glm::vec3 meets = origin + direction * share;
    // Depths are single precision at a distance of 10, as are the barycentric weights.
    EXPECT_LT(glm::distance(hit->position, meets), 2e-5f);
    EXPECT_NEAR(hit->t, share * glm::length(direction), 2e-5f);
    EXPECT_EQ(hit->color, glm::vec3(0.5f));
    // The pixel whose sample lies to the upper left of the meeting, or its neighbour.
    const auto q = smallCamera().project(meets);
    const SampleCells::Place place = target.cells().placeOf(hit->element);
    EXPECT_NEAR(static_cast<float>(place.x) + 0.5f, q->u, 1.5f);
    EXPECT_NEAR(static_cast<float>(place.y) + 0.5f, q->v, 1.5f);
  }
}

TEST(DepthImageTarget, raysPassWhereTheImageSaysNothing) {
  // Behind the box, and through the gap beside it that the depth image cannot see into.
  const DepthImageTarget target = depthImageOf(test::boxBeforeWall());
  EXPECT_TRUE(target.hit({{0, 0, 5}, {0, 0, -5}}));
  EXPECT_FALSE(target.hit({{-2, 0, 0}, {2, 0, 0}})) << "the sides of the box lie along the image's rays or behind";
  EXPECT_FALSE(target.hit({{0, 0, 0}, {0, 0, -5}})) << "what the box hides of the wall is missing";
}

// All kinds: what the pyramid finds is what testing every triangle finds, bit by bit, within its bound of steps.
TEST(DepthImageTarget, losesNoFirstHit) {
  const Mesh mesh = test::thingsBeforeWall();
  const PinholeCamera camera({}, 45, 30);
  test::forEachSampledScene(mesh, camera, [](const std::string& name, const ReferenceImages& images) {
    const DepthImageTarget target(images);
    Random random(11);
    size_t met = 0;
    for (int i = 0; i < 1500; ++i) {
      const RayPath ray = test::randomRay(random);
      RayCost cost;
      const auto fast = target.hit(ray, cost);
      const auto slow = target.hitSlowly(ray);
      ASSERT_EQ(fast.has_value(), slow.has_value()) << name << " ray " << i;
      ASSERT_LE(cost.steps(), target.maxSteps());
      if (slow) {
        ++met;
        ASSERT_EQ(fast->element, slow->element) << name << " ray " << i;
        ASSERT_EQ(fast->t, slow->t);
        ASSERT_EQ(fast->position, slow->position);
      }
    }
    EXPECT_GT(met, 50u) << name;
  });
}

// Rays of many pieces, as those of graph cameras are, hit the first piece that meets something.
TEST(DepthImageTarget, bentRaysHitAlongTheirPieces) {
  const DepthImageTarget target = depthImageOf(test::wall(0, 1));
  const auto hit = target.hit({{0, 0, 2}, {0.25f, 0, 1}, {0.25f, 0, -3}});
  ASSERT_TRUE(hit);
  EXPECT_LT(glm::distance(hit->position, {0.25f, 0, 0}), 1e-5f);
  EXPECT_NEAR(hit->t, std::sqrt(1 + 0.0625f) + 1, 1e-5f);
  EXPECT_FALSE(target.hit({{0, 0, 2}, {0.25f, 0, 1}, {5, 0, 1}}));
}

TEST(DepthImageTarget, degenerateRaysHitNothing) {
  const DepthImageTarget target = depthImageOf(test::wall(0, 1));
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinite = std::numeric_limits<float>::infinity();
  EXPECT_FALSE(target.hit(RayPath{}));
  EXPECT_FALSE(target.hit({{0, 0, 5}}));
  EXPECT_FALSE(target.hit({{0, 0, 5}, {0, 0, 5}})) << "no direction";
  for (const float bad : {nan, infinite, -infinite, 1e30f}) {
    EXPECT_FALSE(target.hit({{bad, 0, 5}, {0, 0, -5}}));
    EXPECT_FALSE(target.hit({{0, 0, 5}, {0, bad, -5}}));
  }
  // In the plane of the samples themselves: it has no thickness.
  RayCost cost;
  EXPECT_FALSE(target.hit({{-5, 0.01f, 0}, {5, 0.01f, 0}}, cost));
  EXPECT_LE(cost.steps(), target.maxSteps());
}

// The worst there is: along a plane all of whose boxes the ray runs through, grazing at a thousandth of a pixel.
TEST(DepthImageTarget, stepsAreBoundedWhereEveryBoxIsMet) {
  const DepthImageTarget target = depthImageOf(test::tiltedPlane(2));
  const glm::vec3 along = glm::normalize(glm::vec3(0, 1, -2));
  size_t most = 0;
  for (int i = 0; i < 500; ++i) {
    RayCost cost;
    const glm::vec3 middle(0.002f * static_cast<float>(i) - 0.5f, 0, 1e-4f);
    target.hit({middle - along * 4.0f, middle + along * 4.0f}, cost);
    most = std::max(most, cost.steps());
    ASSERT_LE(cost.steps(), target.maxSteps());
  }
  EXPECT_GT(most, 40u) << "these rays are hard";
}

TEST(DepthImageTarget, fromInsideOfAnObjectItsSurfaceIsHitFromBehind) {
  const DepthImageTarget target = depthImageOf(test::ballBeforePlane());
  const auto hit = target.hit({{0, 0, 0}, {0, 0, 3}});
  ASSERT_TRUE(hit);
  // Facets of 7.5 degrees leave out 1e-3 of the ball in either direction, and lines between samples 3e-4.
  EXPECT_NEAR(hit->position.z, 0.5f, 2.5e-3f);
}

TEST(DepthImageTarget, emptyImagesAreHitByNothing) {
  for (const DepthImageTarget& target :
       {DepthImageTarget({}), DepthImageTarget({blankReferenceImage("di", View{}, 5, 3)})}) {
    EXPECT_FALSE(target.hit({{0, 0, 5}, {0, 0, -5}}));
    EXPECT_FALSE(target.hitSlowly({{0, 0, 5}, {0, 0, -5}}));
    EXPECT_TRUE(target.bounds().empty());
    EXPECT_EQ(target.maxSteps(), 0u);
  }
}

TEST(DepthImageTarget, aSinglePixelIsItsSquare) {
  const DepthImageTarget target({buildDepthImage(PinholeCamera(View{}, 1, 1), test::wall(0, 20))});
  const auto hit = target.hit({{0, 0, 5}, {0, 0, -5}});
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->position.z, 0, 1e-5f);
  EXPECT_FALSE(target.hit({{5, 0, 5}, {5, 0, -5}}));
}

// Where the image has a sample its own rays hit it.
TEST(DepthImageTarget, isSeenByItsOwnCameraAsItIs) {
  const Mesh mesh = test::thingsBeforeWall();
  const ReferenceImage image = buildDepthImage(smallCamera(), mesh);
  const DepthImageTarget target({image});
  const HitImage seen = castRays(smallCamera(), target);
  size_t far = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      ASSERT_EQ(seen(x, y).has_value(), image.holds(x, y)) << x << " " << y;
      far += image.holds(x, y) && glm::distance(seen(x, y)->position, *image.pointOf(x, y, smallCamera())) > 1e-4f;
    }
  }
  // Squares of rims stand half a pixel before what lies behind, at some of the rims.
  EXPECT_LT(far, image.sampleCount() / 50);
}

}  // namespace
}  // namespace ocelli
