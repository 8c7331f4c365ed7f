#include "oc_core/pack/packed_scene.h"

#include <gtest/gtest.h>

#include <fstream>
#include <stdexcept>

#include "oc_core/base/error.h"
#include "oc_core/base/parallel.h"
#include "tests/base/temporary_folder.h"
#include "tests/pack/packed_meshes.h"

namespace ocelli {
namespace {

using test::fileBytes;
using test::TemporaryFolder;

/// What `work` tells the user; empty where it does not throw.
template <class Work>
std::string complaint(const Work& work) {
  try {
    work();
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(PackedScene, HoldsEachTriangleOfTheSceneOnce) {
  const TemporaryFolder folder;
  const Mesh ball = test::bumpyBall(60'000);
  const PackedScene scene = test::packed(ball, folder / "ball.opack");
  EXPECT_EQ(scene.triangleCount(), ball.triangles.size());
  EXPECT_EQ(test::trianglesOf(meshOf(scene, allClusters(scene))), test::trianglesOf(ball));
}

TEST(PackedScene, TrianglesWithoutNeighborsStayAsTheyAre) {
  const TemporaryFolder folder;
  Mesh loose;
  for (int i = 0; i < 20'000; ++i) {
    const glm::vec3 at(static_cast<float>(i % 30), static_cast<float>(i / 30 % 30), static_cast<float>(i / 900));
    loose.positions.insert(loose.positions.end(), {at, at + glm::vec3(0.3f, 0, 0), at + glm::vec3(0, 0.3f, 0)});
    const auto first = static_cast<uint32_t>(3 * i);
    loose.triangles.emplace_back(first, first + 1, first + 2);
  }
  const PackedScene scene = test::packed(loose, folder / "loose.opack");
  EXPECT_EQ(test::trianglesOf(meshOf(scene, allClusters(scene))), test::trianglesOf(loose));
}

TEST(PackedScene, TheSameBytesForAnyNumberOfThreads) {
  const TemporaryFolder folder;
  const Mesh ball = test::bumpyBall(60'000);
  const int threads = threadCount();
  setThreadCount(1);
  packScene(MeshSource(ball), folder / "one.opack");
  setThreadCount(threads);
  packScene(MeshSource(ball), folder / "many.opack");
  EXPECT_EQ(fileBytes(folder / "one.opack"), fileBytes(folder / "many.opack"));
}

TEST(PackedScene, LeavesNothingElseBehind) {
  const TemporaryFolder folder;
  packScene(MeshSource(test::bumpyBall(2'000)), folder / "ball.opack");
  size_t files = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder.path())) {
    ++files;
  }
  EXPECT_EQ(files, 1U);
}

TEST(PackedScene, AJobThatWasEndedGoesOn) {
  const TemporaryFolder folder;
  const Mesh ball = test::bumpyBall(600'000);
  const PackOptions options{.sourceKey = "the ball"};
  const int threads = threadCount();
  setThreadCount(1);
  const auto stop = [](std::string_view stage, double share) {
    if (stage == "making levels of detail" && share > 0.1) {
      throw std::runtime_error("killed");
    }
  };
  EXPECT_THROW(packScene(MeshSource(ball), folder / "ended.opack", options, stop), std::runtime_error);
  setThreadCount(threads);
  EXPECT_FALSE(std::filesystem::exists(folder / "ended.opack"));
  const PackReport again = packScene(MeshSource(ball), folder / "ended.opack", options);
  EXPECT_GT(again.partsAtHand, 0U);
  const PackReport whole = packScene(MeshSource(ball), folder / "whole.opack", options);
  EXPECT_EQ(whole.partsAtHand, 0U);
  EXPECT_EQ(fileBytes(folder / "ended.opack"), fileBytes(folder / "whole.opack"));
}

TEST(PackedScene, AFolderOfSomeoneElseStays) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "ball.opack.work");
  folder.write("ball.opack.work/notes.txt", "mine");
  EXPECT_THROW(packScene(MeshSource(test::bumpyBall(2'000)), folder / "ball.opack"), WorkError);
  EXPECT_EQ(fileBytes(folder / "ball.opack.work" / "notes.txt"), "mine");
}

TEST(PackedScene, WhatWasMadeOfAnotherSceneIsNotUsed) {
  const TemporaryFolder folder;
  const auto stop = [](std::string_view stage, double) {
    if (stage == "making levels of detail") {
      throw std::runtime_error("killed");
    }
  };
  EXPECT_THROW(packScene(MeshSource(test::bumpyBall(2'000)), folder / "ball.opack", {.sourceKey = "small"}, stop),
               std::runtime_error);
  const Mesh other = test::bumpyBall(8'000);
  const PackReport report = packScene(MeshSource(other), folder / "ball.opack", {.sourceKey = "large"});
  EXPECT_EQ(report.partsAtHand, 0U);
  EXPECT_EQ(report.triangles, other.triangles.size());
}

TEST(PackedScene, WhatIsNoneIsRefused) {
  const TemporaryFolder folder;
  EXPECT_NE(complaint([&] { PackedScene scene(folder / "none.opack"); }).find("No such file"), std::string::npos);
  EXPECT_NE(complaint([&] { PackedScene scene(folder.path()); }), "");
  EXPECT_NE(complaint([&] { PackedScene scene(folder.write("short.opack", "ply")); }).find("too short"),
            std::string::npos);
  EXPECT_NE(complaint([&] {
              PackedScene scene(folder.write("zeros.opack", std::string(4096, '\0')));
            }).find("no packed scene"),
            std::string::npos);
}

TEST(PackedScene, AFileThatWasCutOffIsRefused) {
  const TemporaryFolder folder;
  packScene(MeshSource(test::bumpyBall(3'000)), folder / "ball.opack");
  const std::string bytes = fileBytes(folder / "ball.opack");
  for (const size_t size : {bytes.size() - 1, bytes.size() / 2, size_t{200}}) {
    const auto path = folder.write("cut.opack", bytes.substr(0, size));
    EXPECT_NE(complaint([&] { PackedScene scene(path); }).find("cut off"), std::string::npos) << size;
  }
}

/// Every byte but those that only fill up to an alignment is under a checksum.
TEST(PackedScene, AChangedByteIsFound) {
  const TemporaryFolder folder;
  packScene(MeshSource(test::bumpyBall(3'000)), folder / "ball.opack");
  const std::string bytes = fileBytes(folder / "ball.opack");
  size_t unnoticed = 0;
  size_t tried = 0;
  for (size_t at = 0; at < bytes.size(); at += 211) {
    std::string changed = bytes;
    changed[at] = static_cast<char>(changed[at] ^ 0x10);
    const auto path = folder.write("changed.opack", changed);
    unnoticed += complaint([&] { PackedScene(path).verify(); }).empty() ? 1 : 0;
    ++tried;
  }
  EXPECT_GT(tried, 300U);
  EXPECT_LE(unnoticed, tried / 50);
}

TEST(PackedScene, ASceneWithoutTrianglesIsRefused) {
  const TemporaryFolder folder;
  EXPECT_NE(complaint([&] { packScene(MeshSource(Mesh{}), folder / "none.opack"); }).find("no triangle"),
            std::string::npos);
}

}  // namespace
}  // namespace ocelli
