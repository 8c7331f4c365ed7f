// The window on a (virtual) screen.
#include "oc_core/explore_window/explore_window_run.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>

#include "oc_core/base/error.h"
#include "oc_core/worlds/scene_source.h"
#include "tests/base/temporary_folder.h"

namespace ocelli {
namespace {

std::shared_ptr<ExploreScene> smallMaze(const Progress& progress) {
  SceneOptions options;
  options.fit = false;
  return std::make_shared<ExploreScene>(loadGuidedScene("builtin:maze,columns=3,rows=3", options, progress));
}

bool hasScreen() {
  return std::getenv("DISPLAY") != nullptr;
}

TEST(ExploreWindowRun, showsAndRecordsUntilItIsClosed) {
  if (!hasScreen()) {
    GTEST_SKIP() << "no display: install xvfb";
  }
  const test::TemporaryFolder folder;
  int frames = 0;
  bool isWhole = false;
  std::vector<std::filesystem::path> written;
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  runExploreWindow({.title = "Ocelli: a test",
                    .model = {.read = smallMaze},
                    .folder = folder.path(),
                    .record =
                        [&](const std::filesystem::path&, int width, int height) {
                          EXPECT_EQ(width % 2 + height % 2, 0);
                          return ExploreRecording{[&](const Image<Rgb8>&) { ++frames; }, [&] { isWhole = true; }};
                        },
                    .video = folder / "walk.mp4",
                    .wrote = [&](const std::filesystem::path& path) { written.push_back(path); },
                    .goesOn = [&] { return frames < 5 && std::chrono::steady_clock::now() < end; }});
  EXPECT_GE(frames, 5);
  EXPECT_TRUE(isWhole);
  EXPECT_EQ(written, std::vector<std::filesystem::path>{folder / "walk.mp4"});
}

TEST(ExploreWindowRun, goesOnWhereItsVideoFailsAndMakesItsFolder) {
  if (!hasScreen()) {
    GTEST_SKIP() << "no display: install xvfb";
  }
  const test::TemporaryFolder folder;
  int tried = 0;
  int turns = 0;
  bool isWhole = false;
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  runExploreWindow({.title = "Ocelli: a test",
                    .model = {.read = smallMaze},
                    .folder = folder.path() / "new" / "folder",
                    .record =
                        [&](const std::filesystem::path&, int, int) {
                          return ExploreRecording{[&](const Image<Rgb8>&) {
                                                    ++tried;
                                                    throw WorkError("no space", "walk.mp4", "make room");
                                                  },
                                                  [&] { isWhole = true; }};
                        },
                    .video = folder / "walk.mp4",
                    .goesOn =
                        [&] {
                          turns += tried > 0 ? 1 : 0;
                          return turns < 5 && std::chrono::steady_clock::now() < end;
                        }});
  EXPECT_EQ(tried, 1) << "it is off then";
  EXPECT_EQ(turns, 5);
  EXPECT_FALSE(isWhole);
  EXPECT_TRUE(std::filesystem::is_directory(folder.path() / "new" / "folder"));
  const std::filesystem::path file = folder.write("file", "");
  EXPECT_THROW(runExploreWindow({.title = "Ocelli: a test", .model = {.read = smallMaze}, .folder = file / "new"}),
               WorkError);
}

TEST(ExploreWindowRun, goesOnWhereItsVideoCannotBegin) {
  if (!hasScreen()) {
    GTEST_SKIP() << "no display: install xvfb";
  }
  const test::TemporaryFolder folder;
  int tried = 0;
  int turns = 0;
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  runExploreWindow({.title = "Ocelli: a test",
                    .model = {.read = smallMaze},
                    .folder = folder.path(),
                    .record = [&](const std::filesystem::path&, int, int) -> ExploreRecording {
                      ++tried;
                      throw WorkError("ffmpeg is missing", "walk.mp4", "install it");
                    },
                    .video = folder / "walk.mp4",
                    .goesOn =
                        [&] {
                          turns += tried > 0 ? 1 : 0;
                          return turns < 5 && std::chrono::steady_clock::now() < end;
                        }});
  EXPECT_EQ(tried, 1) << "it is not tried again";
  EXPECT_EQ(turns, 5);
}

TEST(ExploreWindowRun, aSceneThatCannotBeReadEndsIt) {
  if (!hasScreen()) {
    GTEST_SKIP() << "no display: install xvfb";
  }
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  EXPECT_THROW(runExploreWindow({.title = "Ocelli: a test",
                                 .model = {.read = [](const Progress&) -> std::shared_ptr<ExploreScene> {
                                   throw InputError("is not a scene", "a.txt", "give another");
                                 }},
                                 .goesOn = [&] { return std::chrono::steady_clock::now() < end; }}),
               InputError);
}

}  // namespace
}  // namespace ocelli
