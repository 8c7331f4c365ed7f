#include "oc_core/camera/frustum_pieces.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "tests/camera/graph_holders.h"
#include "tests/camera/random_graph_cameras.h"

namespace ocelli {
namespace {

using test::Numbers;
using test::smallCamera;
using test::turnAt;
using testing::ElementsAre;
using testing::SizeIs;

bool pieceHolds(const FrustumPiece& piece, const glm::dvec3& point) {
  return std::all_of(piece.sides.begin(), piece.sides.end(),
                     [&](const Plane& side) { return side.height(point) <= 0; });
}

std::vector<int> childrenOf(const std::vector<FrustumPiece>& pieces) {
  std::vector<int> children;
  for (const FrustumPiece& piece : pieces) {
    children.push_back(piece.child);
  }
  return children;
}

// The plane of zNear and the four sides of the image: the eye is at (0, 0, 10), nothing ends it.
TEST(FrustumPieces, ofAPinholeIsItsPyramid) {
  const PinholeCamera camera = smallCamera();
  const std::vector<FrustumPiece> pieces = piecesOf(GraphCamera(camera));
  ASSERT_THAT(pieces, SizeIs(1));
  EXPECT_EQ(pieces[0].frustum, GraphCamera::kRoot);
  EXPECT_EQ(pieces[0].child, -1);
  ASSERT_THAT(pieces[0].sides, SizeIs(5));
  for (const Plane& side : pieces[0].sides) {
    EXPECT_NEAR(glm::length(side.normal), 1, 1e-12);
  }
  for (size_t i = 1; i < 5; ++i) {
    EXPECT_NEAR(pieces[0].sides[i].height({0, 0, 10}), 0, 1e-5) << "sides pass the eye";
  }
  const double right = 10 * test::kWidth / 2.0 / static_cast<double>(camera.focalPixels());
  EXPECT_TRUE(pieceHolds(pieces[0], {0.999 * right, 0, 0}));
  EXPECT_FALSE(pieceHolds(pieces[0], {1.001 * right, 0, 0}));
  EXPECT_TRUE(pieceHolds(pieces[0], {0, 0, -1e6})) << "beyond zFar";
  EXPECT_FALSE(pieceHolds(pieces[0], {0, 0, 11}));
}

TEST(FrustumPieces, eachChildEndsOne) {
  const GraphCamera graph = test::crossroads();
  const std::vector<FrustumPiece> root = piecesOf(graph, GraphCamera::kRoot);
  EXPECT_THAT(childrenOf(root), ElementsAre(1, 2)) << "a split leaves nothing";
  for (const FrustumPiece& piece : root) {
    const Plane& last = piece.sides.back();
    EXPECT_EQ(last.normal, graph.frusta()[static_cast<size_t>(piece.child)].plane.normal);
  }
  EXPECT_THAT(childrenOf(piecesOf(graph)), ElementsAre(1, 2, 3, -1, -1));
}

// What a window leaves of the image is four pieces around it, which the limits of the frustum end.
TEST(FrustumPieces, aWindowLeavesWhatIsAroundIt) {
  GraphCamera graph(smallCamera());
  graph.bend(0, turnAt({0, 0, 0}, {0, 0, -1}, {0, 0, 6}), "window", {{30, 20}, {60, 20}, {60, 40}, {30, 40}});
  const Plane limit = Plane::through({0, 0, -2}, {0, 0, -1});
  graph.limit(0, limit);
  const std::vector<FrustumPiece> root = piecesOf(graph, GraphCamera::kRoot);
  EXPECT_THAT(childrenOf(root), ElementsAre(1, -1, -1, -1, -1));
  EXPECT_TRUE(pieceHolds(root[0], {0, 0, 0.1}));
  EXPECT_FALSE(pieceHolds(root[0], {0, 0, -0.1})) << "beyond the plane of the child";
  for (size_t i = 1; i < root.size(); ++i) {
    EXPECT_EQ(root[i].sides.back().normal, limit.normal);
    EXPECT_EQ(root[i].sides.back().distance, limit.distance);
  }
  EXPECT_THAT(piecesOf(graph, 1), SizeIs(1)) << "the limit is not one of the window";
}

TEST(FrustumPiecesDeathTest, thereMustBeSuchAFrustum) {
  const GraphCamera graph(smallCamera());
  EXPECT_DEATH(piecesOf(graph, 1), "there is no such frustum");
  EXPECT_DEATH(piecesOf(graph, -1), "there is no such frustum");
}

TEST(FrustumPieces, holdWhatTheFrustumHolds) {
  Numbers numbers;
  size_t held = 0;
  for (int k = 0; k < 30; ++k) {
    GraphCamera graph = test::randomGraph(numbers, 6);
    graph.limit(0, Plane::through({0, 0, -3}, {0.1, 0, -1}));
    std::vector<std::vector<FrustumPiece>> pieces;
    for (size_t i = 0; i < graph.frusta().size(); ++i) {
      pieces.push_back(piecesOf(graph, static_cast<int>(i)));
    }
    for (int n = 0; n < 4000; ++n) {
      const glm::dvec3 point = test::randomPoint(numbers);
      for (size_t i = 0; i < graph.frusta().size(); ++i) {
        const auto holders = std::count_if(pieces[i].begin(), pieces[i].end(),
                                           [&](const FrustumPiece& piece) { return pieceHolds(piece, point); });
        ASSERT_EQ(holders, test::holds(graph, static_cast<int>(i), point) ? 1 : 0)
            << "camera " << k << ", frustum " << i;
        held += holders > 0;
      }
    }
  }
  EXPECT_GT(held, 10000u);
}

}  // namespace
}  // namespace ocelli
