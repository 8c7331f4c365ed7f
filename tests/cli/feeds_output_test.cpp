// What `ocelli feeds run` and `panes` do to files that are there already, and what they say of feeds that are not.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oc_core/base/file_bytes.h"
#include "oc_core/feeds/feed_setup.h"
#include "oc_core/feeds_video/video_writer.h"
#include "tests/base/temporary_folder.h"
#include "tests/cli/run_program.h"

namespace ocelli::test {
namespace {

using testing::HasSubstr;
using testing::Not;

/// Two feeds of half a second: one before a wall, and one whose video is not there.
class FeedsOutput : public testing::Test {
 protected:
  FeedsOutput() {
    FeedSetup setup;
    for (const char* name : {"wall", "gone"}) {
      Feed feed;
      feed.name = name;
      feed.source = name + std::string(".mkv");
      feed.width = 64;
      feed.height = 48;
      feed.lens = {{60, 60}, {32, 24}};
      feed.pose = {{0, 1.5, 0}, {0, 1, -3}, {0, 1, 0}};
      setup.feeds.push_back(feed);
    }
    setup.frusta = {{"wall", "", {}}};
    setup.output = {64, 48, 40, {0, 1, -3}};
    folder_.write("setup.json", jsonText(setup));
    VideoWriter video(folder_ / "wall.mkv", 64, 48, {10, 20, false});
    for (int k = 0; k < 5; ++k) {
      video.add(Image<Rgb8>(64, 48, Rgb8(static_cast<uint8_t>(40 * k))), 0.1 * k);
    }
    video.finish();
  }

  std::string at(const char* name) const { return inQuotes(folder_ / name); }
  ProgramResult run(const std::string& command, const std::string& options) const {
    return runProgram("feeds " + command + " " + at("setup.json") + " " + options);
  }

  TemporaryFolder folder_;
};

TEST_F(FeedsOutput, theVideoOfAFeedIsNotReplaced) {
  const std::string before = readFile(folder_ / "wall.mkv");
  for (const char* command : {"run", "panes"}) {
    const ProgramResult result = run(command, "-o " + at("wall.mkv"));
    EXPECT_EQ(result.exitCode, 2) << command;
    EXPECT_THAT(result.error, HasSubstr("this is the video of the feed \"wall\""));
  }
  EXPECT_EQ(readFile(folder_ / "wall.mkv"), before);
}

TEST_F(FeedsOutput, framesOfAnEarlierRunAreSaid) {
  const ProgramResult first = run("run", "--frames-per-second 10 -o " + at("frames"));
  EXPECT_EQ(first.exitCode, 0) << first.error;
  EXPECT_THAT(first.error, Not(HasSubstr("earlier run")));
  const ProgramResult second = run("run", "--frames-per-second 10 --seconds 0.2 -o " + at("frames"));
  EXPECT_THAT(second.error, HasSubstr("frame-000002.png and what follows are frames of an earlier run"));
}

TEST_F(FeedsOutput, aLostFeedIsSaidAtOnce) {
  for (const char* command : {"run", "panes"}) {
    const ProgramResult result = run(command, "-o " + at("x.mp4"));
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_THAT(result.error, HasSubstr("warning: the feed \"gone\" is lost\n  "));
    EXPECT_THAT(result.error, HasSubstr("No such file"));
  }
}

TEST_F(FeedsOutput, figuresSayWhatWasWrongForSomeTime) {
  VideoWriter video(folder_ / "wall.mkv", 64, 48, {10, 20, false});
  for (int k = 0; k < 40; ++k) {  // the same image from 1 s to 3 s
    video.add(Image<Rgb8>(64, 48, Rgb8(static_cast<uint8_t>(k < 10 || k >= 30 ? 5 * k : 45))), 0.1 * k);
  }
  video.finish();
  const ProgramResult table = run("run", "-o " + at("x.mp4"));
  EXPECT_THAT(table.output, HasSubstr("for some time it was frozen"));
  const ProgramResult json = run("run", "--json -o " + at("x.mp4"));
  EXPECT_THAT(json.output, HasSubstr("\"frozen\""));
}

TEST_F(FeedsOutput, anInterruptBeforeTheFirstImageIsSaid) {
  FeedSetup setup = readFeedSetup(folder_ / "setup.json");
  for (Feed& feed : setup.feeds) {
    feed.source = "udp://127.0.0.1:1";  // nobody sends
  }
  folder_.write("live.json", jsonText(setup));
  // The video is begun once signals are caught.
  const ProgramResult result =
      runShell("\"$OCELLI\" feeds run " + at("live.json") + " -o " + at("x.mp4") + " & while ! test -e " +
               at("x.mp4.partial") + "; do sleep 0.05; done; kill -TERM $!; wait $!");
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_THAT(result.error, HasSubstr("interrupted before the first image"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "x.mp4"));
}

TEST_F(FeedsOutput, evaluateTakesFeedsInTheOrderOfTheTruth) {
  const std::string simulated = at("simulated");
  ASSERT_EQ(runProgram("feeds simulate --seconds 0.2 --size 64x48 --walkers 1 -o " + simulated).exitCode, 0);
  EXPECT_EQ(runProgram("feeds evaluate " + simulated).exitCode, 0);
  FeedSetup setup = feedSetupFromJsonText(readFile(folder_ / "simulated" / "setup.json"), "setup.json");
  std::swap(setup.feeds[1], setup.feeds[2]);
  folder_.write("simulated/setup.json", jsonText(setup));
  const ProgramResult swapped = runProgram("feeds evaluate " + simulated);
  EXPECT_EQ(swapped.exitCode, 2);
  EXPECT_THAT(swapped.error, HasSubstr("another order"));
}

TEST_F(FeedsOutput, evaluateSaysWhatItTakes) {
  const ProgramResult result = runProgram("feeds evaluate " + inQuotes(folder_.path()));
  EXPECT_EQ(result.exitCode, 2);
  EXPECT_THAT(result.error, HasSubstr("give the folder that `ocelli feeds simulate` has written"));
}

}  // namespace
}  // namespace ocelli::test
