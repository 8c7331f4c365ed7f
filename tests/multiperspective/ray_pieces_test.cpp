#include "oc_core/multiperspective/ray_pieces.h"

#include <gmock/gmock.h>

#include "tests/camera/test_curved_cameras.h"
#include "tests/camera/test_graph_cameras.h"

namespace ocelli {
namespace {

using testing::ElementsAre;

std::vector<int> partsOf(const std::vector<RayPiece>& pieces) {
  std::vector<int> parts;
  for (const RayPiece& piece : pieces) {
    parts.push_back(piece.part);
  }
  return parts;
}

/// Each piece goes on where the one before ends.
void expectConnected(const std::vector<RayPiece>& pieces) {
  for (size_t i = 0; i < pieces.size(); ++i) {
    EXPECT_GE(pieces[i].points.size(), 2u);
    if (i > 0) {
      EXPECT_EQ(pieces[i].points.front(), pieces[i - 1].points.back());
    }
  }
}

TEST(RayPieces, frustaOfAGraphCamera) {
  const GraphCamera camera = test::crossroads();
  EXPECT_THAT(partNames(camera), ElementsAre("root", "left", "right", "far left"));
  const auto left = rayPieces(camera, {10, 30});
  const auto right = rayPieces(camera, {80, 30});
  EXPECT_THAT(partsOf(left), ElementsAre(0, 1, 3));
  EXPECT_THAT(partsOf(right), ElementsAre(0, 2));
  expectConnected(left);
  EXPECT_EQ(partViewpoints(camera)[2], glm::vec3(-1.5, 0, 7));
  // Every point lies in the frustum that the piece is of: half way, as the ends lie on planes.
  for (const RayPiece& piece : left) {
    EXPECT_EQ(camera.frustumOf(glm::dvec3(piece.points[0] + piece.points[1]) * 0.5), piece.part);
  }
}

TEST(RayPieces, stretchesOfACurvedRayCamera) {
  const CurvedRayCamera camera = test::bendingTwice();
  EXPECT_THAT(partNames(camera), ElementsAre("root", "turn 1", "after turn 1", "turn 2", "after turn 2"));
  EXPECT_EQ(partViewpoints(camera).size(), 5u);
  const auto pieces = rayPieces(camera, {45, 30});
  EXPECT_THAT(partsOf(pieces), ElementsAre(0, 1, 2, 3, 4));
  expectConnected(pieces);
  EXPECT_EQ(pieces[0].points.size(), 2u) << "straight";
  EXPECT_GT(pieces[1].points.size(), 4u) << "an arc";
  const TransitionPlanes& planes = camera.bends()[0].planes();
  EXPECT_NEAR(planes.from.height(glm::dvec3(pieces[1].points.front())), 0, 1e-5);
  EXPECT_NEAR(planes.to.height(glm::dvec3(pieces[1].points.back())), 0, 1e-5);
}

TEST(RayPieces, ofAPinholeThereIsOne) {
  EXPECT_THAT(partsOf(rayPieces(GraphCamera(test::smallCamera()), {3, 4})), ElementsAre(0));
  EXPECT_THAT(partsOf(rayPieces(CurvedRayCamera(test::smallCamera()), {3, 4})), ElementsAre(0));
}

TEST(RayPieces, cornersLieInTheirPart) {
  const GraphCamera camera = test::crossroads();
  const std::vector<glm::vec2> corners = cornerPixels(camera);
  EXPECT_EQ(corners.size(), 16u);
  for (size_t i = 8; i < 12; ++i) {
    EXPECT_EQ(camera.childAt(0, glm::dvec2(corners[i])), 2);
  }
  EXPECT_EQ(cornerPixels(CurvedRayCamera(test::smallCamera())).size(), 4u);
}

}  // namespace
}  // namespace ocelli
