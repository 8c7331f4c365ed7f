// Folders of frames, and videos by programs that stand for ffmpeg.
#include "display_sim/observing/frame_sink.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>

#include "oc_core/base/error.h"
#include "tests/base/temporary_folder.h"

namespace ocelli {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::UnorderedElementsAre;

std::vector<std::string> namesIn(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) {
    names.push_back(entry.path().filename().string());
  }
  return names;
}

Image<Rgb8> frameOf(uint8_t level) {
  return Image<Rgb8>(4, 2, Rgb8(level));
}

TEST(FrameFolder, appearsWhenItIsWhole) {
  const test::TemporaryFolder folder;
  const auto sink = frameFolder(folder / "series/");
  sink->add(frameOf(10));
  sink->add(frameOf(20));
  EXPECT_FALSE(fs::exists(folder / "series"));
  sink->finish();
  EXPECT_THAT(namesIn(folder / "series"), UnorderedElementsAre("frame_0000.png", "frame_0001.png"));
  EXPECT_EQ(readPng(folder / "series/frame_0001.png"), frameOf(20));
  EXPECT_THAT(namesIn(folder / ""), UnorderedElementsAre("series"));
}

TEST(FrameFolder, leavesNothingWithoutItsEnd) {
  const test::TemporaryFolder folder;
  frameFolder(folder / "series")->add(frameOf(10));
  EXPECT_TRUE(fs::is_empty(folder / ""));
}

TEST(FrameFolder, replacesFramesAndNothingElse) {
  const test::TemporaryFolder folder;
  for (const int frames : {3, 1}) {
    const auto sink = frameFolder(folder / "series");
    for (int i = 0; i < frames; ++i) {
      sink->add(frameOf(10));
    }
    sink->finish();
  }
  EXPECT_THAT(namesIn(folder / "series"), UnorderedElementsAre("frame_0000.png"));
  folder.write("series/frame_x.png", "mine");
  const auto again = frameFolder(folder / "series");
  again->add(frameOf(10));
  again->add(frameOf(10));
  again->finish();
  EXPECT_THAT(namesIn(folder / "series"), UnorderedElementsAre("frame_0000.png", "frame_0001.png", "frame_x.png"));
  folder.write("file", "mine");
  EXPECT_THROW(frameFolder(folder / "file"), InputError);
  EXPECT_THROW(frameFolder(folder / "file/series"), WorkError);
}

/// With a program called ffmpeg, alone on the search path but for the system's shell tools.
class VideoFileTest : public testing::Test {
 protected:
  void SetUp() override { old_ = std::getenv("PATH"); }
  void TearDown() override { setenv("PATH", old_.c_str(), 1); }

  void install(const std::string& script) {
    fs::create_directory(folder_ / "bin");
    fs::permissions(folder_.write("bin/ffmpeg", "#!/bin/sh\nPATH=/usr/bin:/bin\n" + script), fs::perms::owner_all);
    setenv("PATH", (folder_ / "bin").c_str(), 1);
  }
  std::string bytesOf(const std::string& name) const {
    std::ifstream file(folder_ / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  /// What goes wrong with a video of so many frames.
  std::string failure(int frames) {
    try {
      const auto sink = videoFile(folder_ / "film.mp4", {4, 2, 24});
      for (int i = 0; i < frames; ++i) {
        sink->add(frameOf(10));
      }
      sink->finish();
    } catch (const WorkError& error) {
      return error.what();
    }
    return "none";
  }

  test::TemporaryFolder folder_;
  std::string old_;
};

TEST_F(VideoFileTest, ffmpegGetsThePixelsAndItsOutputItsName) {
  install("for last; do :; done; echo \"$@\" > '" + (folder_ / "said").string() + "'; cat > \"$last\"\n");
  const auto sink = videoFile(folder_ / "film.webm", {4, 2, 12.5});
  sink->add(frameOf(10));
  sink->add(frameOf(20));
  EXPECT_FALSE(fs::exists(folder_ / "film.webm"));
  sink->finish();
  EXPECT_EQ(bytesOf("film.webm"), std::string(24, '\n') + std::string(24, '\x14'));
  EXPECT_FALSE(fs::exists(folder_ / "film.webm.partial"));
  EXPECT_THAT(bytesOf("said"), AllOf(HasSubstr("-video_size 4x2"), HasSubstr("-framerate 12.500000"),
                                     HasSubstr("libvpx-vp9"), HasSubstr("film.webm.partial")));
}

TEST_F(VideoFileTest, whatFfmpegSaysIsInTheError) {
  install("for last; do :; done; echo half > \"$last\"; echo 'no such encoder' >&2; exit 3\n");
  EXPECT_THAT(failure(2), AllOf(HasSubstr("no such encoder"), HasSubstr("film.mp4"), HasSubstr("folder")));
  EXPECT_THAT(failure(200000), HasSubstr("no such encoder")) << "it stops reading";
  EXPECT_THAT(namesIn(folder_ / ""), UnorderedElementsAre("bin"));
}

TEST_F(VideoFileTest, isNotLeftHalfDone) {
  install("for last; do :; done; cat > \"$last\"\n");
  {
    const auto sink = videoFile(folder_ / "film.mp4", {4, 2, 24});
    sink->add(frameOf(10));
  }
  EXPECT_THAT(namesIn(folder_ / ""), UnorderedElementsAre("bin"));
}

TEST_F(VideoFileTest, aMissingFfmpegIsAClearError) {
  setenv("PATH", (folder_ / "nothing").c_str(), 1);
  EXPECT_THAT(failure(1), AllOf(HasSubstr("apt-get install ffmpeg"), HasSubstr("folder")));
  EXPECT_TRUE(fs::is_empty(folder_ / ""));
}

TEST_F(VideoFileTest, unwritableAndUnknownOutputsAreErrors) {
  install("cat > /dev/null\n");
  EXPECT_THROW(videoFile(folder_ / "no/such/film.mp4", {4, 2, 24}), WorkError);
  EXPECT_THROW(videoFile(folder_ / "film.avi", {4, 2, 24}), InputError);
}

}  // namespace
}  // namespace ocelli
