// Scores of known errors, and what the dithers reach.
#include "display_sim/dither_score/dither_score.h"

#include <gtest/gtest.h>

#include <cmath>

#include "display_sim/dither/voxel_dither.h"

namespace ocelli {
namespace {

DitherField flatField(float light) {
  return {"flat", 64, 32, 8, [light](int, int, int) { return glm::vec3(light); }};
}

TEST(DitherScore, ofTheLightItselfIsZero) {
  const DitherField field = rampField();
  const DitherScore score = scoreDither(field, wantedLight(field));
  EXPECT_EQ(score.meanBlockError, 0);
  EXPECT_EQ(score.worstBlockError, 0);
  EXPECT_EQ(score.banding, 0);
  EXPECT_EQ(score.blotches, 0);
}

TEST(DitherScore, measuresKnownErrors) {
  const DitherField field = flatField(0.5f);
  std::vector<glm::vec3> shown = wantedLight(field);
  for (int slice = 0; slice < field.slices; ++slice) {
    for (int row = 0; row < field.rows; ++row) {
      for (int column = 0; column < 16; ++column) {
        shown[field.index(column, row, slice)].x += 0.25f;  // red, in a quarter of the columns
      }
    }
  }
  const DitherScore score = scoreDither(field, shown);
  EXPECT_NEAR(score.meanBlockError, 0.25 / 4 / 3, 1e-9);
  EXPECT_NEAR(score.worstBlockError, 0.25, 1e-9);
  EXPECT_NEAR(score.bias, 0.25 / 4 / 3, 1e-9);
  EXPECT_NEAR(score.banding, std::sqrt(0.25 * 0.25 / 4 / 3), 1e-9);
  EXPECT_GT(score.blotches, 5);  // one wide band
}

TEST(DitherScore, seesNoBlotchesInAFineCheckerboardAndOneInWhiteNoise) {
  const DitherField field = flatField(0.5f);
  std::vector<glm::vec3> fine(field.voxels());
  std::vector<glm::vec3> white(field.voxels());
  uint32_t random = 1;
  for (size_t i = 0; i < field.voxels(); ++i) {
    fine[i] = glm::vec3((i + i / 64 + i / (64 * 32)) % 2 == 0 ? 1.0f : 0.0f);
    random = random * 1664525u + 1013904223u;
    white[i] = glm::vec3(random >> 31 == 0 ? 1.0f : 0.0f);
  }
  EXPECT_LT(scoreDither(field, fine).blotches, 1e-9);
  // The mean over 22 frequencies of 8 slices; each has a deviation of 1, and the three channels are alike.
  EXPECT_NEAR(scoreDither(field, white).blotches, 1, 4 / std::sqrt(22 * 8));
}

TEST(DitherScore, orderedDitheringErrsByLessThanOnePartIn255) {
  for (const int bits : {1, 3}) {
    for (const DitherField& field : ditherFields()) {
      const DitherScore score = scoreDither(field, shownLight(field, ColorReduction::kDither, bits));
      EXPECT_LT(score.meanBlockError, 1.0 / 255) << field.name << ", bits " << bits;
      EXPECT_LT(std::abs(score.bias), 0.1 / 255) << field.name << ", bits " << bits;
    }
  }
}

// The other dithers don't: these are the figures that docs/dithering.md states, rounded up.
TEST(DitherScore, otherDithersErrByWhatTheDocumentSays) {
  for (const DitherField& field : ditherFields()) {
    EXPECT_LT(scoreDither(field, shownLight(field, ColorReduction::kBlueNoise, 1)).meanBlockError, 1.7 / 255);
    EXPECT_LT(scoreDither(field, shownLight(field, ColorReduction::kDiffusion, 1)).meanBlockError, 1.4 / 255);
    EXPECT_LT(scoreDither(field, shownLight(field, ColorReduction::kDiffusion, 3)).meanBlockError, 1.0 / 255);
    // Bands: a grey of 1 bit is shown as black or white.
    EXPECT_GT(scoreDither(field, shownLight(field, ColorReduction::kNearest, 1)).meanBlockError, 20.0 / 255);
  }
}

TEST(VoxelDither, lightsWhiteFullyAndKeepsBlackDark) {
  for (int bits = 1; bits <= 8; ++bits) {
    for (const NamedDither& dither : kNamedDithers) {
      for (const float light : {0.0f, 1.0f}) {
        const DitherField field = flatField(light);
        for (const glm::vec3& shown : shownLight(field, dither.colors, bits)) {
          ASSERT_EQ(shown, glm::vec3(light)) << dither.name << ", bits " << bits;
        }
      }
    }
  }
}

TEST(VoxelDither, thresholdsLieBetweenNoneAndFullLight) {
  for (const ColorReduction colors : {ColorReduction::kDither, ColorReduction::kBlueNoise, ColorReduction::kNearest}) {
    const VoxelDither dither(colors);
    for (int i = 0; i < 64 * 64 * 64; ++i) {
      const float threshold = dither.threshold(i >> 12, i & 63, i >> 6 & 63);
      ASSERT_GT(threshold, 0.0f);
      ASSERT_LT(threshold, 1.0f);
    }
  }
}

}  // namespace
}  // namespace ocelli
