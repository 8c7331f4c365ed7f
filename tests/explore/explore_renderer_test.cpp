#include "oc_core/explore/explore_renderer.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "oc_core/constructor/occluder_constructor.h"
#include "oc_core/constructor/path_constructor.h"
#include "oc_core/explore/explore_jumps.h"
#include "oc_core/explore/explorer.h"
#include "oc_core/multiperspective/multiperspective_image.h"
#include "tests/explore/explore_scenes.h"

namespace ocelli {
namespace {

TEST(ExploreRenderer, drawsWhatRenderDraws) {
  GuidedScene made = test::twoRooms();
  for (size_t i = 0; i < made.mesh.colors.size(); ++i) {  // colours that change across triangles, too
    made.mesh.colors[i] *= i % 3 == 0 ? 1.0f : 0.5f;
  }
  ExploreScene scene(std::move(made));
  Explorer explorer(scene, test::smallPictures());
  explorer.jumpTo({{5, 1.6, 0.5}, -55, 0});
  explorer.choose("portal");
  for (int i = 0; i < 60; ++i) {
    explorer.advance({}, 1 / 30.0);
  }
  ASSERT_GT(std::get<GraphCamera>(explorer.frame().camera).frusta().size(), 1u);
  ExploreRenderer renderer(scene);
  const ExplorePicture picture = renderer.draw(explorer.frame(), true);
  const auto expected = [&](const MultiperspectiveCamera& camera) {
    return srgbFromLinear(colorImage(rasterize(camera, scene.mesh()), scene.mesh(), skyColor()));
  };
  const auto farthestByte = [](const Image<Rgb8>& one, const Image<Rgb8>& other) {
    int farthest = 0;
    for (size_t i = 0; i < one.size(); ++i) {
      for (int k = 0; k < 3; ++k) {
        farthest = std::max(farthest, std::abs(int{one[i][k]} - int{other[i][k]}));
      }
    }
    return farthest;
  };
  // A byte more or less: colours are looked up in a table (explore_renderer.cpp).
  EXPECT_LE(farthestByte(picture.image, expected(explorer.frame().camera)), 1);
  ASSERT_TRUE(picture.pinhole);
  EXPECT_LE(farthestByte(*picture.pinhole, expected(GraphCamera(explorer.frame().pinhole))), 1);
  EXPECT_EQ(picture.frame, explorer.frame().number);
}

// What the explorer relies on: constructors that are not deployed make the pinhole, and a little of it hardly more.
TEST(ExploreRenderer, collapsedCamerasShowThePinhole) {
  const ExploreScene scene(test::hiddenBox());
  const ExploreRenderer renderer(scene);
  const PinholeCamera view = walkerCamera({{0.5, 1.6, 3}, 0, 0}, scene, 70, 160, 90);
  const Image<Rgb8> straight = renderer.draw(GraphCamera(view));
  const auto change = [&](const MultiperspectiveCamera& camera) {
    return imageChange(renderer.draw(camera), straight);
  };
  OccluderOptions around;
  around.object = 1;
  const auto occluder = [&](double deployed) {
    around.deployed = deployed;
    return change(buildOccluderCamera(around, scene.scene(), view));
  };
  EXPECT_LT(occluder(0), 0.05) << "bytes, but for rounding at edges";
  EXPECT_LT(occluder(0.02), 0.2 * occluder(1));
  EXPECT_GT(occluder(1), 1);
  PathOptions path;
  path.path = {{0.5f, 1.6f, 3}, {0.5f, 1.6f, -2}, {6, 1.6f, -2}};
  path.preview = 0.9;
  const auto onPath = [&](double deployed) {
    path.deployed = deployed;
    return change(buildPathCamera(path, scene.guides(), view));
  };
  path.deployed = 0;
  const CurvedRayCamera collapsed = buildPathCamera(path, scene.guides(), view);
  EXPECT_TRUE(collapsed.bends().empty());
  EXPECT_GT(onPath(1), onPath(0));
}

TEST(ExploreRenderer, dissolvesFromThePictureBefore) {
  ExploreScene scene(test::twoRooms());
  Explorer explorer(scene, test::smallPictures());
  ExploreRenderer renderer(scene);
  const Image<Rgb8> before = renderer.draw(explorer.frame()).image;
  ExploreFrame frame = explorer.frame();
  frame.number = 1;
  frame.walker.headingDegrees += 90;
  frame.camera = GraphCamera(walkerCamera(frame.walker, scene, 70, 160, 90));
  const Image<Rgb8> after = renderer.draw(frame.camera);
  frame.dissolve = 0.75;
  frame.dissolveFrom = 0;
  const Image<Rgb8> mixed = renderer.draw(frame).image;
  for (size_t i = 0; i < mixed.size(); i += 97) {
    EXPECT_NEAR(mixed[i].x, 0.75 * before[i].x + 0.25 * after[i].x, 1.01);
  }
}

TEST(ExploreRenderer, drawsACameraThatStandsStillOnce) {
  ExploreScene scene(test::twoRooms());
  Explorer explorer(scene, test::smallPictures());
  ExploreRenderer renderer(scene);
  const auto show = [&](const WalkerView& view) {
    explorer.showDrawn(GraphCamera(walkerCamera(view, scene, 70, 160, 90)), "a file");
  };
  const auto walk = [&](int frames) {
    WalkInput forward;
    forward.forward = 1;
    Image<Rgb8> picture;
    for (int i = 0; i < frames; ++i) {
      explorer.advance(forward, test::kExploreFrame);
      picture = renderer.draw(explorer.frame()).image;
    }
    EXPECT_EQ(explorer.frame().dissolve, 0);
    EXPECT_EQ(picture, ExploreRenderer(scene).draw(explorer.frame()).image);
  };
  show({{5, 1.6, 0.5}, -55, 0});
  walk(60);
  const int drawn = renderer.drawnCameras();
  walk(20);
  EXPECT_EQ(renderer.drawnCameras(), drawn) << "the walker's steps change nothing";
  show({{5, 1.6, 0.5}, 90, 0});
  walk(20);
  EXPECT_EQ(renderer.drawnCameras(), drawn + 1) << "another camera is another image";
  explorer.resize(200, 100);
  walk(1);
}

TEST(ExploreDrawing, drawsTheNewestFrame) {
  ExploreScene scene(test::twoRooms());
  Explorer explorer(scene, test::smallPictures());
  ExploreDrawing drawing(scene);
  EXPECT_FALSE(drawing.take());
  for (int i = 0; i < 5; ++i) {
    explorer.advance({}, 1 / 30.0);
    drawing.want(explorer.frame());
  }
  drawing.waitUntilIdle();
  const std::optional<ExplorePicture> picture = drawing.take();
  ASSERT_TRUE(picture);
  EXPECT_EQ(picture->frame, explorer.frame().number);
  EXPECT_EQ(picture->image, ExploreRenderer(scene).draw(explorer.frame()).image);
  EXPECT_FALSE(drawing.take());
}

}  // namespace
}  // namespace ocelli
