#include "oc_core/ocri/view_holes.h"

#include <gtest/gtest.h>

#include "oc_core/ocri/camera_choice.h"
#include "tests/ocri/test_scenes.h"

namespace ocelli {
namespace {

constexpr int kHoledWidth = 360;
constexpr int kHoledHeight = 240;

// Behind the box is the wall.
TEST(ViewHoles, areFilledFromBehind) {
  Mesh mesh = test::boxBeforeWall();
  mesh.colors.assign(mesh.positions.size(), glm::vec3(0));
  for (size_t i = 0; i < mesh.positions.size(); ++i) {
    mesh.colors[i] = mesh.positions[i].z < test::kWallZ + 0.1f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
  }
  const ReferenceImages images =
      buildReferenceImages(cameraChoice("di"), PinholeCamera(View{}, kHoledWidth, kHoledHeight), mesh);
  const PinholeCamera output(movedEye(View{}, {2, 0, 0}), kHoledWidth, kHoledHeight);
  ResampledView view = resample(images, output);
  ResampledView marked = view;
  markHoles(marked);
  fillHoles(view);
  size_t holes = 0;
  size_t fromTheBox = 0;
  for (int y = kHoledHeight / 2 - 20; y < kHoledHeight / 2 + 20; ++y) {
    for (int x = 100; x < 260; ++x) {
      if (view.hole(x, y) != 0) {
        ++holes;
        EXPECT_EQ(marked.color(x, y), glm::vec3(1, 0, 1));
        EXPECT_NE(view.color(x, y), glm::vec3(0));
        fromTheBox += view.color(x, y).x > view.color(x, y).y;
      }
    }
  }
  EXPECT_GT(holes, 200u);
  EXPECT_LE(fromTheBox, holes / 50);
}

// Without a depth everything around is as good, and an image without anything known stays black.
TEST(ViewHoles, allAroundWhereNothingHasADepth) {
  ResampledView view{Image<glm::vec3>(5, 1, glm::vec3(0)), Image<float>(5, 1), Image<uint8_t>(5, 1, 1)};
  fillHoles(view);
  EXPECT_EQ(view.color(2, 0), glm::vec3(0));
  view.hole(0, 0) = view.hole(4, 0) = 0;
  view.color(0, 0) = {1, 0, 0};
  view.color(4, 0) = {0, 1, 0};
  fillHoles(view);
  EXPECT_EQ(view.color(1, 0), glm::vec3(1, 0, 0));
  EXPECT_EQ(view.color(2, 0), glm::vec3(0.5f, 0.5f, 0));
  EXPECT_EQ(view.color(3, 0), glm::vec3(0, 1, 0));
  EXPECT_EQ(view.holes(), 0.6);
}

}  // namespace
}  // namespace ocelli
