// What a run of feeds asks of who started it.
#include "oc_core/feeds_live/feeds_run.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oc_core/base/error.h"
#include "oc_core/feeds_video/video_writer.h"
#include "oc_core/image/png_file.h"
#include "tests/base/temporary_folder.h"

namespace ocelli {
namespace {

class FeedsRunTest : public testing::Test {
 protected:
  FeedsRunTest() {
    Feed feed;
    feed.name = "door";
    feed.source = (folder_.path() / "a.mkv").string();
    feed.width = 64;
    feed.height = 48;
    feed.lens = {{60, 60}, {32, 24}};
    feed.pose = {{0, 1.5, 0}, {0, 1, -3}, {0, 1, 0}};
    setup_.feeds = {feed};
    setup_.frusta = {{"door", "", {}}};
    setup_.output = {64, 48, 40, {0, 1, -3}};
    VideoWriter writer(feed.source, 64, 48, {10, 20, true});
    for (int k = 0; k < 10; ++k) {
      writer.add(Image<Rgb8>(64, 48, Rgb8(static_cast<uint8_t>(20 * k))), 0.1 * k);
    }
    writer.finish();
    options_.framesPerSecond = 10;
  }

  test::TemporaryFolder folder_;
  FeedSetup setup_;
  FeedsRunOptions options_;
};

TEST_F(FeedsRunTest, remarksOnTheFirstFrameStandInTheLabels) {
  std::vector<int> tones;
  options_.remarkOn = [&](size_t feed, const Image<Rgb8>& frame) {
    EXPECT_EQ(feed, 0u);
    tones.push_back(frame(5, 5).x);
    return std::string("MOVED 14 px");
  };
  size_t shown = 0;
  runFeeds(setup_, options_, [&](const ComposedFrame& frame) {
    EXPECT_EQ(frame.labels.at(0).remark, "MOVED 14 px");
    ++shown;
  });
  EXPECT_EQ(tones, std::vector<int>{0}) << "the first frame, and no other one";
  EXPECT_GE(shown, 9u);
}

TEST_F(FeedsRunTest, aCoveredFeedIsSaidAndComesBack) {
  // Light and dark halves, and a hand before the camera from frame 20 to before 35. Tones go up and down, so that no
  // frame is like the one before.
  const auto place = [](int k) {
    Image<Rgb8> image(64, 48, Rgb8(static_cast<uint8_t>(90 + k % 2)));
    for (int y = 0; y < 48; ++y) {
      for (int x = 32; x < 64; ++x) {
        image(x, y) = Rgb8(static_cast<uint8_t>(180 + k % 2));
      }
    }
    return image;
  };
  writePng(folder_.path() / "a.png", place(0));
  setup_.feeds[0].background = (folder_.path() / "a.png").string();
  // The hand of a camera without noise is a picture that does not change.
  for (const int noise : {4, 0}) {
    VideoWriter writer(setup_.feeds[0].source, 64, 48, {10, 20, true});
    for (int k = 0; k < 50; ++k) {
      const auto hand = static_cast<uint8_t>(8 + noise * (k % 2));
      writer.add(k >= 20 && k < 35 ? Image<Rgb8>(64, 48, Rgb8(hand)) : place(k), 0.1 * k);
    }
    writer.finish();
    std::vector<FeedState> states;
    const FeedsRunFigures figures = runFeeds(setup_, options_, [&](const ComposedFrame& frame) {
      states.push_back(frame.labels.at(0).state);
      EXPECT_EQ(frame.composer.subjects().count(), 0u) << "a hand is no subject";
    });
    ASSERT_GE(states.size(), 49u);
    EXPECT_EQ(states[15], FeedState::kLive);
    EXPECT_EQ(states[33], FeedState::kCovered);
    EXPECT_EQ(states[40], FeedState::kLive);
    EXPECT_TRUE(figures.feeds[0].wasCovered);
    EXPECT_EQ(figures.feeds[0].wasFrozen, noise == 0);
  }
}

TEST_F(FeedsRunTest, whoIsInAFrozenFeedIsErased) {
  // Somebody stands 3 m away all the time; from frame 20 to before 75 the feed repeats one frame. Tones go up and
  // down, so that no other frame is like the one before.
  const auto place = [](int k, bool isSomebodyThere) {
    Image<Rgb8> image(128, 96, Rgb8(static_cast<uint8_t>(90 + k % 2)));
    for (int y = 20; isSomebodyThere && y < 85; ++y) {
      for (int x = 55; x < 73; ++x) {
        image(x, y) = {200, 60, 40};
      }
    }
    return image;
  };
  Feed& feed = setup_.feeds[0];
  feed.width = 128;
  feed.height = 96;
  feed.lens = {{120, 120}, {64, 48}};
  writePng(folder_.path() / "a.png", place(0, false));
  feed.background = (folder_.path() / "a.png").string();
  VideoWriter writer(feed.source, 128, 96, {10, 20, true});
  for (int k = 0; k < 90; ++k) {
    writer.add(place(k >= 20 && k < 75 ? 20 : k, true), 0.1 * k);
  }
  writer.finish();
  std::vector<size_t> subjects;
  std::vector<int> reds;
  std::vector<FeedState> states;
  options_.hasLabels = false;
  runFeeds(setup_, options_, [&](const ComposedFrame& frame) {
    subjects.push_back(frame.composer.subjects().count());
    reds.push_back(frame.image(32, 24).x);
    states.push_back(frame.labels.at(0).state);
  });
  ASSERT_GE(states.size(), 89u);
  for (const size_t live : {15u, 85u}) {
    EXPECT_EQ(states[live], FeedState::kLive) << live;
    EXPECT_EQ(subjects[live], 1u) << live;
    EXPECT_GT(reds[live], 150) << live;
  }
  EXPECT_EQ(states[40], FeedState::kFrozen);
  EXPECT_EQ(subjects[70], 0u);
  EXPECT_LT(reds[40], 110);
}

TEST_F(FeedsRunTest, aFeedWithoutNoiseInWhichSomethingSmallMovesIsNotFrozen) {
  Feed& feed = setup_.feeds[0];
  feed.width = 640;
  feed.height = 480;
  feed.lens = {{600, 600}, {320, 240}};
  VideoWriter writer(feed.source, 640, 480, {10, 20, true});
  for (int k = 0; k < 30; ++k) {
    Image<Rgb8> image(640, 480, Rgb8(90));
    for (int y = 200; y < 225; ++y) {
      for (int x = 100 + 10 * (k % 20); x < 110 + 10 * (k % 20); ++x) {
        image(x, y) = Rgb8(190);
      }
    }
    writer.add(image, 0.1 * k);
  }
  writer.finish();
  EXPECT_FALSE(runFeeds(setup_, options_, [](const ComposedFrame&) {}).feeds[0].wasFrozen)
      << "its frames differ by 0.16 levels on average";
}

TEST_F(FeedsRunTest, agesAreThoseOfTheImages) {
  double sum = 0;
  double oldest = 0;
  size_t images = 0;
  const FeedsRunFigures figures = runFeeds(setup_, options_, [&](const ComposedFrame& frame) {
    const double age = frame.seconds - frame.feedSeconds[0];
    sum += age;
    oldest = std::max(oldest, age);
    ++images;
  });
  ASSERT_EQ(images, figures.frames);
  EXPECT_NEAR(figures.feeds[0].meanAgeSeconds, sum / static_cast<double>(images), 1e-9);
  EXPECT_NEAR(figures.feeds[0].maxAgeSeconds, oldest, 1e-9);
}

TEST_F(FeedsRunTest, aClockOfAnotherTimeEndsItAndIsSaid) {
  Feed late = setup_.feeds[0];
  late.name = "yard";
  late.clockOffsetSeconds = -1e9;  // its timestamps are of 1970, say
  setup_.feeds.push_back(late);
  size_t images = 0;
  options_.isStopped = [&] { return images > 100; };
  const FeedsRunFigures figures = runFeeds(setup_, options_, [&](const ComposedFrame&) { ++images; });
  EXPECT_LE(images, 11u) << "ten frames, and what shows that they are over";
  EXPECT_EQ(figures.feeds[0].message, "");
  EXPECT_THAT(figures.feeds[1].message, testing::HasSubstr("clock_offset_seconds"));
  EXPECT_THAT(figures.feeds[1].message, testing::HasSubstr("1e+09 s later"));
}

TEST_F(FeedsRunTest, aShortPauseIsGoneThrough) {
  VideoWriter writer(setup_.feeds[0].source, 64, 48, {10, 20, true});
  writer.add(Image<Rgb8>(64, 48, Rgb8(10)), 0);
  writer.add(Image<Rgb8>(64, 48, Rgb8(90)), 30);
  writer.finish();
  size_t images = 0;
  runFeeds(setup_, options_, [&](const ComposedFrame&) { ++images; });
  EXPECT_GE(images, 300u);
}

TEST_F(FeedsRunTest, saysOnceThatAFeedIsLost) {
  Feed lost = setup_.feeds[0];
  lost.name = "yard";
  lost.source = (folder_.path() / "none.mkv").string();
  setup_.feeds.push_back(lost);
  std::vector<std::pair<size_t, std::string>> said;
  options_.onLost = [&](size_t feed, const std::string& message) { said.emplace_back(feed, message); };
  runFeeds(setup_, options_, [](const ComposedFrame&) {});
  ASSERT_EQ(said.size(), 1u);
  EXPECT_EQ(said[0].first, 1u);
  EXPECT_THAT(said[0].second, testing::HasSubstr("No such file"));
}

TEST_F(FeedsRunTest, stoppedBeforeTheFirstFrameItMakesNoImage) {
  setup_.feeds[0].source = "udp://127.0.0.1:1";  // nobody sends
  options_.isStopped = [] { return true; };
  const FeedsRunFigures figures =
      runFeeds(setup_, options_, [](const ComposedFrame&) { FAIL() << "an image was composed"; });
  EXPECT_EQ(figures.frames, 0u);
}

TEST_F(FeedsRunTest, progressGoesToTheEndOfTheFeeds) {
  std::vector<double> shares;
  runFeeds(
      setup_, options_, [](const ComposedFrame&) {}, [&](std::string_view, double share) { shares.push_back(share); });
  ASSERT_GE(shares.size(), 9u);
  EXPECT_LT(shares.front(), 0.1);
  EXPECT_GT(shares.back(), 0.85);
  EXPECT_LE(shares.back(), 1.01);
}

TEST_F(FeedsRunTest, aRemarkMayEndIt) {
  options_.remarkOn = [](size_t, const Image<Rgb8>&) -> std::string {
    throw WorkError("camera 1 (door) has moved", "setup.json", "put it back");
  };
  EXPECT_THROW(runFeeds(setup_, options_, [](const ComposedFrame&) { FAIL() << "an image was composed"; }), WorkError);
}

}  // namespace
}  // namespace ocelli
