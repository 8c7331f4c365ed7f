#include "oc_core/relief/relief_errors.h"

#include <gtest/gtest.h>

#include "tests/relief/small_reliefs.h"

namespace ocelli {
namespace {

/// A picture of five pixels in a row, of a wall at z = 10 in the first three; the footprint is that of the camera.
struct FivePixels {
  FivePixels() : camera(View{}, 5, 1), wall(makeBox({100, 100, 0.001f})), tiles(wall) {
    const ReliefRenderer nothing(std::make_shared<const ReliefScene>(ReliefScene::Objects{}, std::vector<ReliefTile>{}),
                                 nullptr);
    truth = nothing.draw(camera);
    for (int x = 0; x < 3; ++x) {
      set(truth, x, 10);
    }
  }
  void set(ReliefPicture& picture, int x, float z) const {
    picture.shown(x, 0) = z > 0 ? 0 : ReliefPicture::kNothing;
    picture.z(x, 0) = z;
    picture.point(x, 0) = *camera.unproject({static_cast<float>(x) + 0.5f, 0.5f, std::max(z, 0.1f)});
  }
  float near() const { return 1.5f * 10 / camera.focalPixels(); }

  PinholeCamera camera;
  Mesh wall;
  RayScene tiles;
  ReliefPicture truth;
};

TEST(ReliefErrors, tellStatesApart) {
  const FivePixels five;
  ReliefPicture picture = five.truth;
  const auto stateAt = [&](int x) { return reliefStates(five.truth, picture, five.tiles, five.camera)(x, 0); };
  EXPECT_EQ(stateAt(0), ReliefState::kRight);
  EXPECT_EQ(stateAt(4), ReliefState::kElsewhere);
  five.set(picture, 0, 10 + 0.99f * five.near());
  EXPECT_EQ(stateAt(0), ReliefState::kRight);
  // The wall has no surface there.
  five.set(picture, 0, 10 - 1.5f * five.near());
  EXPECT_EQ(stateAt(0), ReliefState::kFalse);
  five.set(picture, 1, 0);
  EXPECT_EQ(stateAt(1), ReliefState::kMissing);
  // A tile where there is none, on the wall that goes on there behind whatever else the truth shows.
  five.set(picture, 3, 10);
  EXPECT_EQ(stateAt(3), ReliefState::kOther);
  five.set(picture, 4, 5);
  EXPECT_EQ(stateAt(4), ReliefState::kFalse);
}

TEST(ReliefErrors, figuresAreSums) {
  const FivePixels five;
  ReliefPicture picture = five.truth;
  five.set(picture, 0, 10 - 1.5f * five.near());
  five.set(picture, 1, 0);
  five.set(picture, 3, 10);
  picture.inShadow(2, 0) = 1;
  const auto states = reliefStates(five.truth, picture, five.tiles, five.camera);
  ReliefFigures figures = reliefFigures(five.truth, picture, states);
  EXPECT_EQ(figures.tilePixels, 3u);
  EXPECT_EQ(figures.wrong, 3u);
  EXPECT_EQ(figures.missing, 1u);
  EXPECT_EQ(figures.falseSurface, 1u);
  EXPECT_EQ(figures.other, 1u);
  EXPECT_DOUBLE_EQ(figures.wrongShare(), 1);
  EXPECT_EQ(figures.sunPixels, 1u);
  EXPECT_EQ(figures.shadowWrong, 1u);
  EXPECT_TRUE(std::isinf(figures.psnrDecibels()));
  picture.color(1, 0) = glm::vec3(1) - five.truth.color(1, 0);
  figures += reliefFigures(five.truth, picture, states);
  EXPECT_EQ(figures.wrong, 6u);
  EXPECT_LT(figures.psnrDecibels(), 30);
}

// Traced pictures are without errors against themselves, and show what stands around as no tile.
TEST(ReliefErrors, theTracedPictureIsRight) {
  const Mesh tiles = test::redBox();
  Mesh all = tiles;
  append(all, makeBox({2, 0.01f, 2}), placedAt({0, -0.26f, 0}));
  const PlainGeometry geometry(all);
  const RayScene own(tiles);
  const TracedTiles traced{geometry, tiles.triangles.size(), own};
  const PinholeCamera camera(test::viewFrom(30), 80, 60);
  const ReliefPicture truth = traceTiles(traced, camera);
  size_t shown = 0;
  size_t around = 0;
  for (size_t i = 0; i < truth.shown.size(); ++i) {
    shown += truth.shown[i] == 0;
    around += truth.shown[i] == ReliefPicture::kGeometry;
    EXPECT_TRUE(truth.shown[i] != 0 || truth.point[i].y > -0.2501f);
  }
  EXPECT_GT(shown, 300u);
  EXPECT_GT(around, 300u);
  const ReliefFigures figures = reliefFigures(truth, truth, reliefStates(truth, truth, own, camera));
  EXPECT_EQ(figures.wrong, 0u);
  EXPECT_EQ(figures.tilePixels, shown);
}

// What the whole is about, on a table: the height field's walls under the plate, and an occlusion camera without them.
TEST(ReliefErrors, anOcclusionCameraHasFewerThanAHeightField) {
  const Mesh mesh = test::table();
  const PlainGeometry geometry(mesh);
  const TracedTiles traced{geometry, mesh.triangles.size(), geometry.rays()};
  const auto figuresBy = [&](const char* way) {
    const ReliefRenderer renderer(test::oneTile(buildReliefObject(way, mesh, 128 * 128).object), nullptr);
    ReliefFigures sum;
    for (int i = 0; i < 6; ++i) {
      const PinholeCamera camera(test::viewFrom(10 + 10 * i, 61 * i), 160, 120);
      const ReliefPicture truth = traceTiles(traced, camera);
      const ReliefPicture picture = renderer.draw(camera);
      sum += reliefFigures(truth, picture, reliefStates(truth, picture, geometry.rays(), camera));
    }
    return sum;
  };
  const ReliefFigures field = figuresBy("height-field");
  const ReliefFigures cell = figuresBy("cell");
  // Half of what is seen of the table is wall of the height field; of the other, outlines are off.
  EXPECT_GT(field.falseSurface, field.tilePixels / 4);
  EXPECT_LT(cell.wrong, field.wrong / 10);
  EXPECT_LT(cell.falseSurface, cell.tilePixels / 100);
}

}  // namespace
}  // namespace ocelli
