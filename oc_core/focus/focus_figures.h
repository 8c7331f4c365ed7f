// What ways to show foci (focus_way.h) do to focus and context, measured on their maps alone, in the same manner for
// all: docs/focus_and_context.md defines each figure.
//
// Places of the plain view are tried at the centres of its pixels, places of the picture at the centres of its pixels.
// Derivatives are central differences over 2e-4 of a pixel, some thousandths of a pixel beside the place, where the map
// has neither a corner nor a jump: it may have one at the place itself.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "oc_core/focus/focus_map.h"
#include "oc_core/image/image.h"

namespace ocelli {

struct FocusFigures {
  double focusShare = 0;  ///< of the picture's pixels that show what is in focus
  /// Samples for each one of the plain view within the foci, in the direction with fewest, and in that with most;
  /// nothing where no pixel of the picture shows what is in focus.
  std::optional<double> leastFocusRate{};
  std::optional<double> greatestFocusRate{};
  double focusBend = 0;    ///< of lines that are straight in the plain view, across a focus: bow / length
  double hiddenShare = 0;  ///< of the context: what the picture does not show
  double sparseShare = 0;  ///< of the context: what it shows with less than half the plain view's samples, or not
  std::optional<double> leastContextRate{};  ///< of what it shows of the context; nothing where that is nothing
  double contextBend = 0;  ///< as focusBend, of segments as long as an eighth of the height that lie in the context
  double jumpPixels = 0;   ///< how far apart neighbours in the picture may lie in the plain view
  double rateStep = 1;     ///< the greatest factor between the rates on both sides of a place

  /// Less than this is rounding.
  static constexpr double kMinJump = 1e-3;
  bool isContinuous() const { return jumpPixels < kMinJump; }
};

FocusFigures focusFigures(const FocusMap& map, const GpcLayout& layout, const glm::ivec2& size);

/// At each pixel of the picture: samples for each one of the plain view, in the direction that has fewest.
Image<float> pictureRates(const FocusMap& map, const glm::ivec2& size);
/// The same at each pixel of the plain view; 0 where the picture does not show it.
Image<float> plainRates(const FocusMap& map, const glm::ivec2& size);

}  // namespace ocelli
