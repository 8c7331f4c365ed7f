#include "oc_core/render/mesh_blocks.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "oc_core/worlds/scene_source.h"

namespace ocelli {
namespace {

TEST(MeshBlocks, findsEveryTriangleOfAHalfSpace) {
  const Mesh mesh = loadScene("builtin:boxes", {}, {});
  const MeshBlocks blocks(mesh);
  EXPECT_EQ(blocks.size(), (mesh.triangles.size() + MeshBlocks::kTriangles - 1) / MeshBlocks::kTriangles);
  for (const glm::dvec3 normal : {glm::dvec3(1, 0, 0), glm::dvec3(0, 0.6, -0.8)}) {
    const HalfSpaces spaces{beyond(Plane::through({0.1, 0.2, 0}, normal)), before(Plane::through({0.5, 0, 0}, normal))};
    std::set<uint32_t> found;
    std::set<uint32_t> inside;
    blocks.forEachWithin(spaces, [&](uint32_t block, Placement placement) {
      blocks.forEachTriangle(block, [&](uint32_t triangle) {
        found.insert(triangle);
        if (placement == Placement::kInside) {
          inside.insert(triangle);
        }
      });
    });
    EXPECT_LT(found.size(), mesh.triangles.size()) << "some blocks must be passed over";
    Clipper clipper;
    for (uint32_t i = 0; i < mesh.triangles.size(); ++i) {
      const glm::uvec3& t = mesh.triangles[i];
      const auto& left = clipper.clip(mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z], spaces);
      EXPECT_TRUE(left.empty() || found.contains(i)) << i;
      EXPECT_TRUE(!inside.contains(i) || left.size() == 3) << i;
    }
  }
}

// Boxes that are strewn about: neighbours in space lie in smaller blocks. Each triangle is in one.
TEST(MeshBlocks, neighboursInSpaceLieCloserTogether) {
  const Mesh mesh = loadScene("builtin:boxes,count=700,floor=1", {}, {});
  const auto sizeOf = [&](const MeshBlocks& blocks) {
    double sum = 0;
    std::set<uint32_t> seen;
    for (uint32_t block = 0; block < blocks.size(); ++block) {
      sum += static_cast<double>(glm::length(blocks[block].box.size()));
      blocks.forEachTriangle(block, [&](uint32_t triangle) { EXPECT_TRUE(seen.insert(triangle).second); });
    }
    EXPECT_EQ(seen.size(), mesh.triangles.size());
    return sum;
  };
  EXPECT_LT(sizeOf(MeshBlocks(mesh, MeshBlocks::Order::kInSpace)), 0.5 * sizeOf(MeshBlocks(mesh)));
}

TEST(MeshBlocks, followsVerticesThatMove) {
  Mesh mesh = loadScene("builtin:boxes", {}, {});
  MeshBlocks blocks(mesh);
  const size_t first = mesh.positions.size() / 3;
  const size_t count = mesh.positions.size() / 5;
  for (size_t v = first; v < first + count; ++v) {
    mesh.positions[v] += glm::vec3(3, -2, 1);
  }
  mesh.positions[first].x = std::numeric_limits<float>::quiet_NaN();
  blocks.update(mesh, first, count);
  const MeshBlocks fresh(mesh);
  ASSERT_EQ(blocks.size(), fresh.size());
  for (size_t i = 0; i < fresh.size(); ++i) {
    EXPECT_EQ(blocks[i].box.lower, fresh[i].box.lower) << i;
    EXPECT_EQ(blocks[i].box.upper, fresh[i].box.upper) << i;
    EXPECT_EQ(blocks[i].finite, fresh[i].finite) << i;
  }
  // The boxes around runs of blocks have moved as well: nothing is passed over that a fresh one finds.
  const HalfSpaces spaces{beyond(Plane::through({2, 0, 0}, {1, 0, 0}))};
  std::set<uint32_t> expected;
  std::set<uint32_t> found;
  fresh.forEachWithin(spaces, [&](uint32_t block, Placement) { expected.insert(block); });
  blocks.forEachWithin(spaces, [&](uint32_t block, Placement) { found.insert(block); });
  EXPECT_FALSE(expected.empty());
  EXPECT_EQ(found, expected);
}

TEST(MeshBlocks, leavesTrianglesOutThatAreNone) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  Mesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {nan, 5, 5}}, {}, {}};
  for (int i = 0; i < 40; ++i) {
    mesh.triangles.push_back(i % 3 == 0 ? glm::uvec3(0, 1, 3) : glm::uvec3(0, 1, 2));
  }
  const MeshBlocks blocks(mesh);
  ASSERT_EQ(blocks.size(), 2u);
  size_t seen = 0;
  for (const uint32_t block : {0u, 1u}) {
    EXPECT_EQ(blocks[block].box.upper, glm::vec3(1, 1, 0));
    blocks.forEachTriangle(block, [&](uint32_t triangle) {
      ++seen;
      EXPECT_NE(triangle % 3, 0u);
    });
  }
  EXPECT_EQ(seen, 26u);
  EXPECT_EQ(MeshBlocks(Mesh{}).size(), 0u);
}

}  // namespace
}  // namespace ocelli
