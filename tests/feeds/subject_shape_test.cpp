#include "oc_core/feeds/subject_shape.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ocelli {
namespace {

constexpr float kCell = 0.03f;  // metres

/// A body that is filled within `half` metres beside its axis, seen in so many frames.
SubjectShape seen(float half, int frames) {
  SubjectShape shape;
  for (int frame = 0; frame < frames; ++frame) {
    for (float height = 0; height < 1; height += 0.015f) {
      for (float beside = -0.42f; beside < 0.44f; beside += kCell) {
        shape.add(height, beside, std::abs(beside) < half, kCell);
      }
    }
  }
  return shape;
}

TEST(SubjectShape, isTheUsualOneUntilSomethingIsSeen) {
  EXPECT_FLOAT_EQ(SubjectShape().shareAt(0.6f, 0.1f, 0.7f), 0.7f);
}

TEST(SubjectShape, isWhatWasSeen) {
  const SubjectShape shape = seen(0.15f, 30);
  EXPECT_GT(shape.shareAt(0.6f, 0.1f, 0.5f), 0.95f);
  EXPECT_GT(shape.shareAt(0.6f, -0.1f, 0.5f), 0.95f);
  EXPECT_LT(shape.shareAt(0.6f, 0.25f, 0.5f), 0.05f);
  EXPECT_GT(shape.shareAt(0.6f, 0.25f, 0.5f), 0) << "an arm may be there all the same";
}

TEST(SubjectShape, whatWasSeenLongAgoIsForgotten) {
  SubjectShape shape = seen(0.15f, 30);
  SubjectShape often = shape;
  shape.forget(30);
  EXPECT_NEAR(shape.shareAt(0.6f, 0.25f, 0.5f), 0.5f, 0.01f);
  // As much is kept of many short times as of a long one.
  for (int k = 0; k < 300; ++k) {
    often.forget(0.1);
  }
  EXPECT_NEAR(often.shareAt(0.6f, 0.25f, 0.5f), shape.shareAt(0.6f, 0.25f, 0.5f), 1e-4f);
}

TEST(SubjectShape, cellsFarOffCountAsMuchAsTheyCover) {
  SubjectShape near;
  SubjectShape far;
  for (int k = 0; k < 9; ++k) {
    near.add(0.6f, 0.25f, false, kCell / 3);
  }
  far.add(0.6f, 0.25f, false, kCell);
  EXPECT_NEAR(near.shareAt(0.6f, 0.25f, 0.5f), far.shareAt(0.6f, 0.25f, 0.5f), 1e-4f);
}

}  // namespace
}  // namespace ocelli
