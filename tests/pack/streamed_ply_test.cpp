#include "oc_core/worlds/streamed_ply.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <string>

#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/pack/pack_scene.h"
#include "oc_core/scene/ply_file.h"
#include "oc_core/scene/shading.h"
#include "oc_core/worlds/packed_source.h"
#include "tests/base/temporary_folder.h"

namespace ocelli {
namespace {

using test::TemporaryFolder;

/// A wavy sheet without creases, with colours or without.
Mesh sheet(bool colored) {
  constexpr uint32_t kSide = 60;
  Mesh mesh;
  for (uint32_t y = 0; y < kSide; ++y) {
    for (uint32_t x = 0; x < kSide; ++x) {
      const auto u = static_cast<float>(x);
      const auto v = static_cast<float>(y);
      mesh.positions.push_back({3 + u, 5 * std::sin(0.1f * u) * std::cos(0.13f * v), v});
      if (colored) {
        mesh.colors.push_back({u / kSide, v / kSide, 0.5f});
      }
      if (x > 0 && y > 0) {
        const uint32_t i = y * kSide + x;
        mesh.triangles.push_back({i, i - 1, i - kSide - 1});
        mesh.triangles.push_back({i, i - kSide - 1, i - kSide});
      }
    }
  }
  // A vertex that no triangle uses, far away: it must not count for the fit.
  mesh.positions.push_back({1000, 1000, 1000});
  if (colored) {
    mesh.colors.push_back({1, 1, 1});
  }
  return mesh;
}

class StreamedPlyTest : public testing::Test {
 protected:
  /// The bytes of the packed scene by the streamed triangles.
  std::string streamed(const std::filesystem::path& ply, const SceneOptions& options) {
    const std::filesystem::path path = folder / "streamed.opack";
    packScene(StreamedPly(ply, options, folder.path()), path, {.description = "{}", .sourceKey = {}});
    return readFile(path);
  }
  /// By the mesh that loadScene() gives.
  std::string loaded(const std::filesystem::path& ply, const SceneOptions& options) {
    const std::filesystem::path path = folder / "loaded.opack";
    const Mesh mesh = loadScene(ply.string(), options);
    packScene(MeshSource(mesh), path, {.description = "{}", .sourceKey = {}});
    return readFile(path);
  }
  const TemporaryFolder folder;
};

TEST_F(StreamedPlyTest, PacksTheSameBytesAsTheLoadedMesh) {
  for (const bool colored : {false, true}) {
    const std::filesystem::path ply = folder / "sheet.ply";
    writePly(ply, sheet(colored));
    for (const bool fit : {false, true}) {
      for (const Shading shading : {Shading::kNone, Shading::kLambert}) {
        const SceneOptions options{.fit = fit, .shading = shading};
        EXPECT_TRUE(streamed(ply, options) == loaded(ply, options)) << colored << fit << static_cast<int>(shading);
      }
    }
  }
}

TEST_F(StreamedPlyTest, ACornerAtACreaseTakesTheShadeOfItsFace) {
  // Two squares like a book that is nearly shut, with shared vertices along its back: 163 degrees between normals.
  writeFile(folder / "corner.ply",
            "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\nproperty float z\n"
            "element face 2\nproperty list uchar int vertex_indices\nend_header\n"
            "0 0 0\n1 0 0\n1 0 -1\n0 0 -1\n0 -0.3 -1\n1 -0.3 -1\n4 0 1 2 3\n4 4 5 1 0\n");
  const StreamedPly corner(folder / "corner.ply", {.fit = false}, folder.path());
  size_t triangles = 0;
  corner.forEachPart([&](const Mesh& part) {
    for (const glm::uvec3& t : part.triangles) {
      const glm::vec3 normal = glm::normalize(
          glm::cross(part.positions[t.y] - part.positions[t.x], part.positions[t.z] - part.positions[t.x]));
      for (const uint32_t v : {t.x, t.y, t.z}) {
        // Both sides are flat, so all of each has one shade.
        EXPECT_FLOAT_EQ(part.colors[v].r, lambertShade(normal)) << triangles;
      }
      ++triangles;
    }
  });
  EXPECT_EQ(triangles, 4u);
}

TEST_F(StreamedPlyTest, WhatIsWrongWithTheFileIsTold) {
  EXPECT_THROW(StreamedPly(folder / "missing.ply", {}, folder.path()), InputError);
  writePly(folder / "sheet.ply", sheet(false));
  std::string bytes = readFile(folder / "sheet.ply");
  writeFile(folder / "short.ply", bytes.substr(0, bytes.size() - 100));
  EXPECT_THROW(StreamedPly(folder / "short.ply", {}, folder.path()), InputError);
  Mesh broken = sheet(false);
  broken.positions[17].y = std::numeric_limits<float>::quiet_NaN();
  writePly(folder / "nan.ply", broken);
  try {
    const StreamedPly none(folder / "nan.ply", {}, folder.path());
    FAIL() << "a coordinate is no number";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("vertex 17"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace ocelli
