#include "oc_core/depth_rays/graph_depth_image.h"

#include <gmock/gmock.h>

#include "oc_core/base/random.h"
#include "oc_core/camera/graph_overlap.h"
#include "oc_core/render/rasterize_graph.h"
#include "oc_core/render/raycast.h"
#include "tests/render/crossing_corridors.h"

namespace ocelli {
namespace {

using DepthHit = GraphDepthImage::Hit;
using Options = GraphDepthImage::Options;
using test::aroundCorners;
using test::crossingCorridors;
using test::smallCamera;
using test::turnAt;

/// Of an image whose depths are exact to single precision, unlike those of rasterisation.
GraphDepthImage depthImageOf(const GraphCamera& camera, const Mesh& mesh) {
  return {camera, raycast(camera, mesh, RayScene(mesh))};
}

/// Corridors, their image, and random rays that begin in them.
class Corridors : public testing::Test {
 protected:
  struct TestRay {
    glm::vec3 origin{0};
    glm::vec3 direction{0};  ///< unit

    glm::vec3 at(float distance) const { return origin + direction * distance; }
  };

  TestRay randomRay() {
    TestRay ray;
    ray.origin = random_.below(2) == 0
                     ? glm::vec3(random_.inRange(-0.9f, 0.9f), random_.inRange(0.1f, 1.9f), random_.inRange(0, 9))
                     : glm::vec3(random_.inRange(-7.5f, 7.5f), random_.inRange(0.1f, 1.9f), random_.inRange(-1.9f, 0));
    ray.direction =
        glm::normalize(glm::vec3(random_.inRange(-1, 1), random_.inRange(-1, 1), random_.inRange(-1, 1)) + 1e-6f);
    return ray;
  }
  /// Where a ray meets the scene itself, if the camera sees that place.
  std::optional<glm::vec3> seenMeeting(const TestRay& ray) const {
    const Fragment truth = scene_.intersect({ray.origin, ray.at(60)});
    const glm::vec3 at = truth.covered() ? positionOf(truth, mesh_) : glm::vec3(1e3f);
    const auto q = camera_.project(at);
    const Fragment seen = q ? scene_.intersect(camera_.rayPath({q->u, q->v})) : Fragment{};
    const bool same = seen.covered() && glm::distance(positionOf(seen, mesh_), at) < 2e-3f;
    return same && q->u >= 0 && q->u < 480 && q->v >= 0 && q->v < 320 ? std::optional(at) : std::nullopt;
  }
  std::optional<DepthHit> intersect(const TestRay& ray, bool coarse, size_t& steps) const {
    return image_.intersect(glm::dvec3(ray.origin), glm::dvec3(ray.direction), {0.01, coarse}, &steps);
  }

