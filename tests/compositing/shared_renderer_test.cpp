// What ranks draw together is, byte for byte, what one draws alone: of every camera, for any number of ranks.
#include "oc_core/compositing/shared_renderer.h"

#include <gtest/gtest.h>

#include "oc_core/base/random.h"
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

/// The corners of each triangle.
std::vector<glm::vec3> cornersOf(const Mesh& mesh, size_t begin, size_t end) {
  std::vector<glm::vec3> corners;
  for (size_t i = begin; i < end; ++i) {
    for (int k = 0; k < 3; ++k) {
      corners.push_back(mesh.positions[mesh.triangles[i][k]]);
    }
  }
  return corners;
}

TEST(TrianglesOf, ArePartsWithTheirVertices) {
  const Mesh inOrder = loadScene("builtin:statues,triangles=3000", {});
  Mesh shuffled = inOrder;
  Random(7).shuffle(shuffled.triangles);
  for (const Mesh& mesh : {inOrder, shuffled}) {
    for (const size_t end : {size_t{1}, size_t{100}, mesh.triangles.size()}) {
      const Mesh part = trianglesOf(mesh, end / 2, end);
      EXPECT_EQ(cornersOf(part, 0, part.triangles.size()), cornersOf(mesh, end / 2, end));
      EXPECT_LE(part.positions.size(), 3 * part.triangles.size());
    }
  }
  EXPECT_TRUE(trianglesOf(inOrder, 1, 1).positions.empty());
}

}  // namespace
}  // namespace ocelli::test
