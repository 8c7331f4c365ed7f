#include "oc_core/feeds/subject_places.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "tests/feeds/made_setup.h"

namespace ocelli {
namespace {

/// The box of a body 1.75 m high and 0.5 m wide at a place, as a blob that fills it.
FeedBlobs blobsOf(const Feed& feed, const std::vector<glm::dvec3>& places) {
  FeedBlobs blobs;
  blobs.core = Image<uint16_t>(feed.width / 2, feed.height / 2);
  for (const glm::dvec3& place : places) {
    const auto foot = feedPixelOf(feed, place);
    const auto head = feedPixelOf(feed, place + glm::dvec3(0, 1.75, 0));
    if (!foot || !head || head->y > feed.height || foot->x < 0 || foot->x > feed.width) {
      continue;
    }
    const double half = (foot->y - head->y) / 7;
    SubjectBlob blob;
    blob.lower = glm::max(glm::dvec2(foot->x - half, head->y), glm::dvec2(0));
    blob.upper = glm::min(glm::dvec2(foot->x + half, foot->y), glm::dvec2(feed.width, feed.height));
    blob.isCutBelow = foot->y >= feed.height;
    blob.foot = {foot->x, blob.upper.y};
    blobs.blobs.push_back(blob);
    for (int y = static_cast<int>(blob.lower.y / 2); y < static_cast<int>(blob.upper.y / 2); ++y) {
      for (int x = static_cast<int>(blob.lower.x / 2); x < static_cast<int>(blob.upper.x / 2); ++x) {
        blobs.core(x, y) = static_cast<uint16_t>(blobs.blobs.size());
      }
    }
  }
  blobs.wide = blobs.core;
  return blobs;
}

std::vector<FeedBlobs> allBlobs(const FeedSetup& setup, const std::vector<glm::dvec3>& places) {
  std::vector<FeedBlobs> all;
  for (const Feed& feed : setup.feeds) {
    all.push_back(blobsOf(feed, places));
  }
  return all;
}

/// The sums of the marks of a feed: erased and shown.
glm::dvec2 marked(const FeedGraph& graph, size_t frustum, const std::vector<FeedBlobs>& all) {
  const auto subjects = locateSubjects(graph.setup(), all);
  const Image<FeedMark> marks = markSubjects(graph, frustum, all[graph.feedIndexOf(frustum)], subjects);
  glm::dvec2 sum(0);
  for (const FeedMark& mark : marks) {
    sum += glm::dvec2(mark.erased, mark.shown) / 255.0;
  }
  return sum;
}

TEST(SubjectPlaces, twoFeedsTellOnePlace) {
  const FeedSetup setup = test::tSetup();
  const glm::dvec3 place(0.3, 0, -0.9);
  const auto subjects = locateSubjects(setup, allBlobs(setup, {place}));
  ASSERT_EQ(subjects.size(), 1u);
  EXPECT_GE(subjects[0].told.size(), 2u);
  // Feet are told by cells of 2 pixels, so lines of sight are off by up to a pixel: 1 cm at 6 m.
  EXPECT_LT(glm::length(subjects[0].place - place), 0.02);
}

TEST(SubjectPlaces, tellsTwoSubjectsApart) {
  const FeedSetup setup = test::tSetup();
  const auto subjects = locateSubjects(setup, allBlobs(setup, {{-4, 0, -1}, {4, 0, -1.4}}));
  EXPECT_EQ(subjects.size(), 2u);
}

TEST(SubjectPlaces, eachPlaceHasOneFrustumAndBothAddUpBetween) {
  const FeedGraph graph(test::tSetup());
  EXPECT_EQ(shareShown(graph, 0, {0, 0, 2}), 1);
  EXPECT_EQ(shareShown(graph, 1, {0, 0, 2}), 0);
  EXPECT_EQ(shareShown(graph, 1, {-4, 0, -1}), 1);
  EXPECT_EQ(shareShown(graph, 2, {-4, 0, -1}), 0);
  EXPECT_EQ(shareShown(graph, 0, {-4, 0, -1}), 0);
  for (double x = -1.5; x < 0; x += 0.05) {
    const glm::dvec3 place(x, 0, -1);
    EXPECT_NEAR(shareShown(graph, 0, place) + shareShown(graph, 1, place), 1, 1e-12);
  }
}

TEST(SubjectPlaces, erasesTheBackOfASubjectOfTheOtherBranch) {
  const FeedSetup setup = test::tSetup();
  const FeedGraph graph(setup);
  // In the left branch, so before the near face of "right", whose camera stands behind it.
  const auto all = allBlobs(setup, {{-3, 0, -1.2}});
  ASSERT_EQ(all[2].blobs.size(), 1u);
  EXPECT_TRUE(all[2].blobs[0].isCutBelow) << "that camera does not see the feet";
  const glm::dvec2 left = marked(graph, 1, all);
  EXPECT_EQ(left.x, 0);
  EXPECT_GT(left.y, 500);
  const glm::dvec2 right = marked(graph, 2, all);
  EXPECT_GT(right.x, 500);
  EXPECT_EQ(right.y, 0);
}

}  // namespace
}  // namespace ocelli
