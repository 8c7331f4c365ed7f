#include "oc_core/ocri/coverage.h"

#include <gtest/gtest.h>

#include "tests/ocri/test_scenes.h"

namespace ocelli {
namespace {

using test::kHeight;
using test::kWidth;
using test::smallCamera;

/// A wall that faces the camera at depth 10: neighbouring samples are one footprint apart.
Image<glm::vec4> wallPositions() {
  return positionImage(smallCamera(), test::wall(0));
}

float footprint() {
  return 10 / smallCamera().focalPixels();
}

MissingSamples compare(const Image<glm::vec4>& truth, const Image<glm::vec4>& frame) {
  return countMissing(compareFrames(smallCamera(), truth, frame));
}

void erase(Image<glm::vec4>& frame, int x, int y, int width, int height) {
  for (int v = y; v < y + height; ++v) {
    for (int u = x; u < x + width; ++u) {
      frame(u, v) = glm::vec4(0);
    }
  }
}

TEST(CompareFrames, nothingIsMissingFromTheTruthItself) {
  for (const Mesh& mesh : {test::wall(0), test::boxBeforeWall(), makeSphere(20)}) {
    const Image<glm::vec4> truth = positionImage(smallCamera(), mesh);
    const MissingSamples missing = compare(truth, truth);
    EXPECT_GT(missing.truth, 1000u);
    EXPECT_EQ(missing.strict, 0u);
    EXPECT_EQ(missing.thick, 0u);
  }
}

TEST(CompareFrames, everythingIsMissingFromAnotherPlace) {
  const Image<glm::vec4> truth = wallPositions();
  Image<glm::vec4> frame = truth;
  for (glm::vec4& p : frame) {
    p.z -= 1;
  }
  const MissingSamples missing = compare(truth, frame);
  EXPECT_EQ(missing.truth, static_cast<size_t>(kWidth * kHeight));
  EXPECT_EQ(missing.strict, missing.truth);
  EXPECT_EQ(missing.thick, static_cast<size_t>((kWidth - 2) * (kHeight - 2))) << "border pixels lack neighbours";
  EXPECT_EQ(missing.strictRatio(), 1);
}

TEST(CompareFrames, reachIsOneAndAHalfFootprints) {
  const Image<glm::vec4> truth = wallPositions();
  for (const auto& [footprints, present] : {std::pair(1.45f, true), {1.55f, false}}) {
    Image<glm::vec4> frame = truth;
    for (glm::vec4& p : frame) {
      p.z -= footprints * footprint();
    }
    EXPECT_EQ(compare(truth, frame).strict, present ? 0 : truth.size()) << footprints;
  }
}

// A sample is found in the 3x3 pixels around it, at most sqrt(2) footprints away: a hole loses a rim of one pixel to
// the strict measure, and another one to the thick one.
TEST(CompareFrames, holeOfFivePixelsIsThickAndASlitIsNot) {
  const Image<glm::vec4> truth = wallPositions();
  const auto missingWithHole = [&](int width, int height) {
    Image<glm::vec4> frame = truth;
    erase(frame, 40, 20, width, height);
    return compare(truth, frame);
  };
  EXPECT_EQ(missingWithHole(5, 5).strict, 9u);
  EXPECT_EQ(missingWithHole(5, 5).thick, 1u);
  EXPECT_EQ(missingWithHole(9, 7).strict, 7u * 5u);
  EXPECT_EQ(missingWithHole(9, 7).thick, 5u * 3u);
  EXPECT_EQ(missingWithHole(1, 30).strict, 0u) << "a slit of one pixel";
  EXPECT_EQ(missingWithHole(3, 30).strict, 28u) << "three pixels lack their middle";
  EXPECT_EQ(missingWithHole(3, 30).thick, 0u);
}

TEST(CompareFrames, pixelsWithoutTruthDoNotCount) {
  Image<glm::vec4> truth = wallPositions();
  erase(truth, 0, 0, kWidth, 10);
  const MissingSamples missing = compare(truth, Image<glm::vec4>(kWidth, kHeight, glm::vec4(0)));
  EXPECT_EQ(missing.truth, static_cast<size_t>(kWidth * (kHeight - 10)));
  EXPECT_EQ(missing.strict, missing.truth);
  const MissingSamples nothing = compare(Image<glm::vec4>(kWidth, kHeight, glm::vec4(0)), truth);
  EXPECT_EQ(nothing.truth, 0u);
  EXPECT_EQ(nothing.strictRatio(), 0);
  EXPECT_EQ(nothing.thickRatio(), 0);
}

TEST(MissingSamples, addUp) {
  MissingSamples sum{100, 10, 1};
  sum += {300, 30, 3};
  EXPECT_EQ(sum.truth, 400u);
  EXPECT_EQ(sum.strictRatio(), 0.1);
  EXPECT_EQ(sum.thickRatio(), 0.01);
}

TEST(PositionImage, holdsWorldPointsWhereSomethingIsSeen) {
  const Image<glm::vec4> positions = positionImage(smallCamera(), test::boxBeforeWall());
  EXPECT_EQ(positions(45, 30).w, 1);
  EXPECT_NEAR(positions(45, 30).z, test::kBoxFrontZ, 1e-5f);
  EXPECT_NEAR(positions(2, 2).z, test::kWallZ, 1e-5f);
  EXPECT_EQ(positionImage(smallCamera(), test::wall(0, 0.2f))(0, 0).w, 0);
}

}  // namespace
}  // namespace ocelli
