#include "oc_core/evaluation/error_image.h"

#include <gtest/gtest.h>

#include <set>
#include <tuple>

namespace ocelli {
namespace {

TEST(ErrorImage, theWorstShowsFirst) {
  const ViewFrame truth{Image<glm::vec4>(6, 1, glm::vec4(1)), Image<Rgb8>(6, 1, Rgb8(200, 200, 200))};
  FrameComparison comparison{Image<SampleState>(6, 1, SampleState::kPresent), Image<uint8_t>(6, 1, 0),
                             Image<uint8_t>(6, 1, 0)};
  comparison.states[1] = SampleState::kMissing;
  comparison.states[2] = SampleState::kMissingThick;
  comparison.states[3] = SampleState::kMissingThick;
  comparison.falseSkins[3] = 1;
  comparison.states[4] = SampleState::kMissing;
  comparison.falseSkins[4] = 1;
  comparison.wrongFronts[4] = 1;
  comparison.states[5] = SampleState::kNoTruth;
  comparison.falseSkins[5] = 1;
  const Image<Rgb8> image = errorImage(truth, comparison);
  EXPECT_EQ(image[0], Rgb8(90)) << "the truth, dimmed to 0.45";
  EXPECT_EQ(image[1], kMissingColor);
  EXPECT_EQ(image[2], kMissingThickColor);
  EXPECT_EQ(image[3], kFalseSkinColor);
  EXPECT_EQ(image[4], kWrongFrontColor);
  EXPECT_EQ(image[5], kFalseSkinColor);
}

TEST(ErrorImage, truthIsGrey) {
  const ViewFrame truth{Image<glm::vec4>(1, 1, glm::vec4(1)), Image<Rgb8>(1, 1, Rgb8(255, 0, 0))};
  const Image<Rgb8> image = errorImage(
      truth, {Image<SampleState>(1, 1, SampleState::kPresent), Image<uint8_t>(1, 1, 0), Image<uint8_t>(1, 1, 0)});
  EXPECT_EQ(image[0], Rgb8(34)) << "0.45 of 0.299 of 255";
}

}  // namespace
}  // namespace ocelli
