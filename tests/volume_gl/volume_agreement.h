// How far two images of a volume are apart: that of the CPU, and that of OpenGL.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "oc_core/volume_gl/gl_volume_renderer.h"

namespace ocelli::test {

/// What cameras have with OpenGL is 1/255. Here it is less than a third of that: the CPU ends rays behind the group of
/// samples in which 1/1024 of the light is left, and OpenGL behind the sample.
inline constexpr double kColorTolerance = 1.0 / 1024 + 2e-4;
/// Where rays do not end early: what single precision loses is below 5e-5; the CPU leaves
/// 2e-4 of the light without shade at most.
inline constexpr double kRoundingTolerance = 3e-4;

struct VolumeAgreement {
  double color = 0;  ///< the greatest difference of a channel or of the opacity
  double meanOpacity = 0;
  size_t otherDepths = 0;  ///< pixels whose t is another, by more than a thousandth, or held by one image alone
  size_t depths = 0;       ///< pixels with a t
};

inline VolumeAgreement agreementOf(const VolumeImage& expected, const VolumeImage& got) {
  VolumeAgreement agreement;
  EXPECT_EQ(expected.width(), got.width());
  EXPECT_EQ(expected.height(), got.height());
  for (size_t i = 0; i < expected.size(); ++i) {
    for (int c = 0; c < 4; ++c) {
      const double difference = static_cast<double>(expected[i].color[c]) - static_cast<double>(got[i].color[c]);
      agreement.color = std::max(agreement.color, std::isfinite(difference) ? std::abs(difference) : 1.0);
    }
    agreement.meanOpacity += static_cast<double>(expected[i].color.w) / static_cast<double>(expected.size());
    const bool isDeep = std::isfinite(expected[i].t);
    agreement.depths += isDeep;
    constexpr float kSame = 1e-3f;
    agreement.otherDepths += isDeep != std::isfinite(got[i].t) ||
                             (isDeep && std::abs(expected[i].t - got[i].t) > kSame * std::max(1.0f, expected[i].t));
    EXPECT_EQ(std::isfinite(expected[i].surfaceT), std::isfinite(got[i].surfaceT));
    if (std::isfinite(expected[i].surfaceT)) {
      EXPECT_FLOAT_EQ(expected[i].surfaceT, got[i].surfaceT);
    }
  }
  return agreement;
}

/// There is something to compare, colours are within `tolerance`, and of 200 depths at most one is another: where a
/// faint place decides which of two layers is deep enough.
inline void expectAgreement(const VolumeImage& expected, const VolumeImage& got, const std::string& name,
                            double tolerance = kColorTolerance) {
  const VolumeAgreement agreement = agreementOf(expected, got);
  EXPECT_LE(agreement.color, tolerance) << name;
  EXPECT_LE(agreement.otherDepths, agreement.depths / 200) << name;
  EXPECT_GT(agreement.meanOpacity, 0.01) << name << ": something is seen";
  testing::Test::RecordProperty(name, std::to_string(agreement.color));
}

}  // namespace ocelli::test
