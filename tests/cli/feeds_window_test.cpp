// `ocelli feeds run --window` and `ocelli feeds edit` where there is no display.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oc_core/feeds/feed_setup.h"
#include "oc_core/image/png_file.h"
#include "tests/base/temporary_folder.h"
#include "tests/cli/run_program.h"

namespace ocelli::test {
namespace {

TEST(FeedsWindowCommand, saysWhatIsMissing) {
  const TemporaryFolder folder;
  writePng(folder / "a.png", Image<Rgb8>(64, 48, Rgb8(90)));
  FeedSetup setup;
  Feed feed;
  feed.name = "door";
  feed.source = "a.png";
  feed.width = 64;
  feed.height = 48;
  feed.lens = {{60, 60}, {32, 24}};
  setup.feeds = {feed};
  setup.frusta = {{"door", "", {}}};
  setup.output = {64, 48, 40, {0, 1, -3}};
  folder.write("setup.json", jsonText(setup));
  const ProgramResult result =
      runShell("env -u DISPLAY -u WAYLAND_DISPLAY \"$OCELLI\" feeds run " + inQuotes(folder / "setup.json") +
               " --window -o " + inQuotes(folder / "video.mp4"));
  EXPECT_NE(result.exitCode, 0);
  EXPECT_THAT(result.error, testing::AnyOf(testing::HasSubstr("display"), testing::HasSubstr("OCELLI_WITH_OPENGL")));
  EXPECT_THAT(result.error, testing::HasSubstr("try:"));
  EXPECT_THAT(result.error, testing::Not(testing::HasSubstr("--offscreen"))) << "it has no such option";
  EXPECT_FALSE(std::filesystem::exists(folder / "video.mp4")) << "nothing was begun";
  const ProgramResult edit = runShell("env -u DISPLAY -u WAYLAND_DISPLAY \"$OCELLI\" feeds edit " +
                                      inQuotes(folder / "setup.json") + " -o " + inQuotes(folder / "edited.json"));
  EXPECT_NE(edit.exitCode, 0);
  EXPECT_THAT(edit.error, testing::AnyOf(testing::HasSubstr("display"), testing::HasSubstr("OCELLI_WITH_OPENGL")));
  const ProgramResult nowhere = runProgram("feeds run " + inQuotes(folder / "setup.json"));
  EXPECT_EQ(nowhere.exitCode, 2);
  EXPECT_THAT(nowhere.error, testing::HasSubstr("nowhere for the image to go"));
}

}  // namespace
}  // namespace ocelli::test
