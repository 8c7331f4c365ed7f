// What ranks draw together is, byte for byte, what one draws alone: of every camera, for any number of ranks.
#include "oc_core/compositing/shared_renderer.h"

#include <gtest/gtest.h>

#include "oc_core/ocri/camera_choice.h"
#include "oc_core/ocri/representation_kind.h"
#include "oc_core/render/rasterize_curved.h"
#include "oc_core/render/rasterize_graph.h"
#include "oc_core/worlds/scene_source.h"
#include "tests/camera/test_curved_cameras.h"
#include "tests/ranks/thread_ranks.h"
#include "tests/render/crossing_corridors.h"

namespace ocelli::test {
namespace {

void expectSame(const ReferenceImages& got, const ReferenceImages& expected) {
  ASSERT_EQ(got.size(), expected.size());
  for (size_t i = 0; i < got.size(); ++i) {
    EXPECT_TRUE(got[i].color == expected[i].color);
    EXPECT_TRUE(got[i].t == expected[i].t);
    EXPECT_TRUE(got[i].held == expected[i].held);
    EXPECT_TRUE(got[i].displacement == expected[i].displacement);
    EXPECT_EQ(got[i].triangleBound, expected[i].triangleBound);
  }
}

class SharedCamera : public testing::TestWithParam<const char*> {};

TEST_P(SharedCamera, isTheSameForAnyNumberOfRanks) {
  const Mesh mesh = loadScene("builtin:statues,triangles=3000", {});
  const PinholeCamera reference(View{}, 120, 80);
  const CameraChoice choice = cameraChoice(GetParam());
  const ReferenceImages alone = buildReferenceImages(choice, reference, mesh);
  for (const int size : {1, 2, 3, 8}) {
    for (const Compositing how : {Compositing::kDirectSend, Compositing::kBinarySwap}) {
      runInRanks(size, [&](Ranks& ranks) {
        const SharedRenderer renderer(mesh, ranks, how);
        expectSame(buildReferenceImages(choice, reference, mesh, {}, renderer), alone);
        EXPECT_GT(renderer.cost().images, 0);
      });
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Cameras, SharedCamera,
                         testing::Values("di", "di-wide", "corners-4", "rppc", "spoc", "ddoc", "ddoc-constant", "eoc-h",
                                         "eoc-v", "eoc-hv", "cell"));

template <class C>
void expectDrawnAlike(const C& camera, const Mesh& mesh) {
  const FragmentImage alone = rasterize(camera, mesh);
  for (const int size : {2, 3, 8}) {
    for (const Compositing how : {Compositing::kDirectSend, Compositing::kBinarySwap}) {
      runInRanks(size, [&](Ranks& ranks) {
        const SharedRenderer renderer(mesh, ranks, how);
        EXPECT_TRUE(renderer.draw(camera) == alone);
      });
    }
  }
}

TEST(SharedRays, OfSeveralPiecesMeetWhatIsFirstAlongThem) {
  expectDrawnAlike(aroundCorners(90), crossingCorridors());
  expectDrawnAlike(bendingTwice(), loadScene("builtin:statues,triangles=3000", {}));
}

TEST(TrianglesOf, ArePartsWithTheirVertices) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  mesh.triangles = {{0, 1, 2}, {3, 2, 1}};
  const Mesh part = trianglesOf(mesh, 1, 2);
  ASSERT_EQ(part.triangles.size(), 1u);
  EXPECT_EQ(part.positions.size(), 3u);
  EXPECT_EQ(part.positions[part.triangles[0].x], mesh.positions[3]);
  EXPECT_EQ(part.positions[part.triangles[0].z], mesh.positions[1]);
  EXPECT_TRUE(trianglesOf(mesh, 1, 1).empty());
}

}  // namespace
}  // namespace ocelli::test
