// How far the visibility of a light is from the traced one, over the pixels that receive its light, and what it took.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "oc_core/shade/effect.h"
#include "oc_core/shade/shadow_picture.h"
#include "oc_core/shade/shadow_ways.h"

namespace ocelli {

struct ShadowFigures {
  /// Visibility that is off by more counts as wrong.
  static constexpr double kWrong = 0.1;

  size_t receivers = 0;   ///< pixels whose object has the role `receive`, and that the light shines at
  size_t inPenumbra = 0;  ///< those of them that see the light in part
  double rmse = 0;
  double penumbraRmse = 0;              ///< over those in the penumbra alone
  size_t onOthers = 0;                  ///< receivers on objects that images do not stand for, such as floors
  double onOthersRmse = 0;              ///< over those alone
  double wrong = 0;                     ///< the share of receivers that are off by more than kWrong
  double signedMean = 0;                ///< visibility minus truth: positive where light leaks
  std::optional<double> estimate = {};  ///< the root of the mean square of what the way expects to be off by
  ShadowWork work = {};
  size_t asked = 0;         ///< all points that the way was asked for
  double milliseconds = 0;  ///< for them, on all threads
};

/// Of the pixels that are measured.
ShadowFigures shadowFigures(const ShadowPixels& pixels, const std::vector<float>& truth, const LightVisibility& found);

/// The columns of the effect, and the figures of a way in them.
std::vector<FigureColumn> shadowColumns();
std::vector<std::optional<double>> shadowFigureRow(const BuiltShadow& built, const ShadowFigures& figures);

/// Where visibility is too small, red, and too large, blue; full colour at `full`. White where it is right, grey where
/// nothing is measured.
Image<Rgb8> shadowErrorImage(const ShadowPixels& pixels, const std::vector<float>& truth,
                             const std::vector<float>& found, double full);
inline constexpr Rgb8 kTooDarkColor{178, 24, 43};
inline constexpr Rgb8 kTooLightColor{33, 102, 172};

}  // namespace ocelli
