#include "display_sim/slicing/slice_mesh.h"

#include <gtest/gtest.h>

#include <array>
#include <map>

#include "tests/display_sim_slicing/test_meshes.h"

namespace ocelli {
namespace {

using Corner = std::array<float, 3>;

Corner cornerOf(const glm::vec3& p) {
  return {p.x, p.y, p.z};
}

std::map<std::array<Corner, 3>, int> trianglesOf(const Mesh& mesh) {
  std::map<std::array<Corner, 3>, int> triangles;
  for (const glm::uvec3& t : mesh.triangles) {
    ++triangles[{cornerOf(mesh.positions[t.x]), cornerOf(mesh.positions[t.y]), cornerOf(mesh.positions[t.z])}];
  }
  return triangles;
}

std::map<std::array<Corner, 3>, int> trianglesOf(const SliceMesh& mesh) {
  std::map<std::array<Corner, 3>, int> triangles;
  for (const SliceChunk& chunk : mesh.chunks()) {
    for (size_t t = chunk.firstTriangle; t < chunk.firstTriangle + size_t{chunk.triangles}; ++t) {
      std::array<Corner, 3> corners;
      for (size_t k = 0; k < 3; ++k) {
        const size_t vertex = mesh.corners()[3 * t + k];
        EXPECT_LT(vertex, chunk.vertices);
        corners[k] = cornerOf(mesh.position(chunk.firstVertex + vertex));
      }
      ++triangles[corners];
    }
  }
  return triangles;
}

TEST(SliceMesh, holdsTheTrianglesOfTheMesh) {
  const Mesh mesh = test::torus(0.6, 0.3, 150, 90);
  for (const Mesh& ordered : {mesh, orderedForSlicing(mesh)}) {
    const SliceMesh prepared(ordered);
    EXPECT_EQ(prepared.triangleCount(), mesh.triangles.size());
    EXPECT_EQ(prepared.chunks().size(),
              (mesh.triangles.size() + SliceMesh::kChunkTriangles - 1) / SliceMesh::kChunkTriangles);
    EXPECT_EQ(trianglesOf(prepared), trianglesOf(mesh));
  }
}

// As if it had been made of the mesh with those colours, whatever it had before.
TEST(SliceMesh, takesNewColors) {
  Mesh mesh = test::torus(0.6, 0.3, 150, 90);
  SliceMesh prepared(mesh);
  ASSERT_TRUE(prepared.white());
  prepared.setColors(mesh.colors);
  EXPECT_TRUE(prepared.white());
  const auto versions = [&] {
    std::vector<uint32_t> all;
    for (const SliceChunk& chunk : prepared.chunks()) {
      all.push_back(chunk.version);
    }
    return all;
  };
  const std::vector<uint32_t> before = versions();
  for (const float scale : {0.5f, 1.0f}) {
    mesh.colors.clear();
    for (const glm::vec3& p : mesh.positions) {
      mesh.colors.push_back(scale * glm::abs(p));
    }
    prepared.setColors(mesh.colors);
    const SliceMesh expected(mesh);
    for (size_t v = 0; v < prepared.chunks().back().firstVertex; ++v) {
      ASSERT_EQ(prepared.color(v), expected.color(v));
    }
  }
  EXPECT_NE(versions(), before);
  const std::vector<uint32_t> colored = versions();
  prepared.setColors(mesh.colors);
  EXPECT_EQ(versions(), colored);
  prepared.setColors({});
  EXPECT_EQ(prepared.color(7), glm::vec3(1));
}

TEST(OrderedForSlicing, keepsTrianglesAndColors) {
  Mesh mesh = test::torus(0.6, 0.3, 50, 30);
  for (const glm::vec3& p : mesh.positions) {
    mesh.colors.push_back(glm::abs(p));
  }
  mesh.positions.push_back(glm::vec3(0));  // of no triangle
  mesh.colors.push_back(glm::vec3(1));
  const Mesh ordered = orderedForSlicing(mesh);
  EXPECT_EQ(ordered.positions.size(), mesh.positions.size() - 1);
  for (size_t i = 0; i < ordered.positions.size(); ++i) {
    EXPECT_EQ(ordered.colors[i], glm::abs(ordered.positions[i]));
  }
  EXPECT_EQ(trianglesOf(ordered), trianglesOf(mesh));
  EXPECT_TRUE(orderedForSlicing(Mesh()).empty());
}

TEST(SliceMesh, onlyMovedChunksAreNew) {
  Mesh mesh = test::torus(0.6, 0.3, 150, 90);
  SliceMesh prepared(mesh);
  const std::vector<SliceChunk> before(prepared.chunks().begin(), prepared.chunks().end());
  mesh.positions[mesh.triangles.back().x].x += 0.1f;
  prepared.setPositions(mesh.positions);
  size_t moved = 0;
  for (size_t i = 0; i < before.size(); ++i) {
    moved += prepared.chunks()[i].version != before[i].version ? 1 : 0;
  }
  EXPECT_GE(moved, 1u);
  EXPECT_LE(moved, 2u);  // the ring closes: the last quads share vertices with the first
  EXPECT_EQ(trianglesOf(prepared), trianglesOf(mesh));
}

TEST(SliceMesh, whatHasLightIsNeverBlack) {
  Mesh mesh = test::torus(0.6, 0.3, 10, 10);
  mesh.colors.assign(mesh.positions.size(), glm::vec3(1e-9f, 0, 1));
  const SliceMesh prepared(mesh);
  ASSERT_FALSE(prepared.white());
  EXPECT_EQ(prepared.red()[0], 1);
  EXPECT_EQ(prepared.green()[0], 0);
  EXPECT_EQ(prepared.blue()[0], kLightSteps);
  mesh.colors.assign(mesh.positions.size(), glm::vec3(1));
  EXPECT_TRUE(SliceMesh(mesh).white());
}

}  // namespace
}  // namespace ocelli
