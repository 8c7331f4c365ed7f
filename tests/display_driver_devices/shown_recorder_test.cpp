#include "display_driver/devices/shown_recorder.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "display_driver/devices/shown_images.h"
#include "display_sim/frames/svol_file.h"
#include "tests/base/temporary_folder.h"
#include "tests/display_driver_wire/made_volumes.h"

namespace ocelli {
namespace {

ShownRefresh refreshOf(uint64_t number, std::vector<ShownRefresh::Part> parts) {
  return {.refresh = number,
          .begin = static_cast<DeviceMicroseconds>(number) * 40'000,
          .length = 40'000,
          .phaseErrorDegrees = 0.5,
          .parts = std::move(parts)};
}

class ShownRecorderTest : public testing::Test {
 protected:
  /// Three refreshes: a frame, the same again, and a torn one.
  std::vector<RecordedRefresh> record() {
    ShownRecorder recorder(path_, profile_);
    recorder.refreshEnded(refreshOf(0, {{0, 1, false}}), first_);
    recorder.refreshEnded(refreshOf(1, {{0, 1, false}}), first_);
    recorder.refreshEnded(refreshOf(2, {{0, 1, false}, {5, 2, true}}), second_);
    recorder.finish();
    return recorder.refreshes();
  }

  test::TemporaryFolder folder_;
  std::filesystem::path path_ = folder_.path() / "shown.svol";
  DisplayProfile profile_ = smallProfile();
  Volume first_ = madeVolume(profile_, 1);
  Volume second_ = madeVolume(profile_, 2);
};

TEST_F(ShownRecorderTest, whatIsShownAgainIsWrittenOnce) {
  const std::vector<RecordedRefresh> refreshes = record();
  ASSERT_EQ(refreshes.size(), 3u);
  EXPECT_EQ(refreshes[0].volume, 0u);
  EXPECT_EQ(refreshes[1].volume, 0u);
  EXPECT_EQ(refreshes[2].volume, 1u);
  EXPECT_TRUE(readSvol(path_, 0) == first_);
  EXPECT_TRUE(readSvol(path_, 1) == second_);
  SvolReader reader(path_);
  EXPECT_EQ(reader.frames().size(), 2u);
  EXPECT_EQ(reader.frames()[1].timeMicroseconds, 80'000u);
}

TEST_F(ShownRecorderTest, darknessIsLookedAtEachTime) {
  ShownRecorder recorder(path_, profile_);
  recorder.refreshEnded(refreshOf(0, {{0, 0, false}}), Volume(profile_));
  recorder.refreshEnded(refreshOf(1, {{0, 0, false}}), Volume(profile_));
  recorder.refreshEnded(refreshOf(2, {{0, 0, false}}), first_);  // shown from an earlier session
  recorder.finish();
  EXPECT_EQ(recorder.refreshes()[1].volume, 0u);
  EXPECT_TRUE(readSvol(path_, 1) == first_);
}

TEST_F(ShownRecorderTest, theTableHasALineARefresh) {
  writeRefreshTable(folder_.path() / "shown.csv", record());
  std::ifstream file(folder_.path() / "shown.csv");
  std::stringstream text;
  text << file.rdbuf();
  EXPECT_EQ(text.str(),
            "refresh,begin_us,length_us,phase_error_degrees,frames,torn,coarse,volume\n"
            "0,0,40000,0.5000,1@0,0,0,0\n"
            "1,40000,40000,0.5000,1@0,0,0,0\n"
            "2,80000,40000,0.5000,1@0 2@5,1,1,1\n");
}

class CountingSink : public FrameSink {
 public:
  void add(const Image<Rgb8>& frame) override { frames.push_back(frame); }
  void finish() override {}
  std::vector<Image<Rgb8>> frames;
};

TEST_F(ShownRecorderTest, everyRefreshIsAImage) {
  std::vector<RecordedRefresh> refreshes = record();
  refreshes[1].volume.reset();  // left out: its image is the one before
  ObserverOptions options;
  options.width = 32;
  options.height = 32;
  CountingSink sink;
  EXPECT_EQ(drawShown(path_, refreshes, options, 25, sink), 3u);
  ASSERT_EQ(sink.frames.size(), 3u);
  EXPECT_TRUE(sink.frames[0] == sink.frames[1]);
  EXPECT_FALSE(sink.frames[1] == sink.frames[2]);
  refreshes.insert(refreshes.begin(), {refreshOf(0, {{0, 0, false}}), 0});  // nothing was shown yet
  CountingSink later;
  EXPECT_EQ(drawShown(path_, refreshes, options, 25, later), 3u);
  CountingSink slow;
  EXPECT_EQ(drawShown(path_, refreshes, options, 12.5, slow), 2u);
}

}  // namespace
}  // namespace ocelli
