#include "oc_core/render/triangle_part.h"

#include <gtest/gtest.h>

#include "tests/ocri/test_scenes.h"

namespace ocelli {
namespace {

using test::smallCamera;

/// Every triangle of a part is the mesh's, point by point, in its order.
void expectTrianglesOf(const TrianglePart& part, const Mesh& mesh) {
  const PinholeCamera camera = smallCamera();
  ASSERT_EQ(part.triangles.size(), part.meshTriangles.size());
  EXPECT_TRUE(std::is_sorted(part.meshTriangles.begin(), part.meshTriangles.end()));
  for (size_t i = 0; i < part.triangles.size(); ++i) {
    for (int corner = 0; corner < 3; ++corner) {
      EXPECT_EQ(part.points[part.triangles[i][corner]],
                camera.cameraFromWorld(mesh.positions[mesh.triangles[part.meshTriangles[i]][corner]]));
    }
  }
}

TEST(SelectTriangles, keepsThoseWithAWantedBox) {
  const Mesh mesh = test::randomTriangles(300, 4);
  const PinholeCamera camera = smallCamera();
  const auto wanted = [](const ImageBox& box) { return box.lower.x < 40; };
  const TrianglePart part = selectTriangles(mesh, camera, wanted);
  expectTrianglesOf(part, mesh);
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
  EXPECT_EQ(part.meshTriangles, expected);
  EXPECT_LT(expected.size(), mesh.triangles.size());
  EXPECT_LT(part.points.size(), mesh.positions.size()) << "vertices that no triangle names are dropped";
}

TEST(SelectTriangles, keepsTrianglesThatAreNotWhollyBeforeTheEye) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 0, 20}};
  mesh.triangles = {{0, 1, 2}, {0, 1, 0}};
  const TrianglePart part = selectTriangles(mesh, smallCamera(), [](const ImageBox&) { return false; });
  EXPECT_EQ(part.meshTriangles, std::vector<uint32_t>{0});
  EXPECT_EQ(part.points.size(), 3u);
}

TEST(SelectTriangles, nothingOfNothing) {
  const TrianglePart part = selectTriangles({}, smallCamera(), [](const ImageBox&) { return true; });
  EXPECT_TRUE(part.points.empty());
  EXPECT_TRUE(part.triangles.empty());
}

}  // namespace
}  // namespace ocelli
