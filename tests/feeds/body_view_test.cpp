#include "oc_core/feeds/body_view.h"

#include <gtest/gtest.h>

#include "oc_core/feeds/feed_blobs.h"
#include "oc_core/feeds/feed_graph.h"
#include "tests/feeds/made_setup.h"

namespace ocelli {
namespace {

constexpr double kHeight = 1.7;
constexpr glm::ivec2 kMask{320, 240};
constexpr int kScale = 2;

TEST(BodyView, rowsAreWhereTheLensPutsThem) {
  const FeedSetup setup = test::tSetup();
  for (const glm::dvec3& place : {glm::dvec3(0.2, 0, -0.5), glm::dvec3(-0.6, 0, 0.2), glm::dvec3(0.5, 0, -1.9)}) {
    const Feed& feed = setup.feeds[0];
    const auto view = BodyView::of(feed, place, kHeight, kMask, kScale);
    ASSERT_TRUE(view);
    EXPECT_TRUE(view->hasFeet());
    EXPECT_TRUE(view->hasHead());
    const glm::dvec3 side = feed.pose.right() * 0.2;
    for (int y = view->firstRow(); y < view->lastRow(); ++y) {
      const BodyView::Row& row = view->row(y);
      const glm::dvec3 point = place + side + glm::dvec3(0, row.height * kHeight, 0);
      const auto pixel = feedPixelOf(feed, point);
      ASSERT_TRUE(pixel);
      // A line of a body is straight between nine heights; lenses bend it by less than half a cell there.
      EXPECT_NEAR(pixel->y / kScale, y + 0.5, 0.5);
      EXPECT_NEAR(pixel->x / kScale, row.axis + 0.2 / row.metresPerCell, 0.5);
    }
  }
}

TEST(BodyView, whoseFeetAreOutOfTheImageHasNoRowsThere) {
  const FeedSetup setup = test::tSetup();
  const auto view = BodyView::of(setup.feeds[0], {0, 0, 3.2}, kHeight, kMask, kScale);
  ASSERT_TRUE(view);
  EXPECT_FALSE(view->hasFeet());
  EXPECT_EQ(view->lastRow(), kMask.y);
}

TEST(BodyView, whoIsBehindTheCameraIsNotSeen) {
  const FeedSetup setup = test::tSetup();
  EXPECT_FALSE(BodyView::of(setup.feeds[0], {0, 0, 8}, kHeight, kMask, kScale));
  EXPECT_FALSE(BodyView::of(setup.feeds[0], setup.feeds[0].pose.eye, kHeight, kMask, kScale)) << "within it";
}

TEST(BodyView, anOutlineIsOneBody) {
  for (double height = -0.2; height < 1.2; height += 0.05) {
    const BodyOutline outline = bodyOutline(static_cast<float>(height));
    EXPECT_GE(outline.shareAt(0), 0);
    EXPECT_LE(outline.shareAt(0), 1);
    EXPECT_EQ(outline.shareAt(kBodyReach), 0) << "at " << height;
    for (float beside = 0; beside < kBodyReach; beside += 0.02f) {
      EXPECT_GE(outline.shareAt(beside), outline.shareAt(beside + 0.02f));
      EXPECT_EQ(outline.shareAt(beside), outline.shareAt(-beside));
    }
  }
  EXPECT_GT(bodyOutline(0.6f).shareAt(0), 0.9f);
  EXPECT_LT(bodyOutline(0.95f).shareAt(0.25f), 0.01f) << "beside a head";
  EXPECT_EQ(bodyOutline(1.3f).shareAt(0), 0);
}

TEST(BodyView, masksHave200To400Columns) {
  EXPECT_EQ(maskScaleOf(640), 2);
  EXPECT_EQ(maskScaleOf(768), 2);
  EXPECT_EQ(maskScaleOf(1280), 4);
  EXPECT_EQ(maskScaleOf(1920), 5);
  EXPECT_EQ(maskScaleOf(32), 2);
}

}  // namespace
}  // namespace ocelli
