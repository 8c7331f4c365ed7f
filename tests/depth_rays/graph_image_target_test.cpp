#include "oc_core/depth_rays/graph_image_target.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "oc_core/base/random.h"
#include "oc_core/depth_rays/depth_image_target.h"
#include "oc_core/ocri/placed_image.h"
#include "oc_core/render/raycast.h"
#include "tests/render/crossing_corridors.h"

namespace ocelli {
namespace {

/// Corridors, the image of a graph camera that sees around their corners, and both targets that it makes.
class GraphTargets : public testing::Test {
 protected:
  RayPath randomRay() {
    const auto number = [&](float least, float most) { return random_.inRange(least, most); };
    const glm::vec3 origin = random_.below(2) == 0
                                 ? glm::vec3(number(-0.9f, 0.9f), number(0.1f, 1.9f), number(0, 9))
                                 : glm::vec3(number(-7.5f, 7.5f), number(0.1f, 1.9f), number(-1.9f, 0));
    const glm::vec3 direction(number(-1, 1), number(-1, 1), number(-1, 1) + 1e-6f);
    return {origin, origin + glm::normalize(direction) * 60.0f};
  }
  /// Where a ray meets the scene itself, if the camera sees that place.
  std::optional<float> seenMeeting(const RayPath& ray) const {
    const Fragment truth = scene_.intersect(ray);
    const glm::vec3 at = truth.covered() ? positionOf(truth, mesh_) : glm::vec3(1e3f);
    const auto q = camera_.project(at);
    const Fragment seen = q ? scene_.intersect(camera_.rayPath({q->u, q->v})) : Fragment{};
    const bool same = seen.covered() && glm::distance(positionOf(seen, mesh_), at) < 2e-3f;
    return same && q->u >= 0 && q->u < 480 && q->v >= 0 && q->v < 320 ? std::optional(truth.t) : std::nullopt;
  }

  Mesh mesh_ = test::crossingCorridors();
  RayScene scene_{mesh_};
  GraphCamera camera_ = test::aroundCorners();
  FragmentImage fragments_ = raycast(camera_, mesh_, scene_);
  GraphImageTarget walk_{camera_, fragments_, mesh_, {.thickness = 0.01}};
  DepthImageTarget pyramid_{{placedImage(camera_, fragments_, mesh_, camera_.root().view(), "graph camera")}};
  Random random_{7};
};

// Rays that meet what the camera sees: the walk and the pyramid find it, and so do their slow references.
TEST_F(GraphTargets, agreeWithTheSceneAndEachOther) {
  size_t seen = 0;
  size_t walked = 0;
  size_t climbed = 0;
  size_t both = 0;
  RayCost walkCost;
  RayCost fineCost;
  RayCost pyramidCost;
  for (int i = 0; i < 3000; ++i) {
    const RayPath ray = randomRay();
    const std::optional<Hit> walk = walk_.hit(ray, walkCost);
    const std::optional<Hit> fine = walk_.hitPixelByPixel(ray, fineCost);
    ASSERT_EQ(walk.has_value(), fine.has_value()) << "tiles lose nothing";
    EXPECT_TRUE(!walk || (walk->t == fine->t && walk->element == fine->element));
    const std::optional<Hit> pyramid = pyramid_.hit(ray, pyramidCost);
    if (i % 20 == 0) {  // it tests each of 300,000 triangles
      const std::optional<Hit> slow = pyramid_.hitSlowly(ray);
      ASSERT_EQ(pyramid.has_value(), slow.has_value());
      EXPECT_TRUE(!pyramid || (pyramid->t == slow->t && pyramid->element == slow->element));
    }
    const std::optional<float> truth = seenMeeting(ray);
    const auto isRight = [&](const std::optional<Hit>& hit) {
      return hit && truth && std::abs(hit->t - *truth) < 0.05f;
    };
    seen += truth.has_value();
    walked += isRight(walk);
    climbed += isRight(pyramid);
    both += isRight(walk) && isRight(pyramid);
  }
  ASSERT_GT(seen, 1000u);
  // What is lost passes closer to an edge than a pixel, or meets walls that the camera sees edge-on.
  EXPECT_GT(walked, seen * 95 / 100);
  EXPECT_GT(climbed, seen * 93 / 100);
  EXPECT_GT(both, seen * 90 / 100);
  EXPECT_LT(walkCost.steps(), fineCost.steps());
  EXPECT_LT(pyramidCost.steps() * 2, walkCost.steps()) << "the pyramid takes less than half of the steps";
}

TEST_F(GraphTargets, tellWhatIsHit) {
  const RayPath ray{{-0.3f, 1, 8}, {-1.7f, 1, 4}};
  const std::optional<Hit> hit = walk_.hit(ray);
  ASSERT_TRUE(hit);
  const Fragment truth = scene_.intersect(ray);
  EXPECT_NEAR(hit->t, truth.t, 1e-2f);
  EXPECT_NEAR(hit->position.x, -1, 1e-2f) << "the wall";
  EXPECT_LT(glm::distance(hit->color, colorOf(truth, mesh_)), 1e-5f);
  ASSERT_LT(hit->element, fragments_.size());
  EXPECT_LT(glm::distance(positionOf(fragments_[hit->element], mesh_), hit->position), 0.05f);
  EXPECT_TRUE(contains(walk_.bounds(), positionOf(fragments_[hit->element], mesh_)));
  size_t samples = 0;
  for (const Fragment& fragment : fragments_) {
    samples += fragment.covered();
  }
  EXPECT_EQ(walk_.sampleCount(), samples);
}

TEST_F(GraphTargets, missBeyondTheEndOfARay) {
  const glm::vec3 from(-0.3f, 1, 8);
  const glm::vec3 to(-1.7f, 1, 4);
  const RayPath whole{from, to};
  ASSERT_TRUE(walk_.hit(whole));
  const float t = walk_.hit(whole)->t;
  const float share = t / glm::distance(from, to);
  EXPECT_FALSE(walk_.hit({from, glm::mix(from, to, 0.9f * share)}));
  // A ray of several pieces is the same ray.
  const RayPath pieces{from, glm::mix(from, to, 0.5f * share), to};
  ASSERT_TRUE(walk_.hit(pieces));
  EXPECT_NEAR(walk_.hit(pieces)->t, t, 1e-4f);
}

TEST_F(GraphTargets, answerDegenerateRays) {
  constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
  EXPECT_FALSE(walk_.hit({}));
  EXPECT_FALSE(walk_.hit({{0, 1, 8}}));
  EXPECT_FALSE(walk_.hit({{0, 1, 8}, {0, 1, 8}}));
  EXPECT_FALSE(walk_.hit({{kNaN, 1, 8}, {0, 1, 0}}));
  EXPECT_FALSE(walk_.hit({{0, 1, 8}, {1e30f, 1, 0}}));
  const GraphImageTarget empty(camera_, FragmentImage(camera_.width(), camera_.height()), mesh_, {});
  EXPECT_FALSE(empty.hit({{0, 1, 8}, {0, 1, -6}}));
  EXPECT_TRUE(empty.bounds().empty());
  EXPECT_EQ(graphThickness(empty.bounds()), 0);
}

}  // namespace
}  // namespace ocelli
