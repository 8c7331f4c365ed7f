// Poses of feeds from pictures of tags, and whether cameras have moved since.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "oc_core/base/error.h"
#include "oc_core/feeds/feed_graph.h"
#include "oc_core/feeds_calibration/calibrate_feeds.h"
#include "tests/base/temporary_folder.h"
#include "tests/feeds_calibration/calibration_rigs.h"

namespace ocelli::test {
namespace {

class CalibratePoses : public testing::Test {
 protected:
  CalibratePoses() : rig_(calibrationRig(1)) {
    RandomNumbers random(1, 3);
    writePng(folder_ / "tags.png", tagPicture(rig_, random));
    Feed feed;
    feed.name = "left";
    feed.source = (folder_ / "tags.png").string();
    feed.width = rig_.width;
    feed.height = rig_.height;
    feed.lens = rig_.lens;
    feed.pose = {{0, 1, 0}, {0, 1, -1}, {0, 1, 0}};
    setup_.feeds = {feed};
  }

  /// The mean distance in pixels between where both cameras see points of the room.
  double errorOf(const Feed& feed) const {
    double sum = 0;
    size_t count = 0;
    Feed truth = feed;
    truth.pose = rig_.pose;
    for (const glm::dvec3& point : seenPoints(rig_)) {
      const auto a = feedPixelOf(truth, point);
      const auto b = feedPixelOf(feed, point);
      if (a && b) {
        sum += glm::distance(*a, *b);
        ++count;
      }
    }
    return count > 0 ? sum / static_cast<double>(count) : 1e9;
  }

  TemporaryFolder folder_;
  CalibrationRig rig_;
  FeedSetup setup_;
};

TEST_F(CalibratePoses, putACameraWhereItsTagsSay) {
  const PoseCalibration result = calibratePoses(setup_, rig_.places, "places.json", {});
  ASSERT_EQ(result.feeds.size(), 1u);
  EXPECT_GE(result.feeds[0].tags, 2u);
  EXPECT_LT(result.feeds[0].rmsPixels, 0.5);
  EXPECT_LT(errorOf(setup_.feeds[0]), 0.5) << "the goal of calibrations, here with the lens known";
}

TEST_F(CalibratePoses, sayWhetherACameraHasMoved) {
  setup_.feeds[0].pose = rig_.pose;
  std::vector<PoseCheck> checks = checkPoses(setup_, rig_.places, kMovedPixels, {});
  ASSERT_EQ(checks.size(), 1u);
  EXPECT_FALSE(checks[0].hasMoved) << checks[0].medianPixels;
  // A turn by 1/50: focal length / 50 pixels in the middle of the image.
  const glm::dvec3 ahead = glm::normalize(rig_.pose.target - rig_.pose.eye);
  setup_.feeds[0].pose.target = rig_.pose.eye + ahead + glm::normalize(glm::cross(ahead, rig_.pose.up)) / 50.0;
  checks = checkPoses(setup_, rig_.places, kMovedPixels, {});
  EXPECT_TRUE(checks[0].hasMoved);
  EXPECT_NEAR(checks[0].medianPixels, rig_.lens.focal.x / 50, 0.3 * rig_.lens.focal.x / 50);
  EXPECT_THAT(checks[0].message, testing::HasSubstr("camera 1 (left) has moved: "));
}

TEST_F(CalibratePoses, sayWhichTagsNoCameraSees) {
  KnownTag far = rig_.places.tags.front();
  far.id = 500;
  rig_.places.tags.push_back(far);
  const PoseCalibration result = calibratePoses(setup_, rig_.places, "places.json", {});
  EXPECT_THAT(result.warnings, testing::Contains(testing::HasSubstr("500")));
}

TEST_F(CalibratePoses, sayWhichFeedHasFailedAndGoOn) {
  Feed other = setup_.feeds[0];
  other.name = "other";
  setup_.feeds[0].width = 320;
  setup_.feeds.push_back(other);
  Feed gone = other;
  gone.name = "gone";
  gone.source = "/nowhere/it.mkv";
  setup_.feeds.push_back(gone);
  const FeedSetup before = setup_;
  const PoseCalibration result = calibratePoses(setup_, rig_.places, "places.json", {});
  EXPECT_THAT(result.feeds[0].failure, testing::HasSubstr("320x"));
  EXPECT_EQ(result.feeds[1].failure, "");
  EXPECT_THAT(result.feeds[2].failure, testing::HasSubstr("/nowhere/it.mkv"));
  EXPECT_EQ(setup_.feeds[0], before.feeds[0]);
  EXPECT_LT(errorOf(setup_.feeds[1]), 0.5);
  EXPECT_EQ(setup_.feeds[2], before.feeds[2]);
}

TEST_F(CalibratePoses, sayThatAFeedSeesNoTags) {
  KnownPlaces others;
  others.tags = {rig_.places.tags.front()};
  others.tags[0].id = 500;
  const PoseCalibration result = calibratePoses(setup_, others, "places.json", {});
  EXPECT_THAT(result.feeds[0].failure, testing::HasSubstr("0 points of known place"));
}

TEST_F(CalibratePoses, leaveWhatRunsCheckThemBy) {
  KnownTag far = rig_.places.tags.front();
  far.id = 500;
  rig_.places.tags.push_back(far);
  const PoseCalibration result = calibratePoses(setup_, rig_.places, "places.json", {});
  ASSERT_EQ(setup_.places.tags.size(), result.feeds[0].tags) << "a tag that nobody sees is of no use";
  EXPECT_EQ(setup_.places.tags[0].seenBy, std::vector<std::string>{"left"});
  const Image<Rgb8> image = readPng(folder_ / "tags.png");
  EXPECT_FALSE(checkPose(setup_, 0, image, setup_.places).hasMoved);
  const PoseCheck blind = checkPose(setup_, 0, Image<Rgb8>(image.width(), image.height(), Rgb8(90)), setup_.places);
  EXPECT_EQ(blind.tags, 0u);
  EXPECT_TRUE(blind.shouldSeeTags);
  EXPECT_THAT(blind.message, testing::HasSubstr("camera 1 (left) sees no known tag"));
}

}  // namespace
}  // namespace ocelli::test