  Mesh mesh_ = crossingCorridors();
  RayScene scene_{mesh_};
  GraphCamera camera_ = aroundCorners();
  FragmentImage fragments_ = rasterize(camera_, mesh_);
  GraphDepthImage image_{camera_, fragments_};
  Random random_{5};
};

TEST(GraphDepthImage, meetsAPlaneWhereItIs) {
  // Walls that fill the image, square to the view and tilted; rays down to them from before.
  for (const float steepness : {0.0f, 0.5f, 2.0f}) {
    const GraphDepthImage image = depthImageOf(GraphCamera(smallCamera()), test::tiltedPlane(steepness));
    for (const glm::dvec3 direction : {glm::dvec3(0, 0, -1), glm::dvec3(0.2, -0.1, -1), glm::dvec3(-0.3, 0.1, -2)}) {
      const glm::dvec3 origin(0.1, 0.2, 3);
      const auto hit = image.intersect(origin, direction);
      ASSERT_TRUE(hit);
      // z = -steepness y on the plane.
      const double k = static_cast<double>(steepness);
      const double t = -(origin.z + k * origin.y) / (direction.z + k * direction.y);
      EXPECT_NEAR(hit->distance, t * glm::length(direction), 1e-5) << "single precision of z";
      const auto place = image.camera().projectExactly(origin + direction * t);
      EXPECT_NEAR(hit->place.x, place->u, 1e-3);
      EXPECT_NEAR(hit->place.y, place->v, 1e-3);
    }
  }
}

// Behind a turn z is not linear in the image, and yet planes are met where they are.
TEST(GraphDepthImage, meetsAPlaneBehindATurnWhereItIs) {
  GraphCamera graph(smallCamera());
  graph.bend(0, turnAt({0, 0, 2}, {0.3, 0, -1}, {1.5, 0.5, 5}), "bent");
  Mesh mesh;
  test::addQuad(mesh, {-20, -20, 6}, {20, -20, -14}, {20, 20, -14}, {-20, 20, 6});  // x + 2 z = -8
  const GraphDepthImage image = depthImageOf(graph, mesh);
  Random random(1);
  size_t met = 0;
  for (int i = 0; i < 1000; ++i) {
    const glm::dvec3 origin(random.inRange(-1, 0.5f), random.inRange(-0.5f, 0.5f), random.inRange(-2, 1));
    const glm::dvec3 direction(random.inRange(-0.5f, 0.5f), random.inRange(-0.5f, 0.5f), random.inRange(-2, -1));
    const double t = -(8 + origin.x + 2 * origin.z) / (direction.x + 2 * direction.z);
    const auto q = graph.projectExactly(origin + direction * t);
    if (graph.frustumOf(origin) != 1 || !q || q->u < 1 || q->u > 89 || q->v < 1 || q->v > 59) {
      continue;
    }
    ++met;
    const auto hit = image.intersect(origin, direction);
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->distance, t * glm::length(direction), 1e-4);
    EXPECT_EQ(hit->frustum, 1);
  }
  EXPECT_GT(met, 300u);
}

// Casting the same rays at the scene itself. Of those that meet what the camera sees, some pass so close behind an edge
// that a pixel does not tell; steep views of far walls make up most of the rest.
TEST_F(Corridors, agreesWithRayCastingWhereTheCameraSees) {
  EXPECT_NO_THROW(checkDisjoint(camera_, {-8, 0, -2}, {8, 2, 10}));
  size_t seen = 0;
  size_t agree = 0;
  size_t missed = 0;
  size_t differ = 0;
  size_t fine = 0;
  size_t coarse = 0;
  for (int i = 0; i < 20000; ++i) {
    const TestRay ray = randomRay();
    const std::optional<glm::vec3> truth = seenMeeting(ray);
    const auto hit = intersect(ray, true, coarse);
    const auto slow = intersect(ray, false, fine);
    differ += hit.has_value() != slow.has_value() || (hit && hit->distance != slow->distance);
    if (truth) {
      ++seen;
      missed += !hit;
      agree += hit && std::abs(hit->distance - static_cast<double>(glm::distance(*truth, ray.origin))) < 0.05;
    }
  }
  EXPECT_GT(seen, 15000u);
  EXPECT_GT(static_cast<double>(agree), 0.985 * static_cast<double>(seen));
  EXPECT_LT(static_cast<double>(missed), 0.005 * static_cast<double>(seen));
  EXPECT_EQ(differ, 0u) << "tiles only save steps";
  EXPECT_LT(static_cast<double>(coarse), 0.6 * static_cast<double>(fine));
}

// The generic algorithm of section 3.5.2.2: uniform steps in space, each projected; in an image of any resolution, as
// each step casts the ray of its image point. A step must be short where pixels are small: 2000 for 20 units.
TEST_F(Corridors, agreesWithTheGenericAlgorithm) {
  constexpr int kSteps = 2000;
  constexpr double kMax = 20;
  const auto stepwise = [&](const TestRay& ray) -> std::optional<double> {
    std::optional<double> lastGap;
    double lastDepth = 0;
    for (int k = 0; k <= kSteps; ++k) {
      const auto q = camera_.project(ray.at(static_cast<float>(kMax * k / kSteps)));
      const bool inside = q && q->u >= 0 && q->u < 480 && q->v >= 0 && q->v < 320;
      const Fragment seen = inside ? scene_.intersect(camera_.rayPath({q->u, q->v})) : Fragment{};
      const auto surface = seen.covered() ? camera_.project(positionOf(seen, mesh_)) : std::nullopt;
      const auto gap = surface ? std::optional(static_cast<double>(q->t - surface->t)) : std::nullopt;
      if (gap && lastGap && *gap * *lastGap <= 0 && std::abs(static_cast<double>(surface->t) - lastDepth) < 0.3) {
        return kMax * (k - *gap / (*gap - *lastGap)) / kSteps;
      }
      lastGap = gap;
      lastDepth = surface ? static_cast<double>(surface->t) : 0;
    }
    return std::nullopt;
  };
  size_t seen = 0;
  size_t agree = 0;
  size_t steps = 0;
  for (int i = 0; i < 250; ++i) {
    const TestRay ray = randomRay();
    if (!seenMeeting(ray)) {
      continue;
    }
    ++seen;
    const auto hit = intersect(ray, true, steps);
    const auto generic = stepwise(ray);
    agree += hit && generic && std::abs(hit->distance - *generic) < 0.05;
  }
  EXPECT_GT(seen, 180u);
  EXPECT_GT(static_cast<double>(agree), 0.95 * static_cast<double>(seen));
  EXPECT_LT(steps, seen * kSteps / 10);
}

TEST(GraphDepthImage, raysPassBehindObjects) {
  // A small square before nothing; a ray that passes a unit behind it, one that comes out just behind its edge.
  const GraphDepthImage image = depthImageOf(GraphCamera(smallCamera()), test::wall(0, 0.5f));
  EXPECT_TRUE(image.intersect({0, 0, 1}, {0, 0, -1}));
  EXPECT_TRUE(image.intersect({0, 0, -1}, {0, 0, 1})) << "from behind";
  EXPECT_FALSE(image.intersect({-3, 0, -1}, {1, 0, 0}));
  EXPECT_FALSE(image.intersect({-3, 0, 1}, {1, 0, 0}));
  EXPECT_TRUE(image.intersect({-3, 0, -1}, {1, 0, 0}, {1.1, true})) << "if it were that thick";
  EXPECT_FALSE(image.intersect({-3, 0, -1}, {1, 0, 0}, {0.9, true}));
}

TEST(GraphDepthImage, seesNothingWhereNothingIs) {
  const GraphDepthImage nothing(test::crossroads(), FragmentImage(test::kWidth, test::kHeight));
  EXPECT_FALSE(nothing.intersect({0, 0, 5}, {0, 0, -1}));
  const GraphDepthImage image = depthImageOf(test::crossroads(), test::wall(0));
  EXPECT_TRUE(image.intersect({0.3, 0, 5}, {0, 0, -1}));
  EXPECT_FALSE(image.intersect({0, 0, 5}, {0, 0, -1})) << "between the frusta";
  EXPECT_FALSE(image.intersect({0.3, 0, 5}, {0, 0, 1})) << "away from it";
  EXPECT_FALSE(image.intersect({100, 0, 5}, {0, 0, -1})) << "out of sight";
  EXPECT_FALSE(image.intersect({0, 0, 500}, {0, 0, 1}));
}

TEST(GraphDepthImage, meetsNothingAlongRaysThatAreNone) {
  const GraphDepthImage image = depthImageOf(GraphCamera(smallCamera()), test::wall(0));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinite = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, infinite, -infinite}) {
    EXPECT_FALSE(image.intersect({bad, 0, 5}, {0, 0, -1}));
    EXPECT_FALSE(image.intersect({0, 0, 5}, {0, bad, -1}));
  }
  EXPECT_FALSE(image.intersect({0, 0, 5}, {0, 0, 0}));
  EXPECT_FALSE(image.intersect({0, 0, 5}, {0, 0, -1e-200})) << "whose length underflows";
  // Along the rays of the camera, whose image is a point.
  const auto along = image.intersect({0, 0, 9}, {0, 0, -1});
  ASSERT_TRUE(along);
  EXPECT_NEAR(along->distance, 9, 1e-4);
}

TEST(GraphDepthImageDeath, refusesAnImageOfAnotherSize) {
  EXPECT_DEATH(GraphDepthImage(test::crossroads(), FragmentImage(3, 3)), "not of the camera's size");
}

}  // namespace
}  // namespace ocelli
