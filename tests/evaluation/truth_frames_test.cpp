#include "oc_core/evaluation/truth_frames.h"

#include <gtest/gtest.h>

#include "tests/ocri/test_scenes.h"

namespace ocelli {
namespace {

std::vector<PinholeCamera> threeCameras() {
  std::vector<PinholeCamera> cameras;
  for (const float x : {-0.5f, 0.0f, 0.5f}) {
    cameras.emplace_back(movedEye(View{}, {x, 0, 0}), test::kWidth, test::kHeight);
  }
  return cameras;
}

constexpr size_t kFrameBytes = size_t{test::kWidth} * test::kHeight * 19;  // 16 for the point, 3 for the colour

TEST(TruthFrames, showTheSceneFromEachCamera) {
  const Mesh mesh = test::boxBeforeWall();
  TruthFrames frames(mesh, threeCameras());
  ASSERT_EQ(frames.count(), 3u);
  for (size_t i = 0; i < frames.count(); ++i) {
    EXPECT_TRUE(test::sameBytes(frames.frame(i)->points, positionImage(frames.camera(i), mesh)));
  }
}

TEST(TruthFrames, areRenderedOnce) {
  const Mesh mesh = test::boxBeforeWall();
  TruthFrames frames(mesh, threeCameras());
  const auto first = frames.frame(1);
  EXPECT_EQ(frames.frame(1), first);
  EXPECT_EQ(frames.keptFrames(), 1u);
}

TEST(TruthFrames, beyondTheirMemoryAreRenderedAnew) {
  const Mesh mesh = test::boxBeforeWall();
  TruthFrames frames(mesh, threeCameras(), 2 * kFrameBytes);
  TruthFrames all(mesh, threeCameras());
  for (int round = 0; round < 2; ++round) {
    for (size_t i = 0; i < frames.count(); ++i) {
      EXPECT_TRUE(test::sameBytes(frames.frame(i)->points, all.frame(i)->points));
      EXPECT_TRUE(frames.frame(i)->image == all.frame(i)->image);
    }
  }
  EXPECT_EQ(frames.keptFrames(), 2u);
  TruthFrames none(mesh, threeCameras(), kFrameBytes - 1);
  EXPECT_TRUE(test::sameBytes(none.frame(2)->points, all.frame(2)->points));
  EXPECT_EQ(none.keptFrames(), 0u);
}

}  // namespace
}  // namespace ocelli
