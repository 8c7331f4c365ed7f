// Jobs that pack a scene: several at once, ended ones, full disks.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>
#include <set>

#include "oc_core/base/error.h"
#include "tests/base/full_disk.h"
#include "tests/base/temporary_folder.h"
#include "tests/pack/packed_meshes.h"

namespace ocelli {
namespace {

using test::fileBytes;
using test::TemporaryFolder;
using testing::AllOf;
using testing::HasSubstr;

/// What `work` tells the user where it fails; empty where it does not.
template <class Work>
std::string failureOf(const Work& work) {
  try {
    work();
    return "";
  } catch (const WorkError& error) {
    return error.what();
  }
}

size_t entriesIn(const std::filesystem::path& folder) {
  return static_cast<size_t>(std::distance(std::filesystem::directory_iterator(folder), {}));
}

TEST(PackJob, ASecondOneOnTheSameOutputIsRefusedAndHarmsNothing) {
  const TemporaryFolder folder;
  const Mesh ball = test::bumpyBall(20'000);
  packScene(MeshSource(ball), folder / "alone.opack");
  std::set<std::string> stages;
  const auto meanwhile = [&](std::string_view stage, double) {
    if (stages.insert(std::string(stage)).second) {
      EXPECT_THAT(failureOf([&] { packScene(MeshSource(test::bumpyBall(500)), folder / "ball.opack"); }),
                  AllOf(HasSubstr("ball.opack: another job"), HasSubstr("try:")))
          << stage;
    }
  };
  packScene(MeshSource(ball), folder / "ball.opack", {.sourceKey = "ball"}, [&](std::string_view stage, double share) {
    // Before it begins there is no job.
    if (stage != "counting triangles") {
      meanwhile(stage, share);
    }
  });
  EXPECT_THAT(stages, testing::UnorderedElementsAre("sorting triangles", "making levels of detail", "writing"));
  EXPECT_EQ(fileBytes(folder / "ball.opack"), fileBytes(folder / "alone.opack"));
  EXPECT_EQ(entriesIn(folder.path()), 2U);
}

TEST(PackJob, OneThatIsRefusedLeavesNothing) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "folder.opack");
  const Mesh ball = test::bumpyBall(500);
  EXPECT_THAT(failureOf([&] { packScene(MeshSource(ball), folder / "folder.opack"); }), HasSubstr("folder.opack"));
  EXPECT_EQ(entriesIn(folder.path()), 1U);
  EXPECT_THAT(failureOf([&] { packScene(MeshSource(ball), folder / "none" / "ball.opack"); }), HasSubstr("No such"));
  EXPECT_FALSE(std::filesystem::exists(folder / "none"));
}

TEST(PackJob, GoesOnAfterOneThatWasKilledBeforeItsKeyWasWritten) {
  for (const char* left : {"lock", "source.partial"}) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "ball.opack.work");
    folder.write("ball.opack.work/lock", "");
    folder.write(std::string("ball.opack.work/") + left, "ba");
    packScene(MeshSource(test::bumpyBall(500)), folder / "ball.opack", {.sourceKey = "ball"});
    EXPECT_EQ(entriesIn(folder.path()), 1U) << left;
  }
}

TEST(PackJob, AFolderOfSomeoneElseStaysAsItIs) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "ball.opack.work");
  folder.write("ball.opack.work/part_0", "mine");
  EXPECT_THAT(failureOf([&] { packScene(MeshSource(test::bumpyBall(500)), folder / "ball.opack"); }),
              HasSubstr("ball.opack.work"));
  EXPECT_EQ(fileBytes(folder / "ball.opack.work/part_0"), "mine");
  EXPECT_EQ(entriesIn(folder / "ball.opack.work"), 1U);
}

/// Whatever it is doing when the disk is full, the next job goes on from there.
TEST(PackJob, GoesOnAfterAFullDisk) {
  const TemporaryFolder folder;
  const Mesh ball = test::bumpyBall(60'000);
  const PackOptions options{.sourceKey = "ball"};
  packScene(MeshSource(ball), folder / "wanted.opack", options);
  const std::string wanted = fileBytes(folder / "wanted.opack");
  for (const char* full : {"sorting triangles", "making levels of detail", "writing"}) {
    std::optional<test::FileSizeLimit> limit;
    const auto fill = [&](std::string_view stage, double) {
      if (stage == full && !limit) {
        limit.emplace(100'000);
      }
    };
    EXPECT_THAT(failureOf([&] { packScene(MeshSource(ball), folder / "ball.opack", options, fill); }),
                AllOf(HasSubstr("ball.opack"), HasSubstr("space")))
        << full;
    EXPECT_FALSE(std::filesystem::exists(folder / "ball.opack"));
    EXPECT_FALSE(std::filesystem::exists(folder / "ball.opack.partial"));
    limit.reset();
    const PackReport report = packScene(MeshSource(ball), folder / "ball.opack", options);
    if (full == std::string("writing")) {
      EXPECT_EQ(report.partsAtHand, report.parts);
    }
    EXPECT_EQ(fileBytes(folder / "ball.opack"), wanted) << full;
    std::filesystem::remove(folder / "ball.opack");
  }
}

TEST(PackJob, SaysThatTheDiskIsFull) {
  const TemporaryFolder folder;
  const test::SmallDisk disk(folder / "disk", "1m");
  if (!disk.works()) {
    GTEST_SKIP() << "this system lets one mount nothing; the case above needs no rights";
  }
  EXPECT_THAT(failureOf([&] { packScene(MeshSource(test::bumpyBall(30'000)), folder / "disk/ball.opack"); }),
              AllOf(HasSubstr("No space left"), HasSubstr("try: free some space")));
}

}  // namespace
}  // namespace ocelli
