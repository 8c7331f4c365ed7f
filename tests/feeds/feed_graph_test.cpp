// The chain of homographies beside rays that are followed face by face.
#include "oc_core/feeds/feed_graph.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "oc_core/base/error.h"
#include "oc_core/feeds/feed_map.h"
#include "tests/feeds/made_setup.h"

namespace ocelli {
namespace {

using test::chainSetup;
using test::tSetup;

struct WalkedRay {
  size_t frustum = 0;
  glm::dvec3 from{0};
  glm::dvec3 along{0};
};

/// Whether a point of the plane of a quad lies within it.
bool isInQuad(const std::array<glm::dvec3, 4>& quad, const glm::dvec3& point) {
  const glm::dvec3 normal = glm::cross(quad[2] - quad[0], quad[3] - quad[1]);
  for (size_t i = 0; i < quad.size(); ++i) {
    if (glm::dot(glm::cross(quad[(i + 1) % quad.size()] - quad[i], point - quad[i]), normal) < 0) {
      return false;
    }
  }
  return true;
}

/// Follows the ray of a pixel: at each near face that it meets it goes on away from the eye of that feed.
WalkedRay walkRay(const FeedSetup& setup, const glm::dvec2& pixel) {
  const auto& poseOf = [&](const FeedFrustum& f) -> const FeedPose& {
    return setup.feeds[static_cast<size_t>(setup.feedIndex(f.feed))].pose;
  };
  FeedPose view = poseOf(setup.frusta[0]);
  view.target = setup.output.target;
  const double focal = setup.output.height / 2.0 / std::tan(setup.output.fovVerticalDegrees * 3.14159265358979 / 360);
  const glm::dvec2 offset = (pixel - glm::dvec2(setup.output.width, setup.output.height) / 2.0) / focal;
  WalkedRay ray{0, view.eye, view.right() * offset.x + view.down() * offset.y + view.forward()};
  for (size_t i = 1; i < setup.frusta.size(); ++i) {  // parents stand before children
    const FeedFrustum& frustum = setup.frusta[i];
    if (setup.frusta[ray.frustum].feed != frustum.parent) {
      continue;
    }
    const glm::dvec3 normal = glm::cross(frustum.near[2] - frustum.near[0], frustum.near[3] - frustum.near[1]);
    const double t = glm::dot(normal, frustum.near[0] - ray.from) / glm::dot(normal, ray.along);
    const glm::dvec3 hit = ray.from + ray.along * t;
    if (t > 0 && isInQuad(frustum.near, hit)) {
      ray = {i, hit, hit - poseOf(frustum).eye};
    }
  }
  return ray;
}

void compareWithRays(const FeedSetup& setup) {
  const FeedGraph graph(setup);
  std::vector<size_t> seen(setup.frusta.size(), 0);
  size_t others = 0;
  for (double y = 0.37; y < setup.output.height; y += 3.1) {
    for (double x = 0.41; x < setup.output.width; x += 2.7) {
      const WalkedRay ray = walkRay(setup, {x, y});
      const std::vector<size_t> chain = graph.chainAt({x, y});
      if (chain.back() != ray.frustum) {
        ++others;  // on a border, to within a pixel's rounding
        continue;
      }
      ++seen[ray.frustum];
      const Feed& feed = graph.feedOf(ray.frustum);
      // Any point of the ray beyond the face has one place in the feed.
      for (const double along : {0.001, 0.4, 3.0}) {
        const auto wanted = feedPixelOf(feed, ray.from + ray.along * along);
        const auto direction = graph.directionAt(ray.frustum, {x, y});
        ASSERT_TRUE(direction);
        const auto found = pixelOf(feed.lens, *direction);
        ASSERT_EQ(found.has_value(), wanted.has_value());
        if (found) {
          // The root's axes are in single precision: 1e-7 of a focal length of 700 pixels.
          EXPECT_NEAR(found->x, wanted->x, 2e-3);
          EXPECT_NEAR(found->y, wanted->y, 2e-3);
        }
      }
    }
  }
  EXPECT_LE(others, 3u);
  for (const size_t count : seen) {
    EXPECT_GT(count, 50u);
  }
}

TEST(FeedGraph, homographiesAreTheRaysOfTwoBranches) {
  compareWithRays(tSetup());
}

TEST(FeedGraph, homographiesAreTheRaysOfAChainOfThree) {
  compareWithRays(chainSetup());
}

TEST(FeedGraph, seesWhatTheGraphCameraSees) {
  const FeedGraph graph(chainSetup());
  for (double y = 5; y < 240; y += 20) {
    for (double x = 5; x < 320; x += 20) {
      const RayPath path = graph.camera().rayPath(glm::vec2(x, y));
      const size_t last = graph.chainAt({x, y}).back();
      const auto direction = graph.directionAt(last, {x, y});
      ASSERT_TRUE(direction);
      const Feed& feed = graph.feedOf(last);
      const auto& p = path.positionAt(path.tMax());
      const auto ideal = feedPixelOf(feed, glm::dvec3(path.pointAt(p)));
      ASSERT_TRUE(ideal);
      EXPECT_NEAR(glm::length(*ideal - *pixelOf(feed.lens, *direction)), 0, 0.01);  // paths are in single precision
    }
  }
}

/// At the border of a near face that lies on a surface both sides show one point.
TEST(FeedGraph, isContinuousWhereFacesEndAtWalls) {
  const FeedSetup setup = tSetup();
  const FeedGraph graph(setup);
  const auto& corners = setup.frusta[1].near;
  for (size_t edge = 0; edge < 4; ++edge) {
    for (double share = 0.05; share < 1; share += 0.1) {
      const glm::dvec3 point = corners[edge] + (corners[(edge + 1) % 4] - corners[edge]) * share;
      const auto& frusta = graph.camera().frusta();
      const glm::dvec4 q = frusta[0].pixelFromWorld * glm::dvec4(point, 1);
      const glm::dvec2 pixel(q.x / q.w, q.y / q.w);
      for (const size_t frustum : {size_t{0}, size_t{1}}) {
        const auto direction = graph.directionAt(frustum, pixel);
        ASSERT_TRUE(direction);
        const auto found = pixelOf(graph.feedOf(frustum).lens, *direction);
        const auto wanted = feedPixelOf(graph.feedOf(frustum), point);
        EXPECT_NEAR(glm::length(*found - *wanted), 0, 5e-3);
      }
    }
  }
}

TEST(FeedGraph, mapHoldsTheSamePlaces) {
  const FeedGraph graph(chainSetup());
  const FeedMap map(graph);
  for (int y = 0; y < map.height(); y += 7) {
    for (int x = 0; x < map.width(); x += 7) {
      const auto places = map.placesAt(static_cast<size_t>(y) * 320 + static_cast<size_t>(x));
      auto chain = graph.chainAt({x + 0.5, y + 0.5});
      ASSERT_EQ(places.size(), chain.size());
      EXPECT_EQ(places.back().frustum, 0);
      EXPECT_EQ(places.front().frustum, chain.back());
      const auto pixel = graph.feedPixelAt(chain.back(), {x + 0.5, y + 0.5});
      ASSERT_EQ(places.front().isInFeed(), pixel.has_value());
      if (pixel && pixel->x > 1 && pixel->y > 1 && pixel->x < 639 && pixel->y < 479) {
        EXPECT_NEAR(places.front().x / 256.0 + 0.5, pixel->x, 0.5 / 256 + 1e-9);
        EXPECT_NEAR(places.front().y / 256.0 + 0.5, pixel->y, 0.5 / 256 + 1e-9);
      }
    }
  }
  EXPECT_GT(map.coverage(1), 0.9);
}

std::string errorOf(const FeedSetup& setup) {
  try {
    const FeedGraph graph(setup);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(FeedGraph, refusesFacesThatCross) {
  FeedSetup setup = tSetup();
  for (glm::dvec3& corner : setup.frusta[2].near) {
    corner.x -= 0.5;
  }
  EXPECT_THAT(errorOf(setup), testing::HasSubstr("cannot stand there: it takes rays that"));
  EXPECT_THAT(errorOf(setup), testing::HasSubstr("move it beside the others"));
}

TEST(FeedGraph, refusesACameraBeyondItsFaceAndFacesOutOfSight) {
  FeedSetup setup = tSetup();
  setup.frusta[1].near = {{{-1.2, 0, 9}, {-1.2, 2.8, 9}, {1.2, 2.8, 9}, {1.2, 0, 9}}};
  EXPECT_THAT(errorOf(setup), testing::HasSubstr("begins before"));
  setup.frusta[1].near = {{{-31, 0, 0}, {-31, 2.8, 0}, {-30, 2.8, 0}, {-30, 0, 0}}};
  EXPECT_THAT(errorOf(setup), testing::HasSubstr("out of the sight"));
}

}  // namespace
}  // namespace ocelli
