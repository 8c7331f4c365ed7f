#include "study/tasks/two_sides.h"

#include <fmt/format.h>

#include <cmath>

#include "study/task/task_layout.h"

namespace ocelli {

std::string otherSideName(const std::string& expected, Random& /*random*/) {
  return kSideNames[expected == kSideNames[kLeftSide] ? kRightSide : kLeftSide];
}

TwoSidesStage::TwoSidesStage(const TrialScreen& screen) {
  constexpr double kChoicesShare = 0.14;
  constexpr double kMargin = 0.15;  // of the choices' height, around them
  const PixelRect stage = stageOf(screen);
  const double height = std::floor(kChoicesShare * stage.height);
  const double margin = std::floor(kMargin * height);
  view = {stage.left, stage.top, stage.width, stage.height - height};
  choices = gridOf({stage.left + margin, view.bottom() + margin, stage.width - 2 * margin, height - 2 * margin}, 1, 2,
                   kMargin);
}

std::vector<TrialLayout::Choice> TwoSidesStage::layoutChoices() const {
  constexpr std::array kKeys{Key::kLeft, Key::kRight};
  std::vector<TrialLayout::Choice> made;
  for (const Side side : kBothSides) {
    made.push_back({choices[side], fmt::format("the {} one", kSideNames[side]), kKeys[side]});
  }
  return made;
}

}  // namespace ocelli
