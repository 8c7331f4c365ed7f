#include "oc_core/explore_window/explore_recorder.h"

#include <gtest/gtest.h>

#include "oc_core/base/error.h"

namespace ocelli {
namespace {

/// What a video was given.
struct Video {
  int width = 0;
  int height = 0;
  std::vector<Rgb8> corners;  ///< the first pixel of each frame
  bool isWhole = false;

  OpenExploreVideo open() {
    return [this](const std::filesystem::path&, int wide, int tall) {
      width = wide;
      height = tall;
      return ExploreRecording{[this](const Image<Rgb8>& frame) {
                                EXPECT_EQ(frame.width(), width);
                                EXPECT_EQ(frame.height(), height);
                                corners.push_back(frame(0, 0));
                              },
                              [this] { isWhole = true; }};
    };
  }
};

Image<Rgb8> plain(int width, int height, uint8_t grey) {
  return {width, height, Rgb8(grey)};
}

TEST(ExploreRecorder, framesComeAtTheRateOfTheVideo) {
  Video video;
  ExploreRecorder recorder(video.open());
  recorder.start("walk.mp4", 64, 48);
  EXPECT_TRUE(recorder.isOn());
  recorder.add(plain(64, 48, 1), 1.0 / 60);  // half of a frame
  EXPECT_TRUE(video.corners.empty());
  EXPECT_TRUE(recorder.isDue(1.0 / 60));
  EXPECT_FALSE(recorder.isDue(1.0 / 120));
  recorder.add(plain(64, 48, 2), 1.0 / 60);
  recorder.add(plain(64, 48, 3), 0.1);  // a slow one stands for three
  EXPECT_EQ(video.corners, (std::vector<Rgb8>{Rgb8(2), Rgb8(3), Rgb8(3), Rgb8(3)}));
  recorder.stop();
  EXPECT_TRUE(video.isWhole);
  EXPECT_FALSE(recorder.isOn());
}

TEST(ExploreRecorder, isOffOnceAFrameCannotBeWritten) {
  ExploreRecorder recorder([](const std::filesystem::path&, int, int) {
    return ExploreRecording{[](const Image<Rgb8>&) { throw WorkError("no space", "walk.mp4", "make room"); }, [] {}};
  });
  recorder.start("walk.mp4", 64, 48);
  EXPECT_THROW(recorder.add(plain(64, 48, 1), 0.1), WorkError);
  EXPECT_FALSE(recorder.isOn());
  EXPECT_NO_THROW(recorder.add(plain(64, 48, 1), 0.1));
  EXPECT_NO_THROW(recorder.start("walk.mp4", 64, 48)) << "another one may be begun";
}

TEST(ExploreRecorder, sidesAreEvenAndStayAsTheyWere) {
  Video video;
  ExploreRecorder recorder(video.open());
  recorder.start("walk.mp4", 65, 49);
  EXPECT_EQ(video.width, 64);
  EXPECT_EQ(video.height, 48);
  recorder.add(plain(65, 49, 7), 0.05);
  recorder.add(plain(10, 200, 8), 0.05);
  EXPECT_EQ(video.corners.size(), 3U);
}

TEST(ExploreRecorder, whatDoesNotFollowIsAnError) {
  ExploreRecorder none({});
  EXPECT_THROW(none.start("walk.mp4", 64, 48), InputError);
  EXPECT_THROW(none.stop(), InputError);
  none.add(plain(64, 48, 1), 1);  // nothing happens
  Video video;
  ExploreRecorder recorder(video.open());
  recorder.start("walk.mp4", 64, 48);
  EXPECT_THROW(recorder.start("again.mp4", 64, 48), InputError);
}

}  // namespace
}  // namespace ocelli
