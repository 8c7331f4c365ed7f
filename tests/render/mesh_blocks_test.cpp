#include "oc_core/render/mesh_blocks.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "oc_core/scene/scene_source.h"

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
