// An hour, as fast as it can be run: the memory of the process does not grow.
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "oc_core/feeds_live/feeds_run.h"
#include "oc_core/feeds_video/video_writer.h"
#include "tests/base/temporary_folder.h"
#include "tests/feeds/made_setup.h"

namespace ocelli {
namespace {

constexpr int kFramesPerSecond = 10;
constexpr int kHourFrames = 3600 * kFramesPerSecond;

double residentMebibytes() {
  std::ifstream file("/proc/self/statm");
  double total = 0;
  double resident = 0;
  file >> total >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1 << 20);
}

void writeAnHour(const std::filesystem::path& path) {
  VideoWriter writer(path, 32, 24, {kFramesPerSecond, 20, false});
  Image<Rgb8> image(32, 24, Rgb8(90));
  for (int k = 0; k < kHourFrames; ++k) {
    image(k % 32, k / 32 % 24) = Rgb8(static_cast<uint8_t>(k));
    writer.add(image, static_cast<double>(k) / kFramesPerSecond);
  }
  writer.finish();
}

TEST(LongRun, anHourTakesNoMoreMemoryThanFiveMinutes) {
  const test::TemporaryFolder folder;
  writeAnHour(folder.path() / "hour.mkv");
  FeedSetup setup = test::tSetup();
  for (Feed& feed : setup.feeds) {
    feed.width = 32;
    feed.height = 24;
    feed.lens.focal = {25, 25};
    feed.lens.center = {16, 12};
    feed.source = (folder.path() / "hour.mkv").string();
  }
  setup.output.width = 32;
  setup.output.height = 24;
  FeedsRunOptions options;
  options.framesPerSecond = kFramesPerSecond;
  options.streams.maxWaitSeconds = 60;  // a busy machine must not make a feed late
  size_t frames = 0;
  double early = 0;
  const FeedsRunFigures figures = runFeeds(setup, options, [&](const ComposedFrame&) {
    if (++frames == 300 * kFramesPerSecond) {
      early = residentMebibytes();
    }
  });
  const double late = residentMebibytes();
  std::printf("%.1f MiB after five minutes, %.1f MiB after an hour; %.0f frames a second\n", early, late,
              figures.framesPerSecond);
  EXPECT_GE(frames, size_t{kHourFrames - 1});
  EXPECT_GT(early, 0);
  // A frame lost each second would be 8 MiB for each of the three feeds.
  EXPECT_LT(late - early, 4);
}

}  // namespace
}  // namespace ocelli
