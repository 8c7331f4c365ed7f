#include "study/tasks/two_sides.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "study/task/task_fields.h"
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

TwoSidesRun::TwoSidesRun(TwoSidesTrial trial, const TrialScreen& screen, const Controls& controls)
    : trial_(std::move(trial)),
      pointer_(wholeScreen(screen), controls),
      pointerAtFirst_(pointer_.place()),
      pointed_(trial_.showsRestingPointer),
      choices_(TwoSidesStage(screen).layoutChoices()) {}

void TwoSidesRun::handle(const InputEvent& event) {
  if (outcome_) {
    return;
  }
  const std::optional<int> chosen = choices_.handle(event, pointer_);
  pointer_.handle(event);
  notePointer();
  if (chosen) {
    finish(kSideNames[static_cast<size_t>(*chosen)]);
  }
}

void TwoSidesRun::advance() {
  if (outcome_) {
    return;
  }
  ++tick_;
  pointer_.advance();
  notePointer();
  if (tick_ >= ticksOf(trial_.limitSeconds)) {
    finish("");
  }
}

TrialLayout TwoSidesRun::layout() const {
  TrialLayout layout = trial_.layout;
  layout.tick = tick_;
  layout.choices = choices_.choices();
  layout.pointer = pointed_ ? std::optional(pointer_.place()) : std::nullopt;
  return layout;
}

void TwoSidesRun::finish(const std::string& answer) {
  TrialOutcome outcome;
  outcome.expected = kSideNames[trial_.right];
  outcome.answer = answer;
  outcome.correct = answer == outcome.expected;
  outcome.censored = answer.empty();
  outcome.responseTicks = tick_;
  outcome.measures = trial_.measures;
  outcome_ = std::move(outcome);
}

}  // namespace ocelli
