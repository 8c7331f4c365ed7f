#include "oc_core/render/triangle_part.h"

#include <gtest/gtest.h>

#include <functional>

#include "tests/ocri/test_scenes.h"

namespace ocelli {
namespace {

using test::smallCamera;

TrianglePart selected(const Mesh& mesh, const std::function<bool(const ImageBox&)>& isWanted) {
  return selectTriangles(std::make_shared<const ProjectedMesh>(smallCamera(), mesh), isWanted);
}

std::vector<uint32_t> trianglesOf(const TrianglePart& part) {
  std::vector<uint32_t> triangles;
  for (const TrianglePart::Block& block : part.blocks) {
    block.forEach([&](uint32_t triangle, bool) { triangles.push_back(triangle); });
  }
  EXPECT_EQ(part.size(), triangles.size());
  return triangles;
}

TEST(SelectTriangles, keepsThoseWithAWantedBox) {
  const Mesh mesh = test::randomTriangles(300, 4);
  const PinholeCamera camera = smallCamera();
  const TrianglePart part = selected(mesh, [](const ImageBox& box) { return box.lower.x < 40; });
  std::vector<uint32_t> expected;
  for (uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    float least = 1e30f;
    for (int corner = 0; corner < 3; ++corner) {
      least = std::min(least, camera.project(mesh.positions[mesh.triangles[i][corner]])->u);
    }
    if (least < 40) {
      expected.push_back(i);
    }
  }
  EXPECT_EQ(trianglesOf(part), expected);
  EXPECT_LT(expected.size(), mesh.triangles.size());
}

TEST(SelectTriangles, keepsTrianglesThatAreNotWhollyBeforeTheEye) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 0, 20}};
  mesh.triangles = {{0, 1, 2}, {0, 1, 0}};
  const TrianglePart part = selected(mesh, [](const ImageBox&) { return false; });
  EXPECT_EQ(trianglesOf(part), std::vector<uint32_t>{0});
}

TEST(SelectTriangles, nothingOfNothing) {
  EXPECT_TRUE(selected({}, [](const ImageBox&) { return true; }).blocks.empty());
}

}  // namespace
}  // namespace ocelli
