#include "oc_core/worlds/packed_source.h"

#include <gtest/gtest.h>

#include "oc_core/base/error.h"
#include "tests/base/temporary_folder.h"
#include "tests/pack/packed_meshes.h"

namespace ocelli {
namespace {

using test::TemporaryFolder;

TEST(PackedSource, IsTheSceneThatWasPacked) {
  const TemporaryFolder folder;
  for (const char* source : {"builtin:statues", "builtin:boxes", "builtin:crowd,copies=7"}) {
    const std::string path = (folder / "scene.opack").string();
    packSource(source, {}, path);
    EXPECT_EQ(test::trianglesOf(loadScene(path)), test::trianglesOf(loadScene(source))) << source;
  }
}

TEST(PackedSource, KeepsColors) {
  const TemporaryFolder folder;
  const std::string path = (folder / "scene.opack").string();
  packSource("builtin:teapot", {}, path);
  const auto light = [](const Mesh& mesh) {
    double sum = 0;
    for (const glm::uvec3& t : mesh.triangles) {
      for (glm::length_t k = 0; k < 3; ++k) {
        sum += static_cast<double>(mesh.color(t[k]).g);
      }
    }
    return sum / static_cast<double>(mesh.triangles.size());
  };
  EXPECT_NEAR(light(loadScene(path)), light(loadScene("builtin:teapot")), 3.0 / 65535);
}

TEST(PackedSource, AnotherFitOrShadingIsRefused) {
  const TemporaryFolder folder;
  const std::string path = (folder / "scene.opack").string();
  packSource("builtin:teapot", {}, path);
  EXPECT_THROW(loadScene(path, {.fit = false}), InputError);
  EXPECT_THROW(loadScene(path, {.shading = Shading::kNone}), InputError);
  packSource("builtin:teapot", {.fit = false, .shading = Shading::kNone}, path);
  EXPECT_EQ(loadScene(path, {.fit = false, .shading = Shading::kNone}).triangles.size(),
            loadScene("builtin:teapot").triangles.size());
}

TEST(PackedSource, APackedSceneIsNotPackedAgain) {
  const TemporaryFolder folder;
  const std::string path = (folder / "scene.opack").string();
  packSource("builtin:box", {}, path);
  EXPECT_THROW(packSource(path, {}, folder / "again.opack"), InputError);
}

TEST(PackedSource, WhatIsTooLargeAsOneMeshSaysWhatToDo) {
  try {
    loadScene("builtin:crowd,copies=10000,triangles=60000000");
    FAIL() << "60 million triangles are too many";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("ocelli scene pack"), std::string::npos);
  }
}

}  // namespace
}  // namespace ocelli
