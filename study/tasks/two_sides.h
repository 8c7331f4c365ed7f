// What tasks share that ask for one of two things: the left one or the right one, with a choice for each below the
// view.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "oc_core/base/random.h"
#include "study/task/trial_layout.h"

namespace ocelli {

enum Side : size_t { kLeftSide, kRightSide };
inline constexpr std::array kBothSides{kLeftSide, kRightSide};
/// As answers are stored.
inline constexpr std::array<const char*, 2> kSideNames{"left", "right"};

constexpr Side otherSide(Side side) {
  return side == kLeftSide ? kRightSide : kLeftSide;
}
/// The answer that is wrong, for GeneratorModel::wrongAnswer.
std::string otherSideName(const std::string& expected, Random& random);

/// The view lies above the two choices.
struct TwoSidesStage {
  explicit TwoSidesStage(const TrialScreen& screen);

  /// "the left one" and "the right one", answered by the arrow keys, too.
  std::vector<TrialLayout::Choice> layoutChoices() const;

  PixelRect view;
  std::vector<PixelRect> choices;  ///< by Side
};

}  // namespace ocelli
