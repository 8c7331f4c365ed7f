#include "oc_core/feeds/body_peeling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "oc_core/feeds/subject_body.h"
#include "tests/feeds/made_setup.h"

namespace ocelli {
namespace {

constexpr size_t kStem = 0;  // looks along the stem, from above heads

/// All bodies as one blob: the boxes of bodies 1.75 m high and 0.6 m wide.
FeedBlobs oneBlob(const Feed& feed, const std::vector<glm::dvec3>& places) {
  FeedBlobs blobs;
  blobs.core = Image<uint16_t>(feed.width / blobs.scale, feed.height / blobs.scale);
  SubjectBlob blob;
  blob.lower = glm::dvec2(feed.width, feed.height);
  for (const glm::dvec3& place : places) {
    const auto box = bodyBox(feed, place);
    if (!box) {
      ADD_FAILURE() << "the feed does not see " << place.x << ", " << place.z;
      continue;
    }
    blob.lower = glm::min(blob.lower, box->lower);
    blob.upper = glm::max(blob.upper, box->upper);
    const glm::ivec2 from = glm::ivec2(box->lower) / blobs.scale;
    const glm::ivec2 to = glm::ivec2(box->upper) / blobs.scale;
    for (int y = from.y; y < to.y; ++y) {
      for (int x = from.x; x < to.x; ++x) {
        blobs.core(x, y) = 1;
      }
    }
  }
  blob.isCutBelow = blob.upper.y >= feed.height;
  blob.foot = {(blob.lower.x + blob.upper.x) / 2, blob.upper.y};
  blobs.blobs.push_back(blob);
  blobs.wide = blobs.core;
  return blobs;
}

std::vector<PeeledBody> peeled(const std::vector<glm::dvec3>& places) {
  const FeedSetup setup = test::tSetup();
  return peelBodies(setup, kStem, oneBlob(setup.feeds[kStem], places));
}

double nearestOf(const std::vector<PeeledBody>& bodies, const glm::dvec3& place) {
  double least = 1e9;
  for (const PeeledBody& body : bodies) {
    least = std::min(least, glm::length(body.place - place));
  }
  return least;
}

// A cell of the mask is 2 pixels: at 6 m one covers 6 to 12 cm of the floor along the line of sight.
constexpr double kFeetError = 0.25;

TEST(BodyPeeling, oneBodyStandsWhereItsFeetAre) {
  const glm::dvec3 place(0.2, 0, -0.8);
  const auto bodies = peeled({place});
  ASSERT_EQ(bodies.size(), 1u);
  EXPECT_FALSE(bodies[0].isByHead);
  EXPECT_LT(nearestOf(bodies, place), kFeetError);
}

TEST(BodyPeeling, twoSideBySideAreTwo) {
  const auto bodies = peeled({{-0.4, 0, -0.6}, {0.4, 0, -1}});
  ASSERT_EQ(bodies.size(), 2u);
  EXPECT_LT(nearestOf(bodies, {-0.4, 0, -0.6}), kFeetError);
  EXPECT_LT(nearestOf(bodies, {0.4, 0, -1}), kFeetError);
}

TEST(BodyPeeling, whoseFeetAreHiddenIsPlacedByTheHead) {
  const glm::dvec3 near(0, 0, 1);
  const glm::dvec3 far(0.1, 0, -1.6);
  const auto bodies = peeled({far, near});
  ASSERT_EQ(bodies.size(), 2u);
  EXPECT_LT(nearestOf(bodies, near), kFeetError);
  EXPECT_TRUE(bodies[1].isByHead);
  // Rows of the mask are 2 pixels: at 7 m, and seen from half a metre above the head, some 0.4 m.
  EXPECT_LT(nearestOf(bodies, far), 0.9);
}

TEST(BodyPeeling, whoseFeetAreOutOfTheImageIsNearerThanTheFloorThere) {
  const FeedSetup setup = test::tSetup();
  const Feed& feed = setup.feeds[kStem];
  const auto border = placeBelow(setup, kStem, {feed.width / 2.0, static_cast<double>(feed.height)}, 0);
  ASSERT_TRUE(border);
  const glm::dvec3 under(feed.pose.eye.x, 0, feed.pose.eye.z);
  const glm::dvec3 place = under + (border->place - under) * 0.75;
  const auto bodies = peeled({place});
  ASSERT_EQ(bodies.size(), 1u);
  EXPECT_TRUE(bodies[0].isByHead);
  EXPECT_LT(nearestOf(bodies, place), 0.06 * border->distance) << "a step of the search";
}

TEST(BodyPeeling, limbsOfWhoIsKnownAreNobody) {
  const FeedSetup setup = test::tSetup();
  const FeedBlobs blobs = oneBlob(setup.feeds[kStem], {{0.2, 0, -0.8}});
  Image<uint16_t> known = blobs.core;
  const SubjectBlob& blob = blobs.blobs[0];
  // A strip on the left, of an arm that swings out.
  const int left = static_cast<int>(blob.lower.x) / blobs.scale;
  for (int y = 0; y < known.height(); ++y) {
    for (int x = left; x < left + 4; ++x) {
      known(x, y) = 0;
    }
  }
  EXPECT_TRUE(peelBodies(setup, kStem, blobs, known).empty());
}

TEST(BodyPeeling, nothingIsThereWithoutBlobs) {
  const FeedSetup setup = test::tSetup();
  FeedBlobs blobs;
  EXPECT_TRUE(peelBodies(setup, kStem, blobs).empty());
}

}  // namespace
}  // namespace ocelli
