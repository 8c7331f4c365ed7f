// What tasks share that ask for one of two things: the left one or the right one, with a choice for each below the
// view.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "oc_core/base/random.h"
#include "study/task/choice_list.h"
#include "study/task/task.h"
#include "study/task/task_pointer.h"

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

/// What a trial is of that asks for one of two.
struct TwoSidesTrial {
  TrialLayout layout;  ///< with its prompt; choices, pointer and tick come from the run
  Side right = kLeftSide;
  double limitSeconds = 0;
  std::map<std::string, double> measures;
  WalkerPose start{};
  bool showsRestingPointer = true;  ///< or else not before it has moved
};

/// It ends with a choice, or when the time is over.
class TwoSidesRun final : public TrialRun {
 public:
  TwoSidesRun(TwoSidesTrial trial, const TrialScreen& screen, const Controls& controls);

  void handle(const InputEvent& event) override;
  void advance() override;
  void frameShown(int64_t /*tick*/) override {}
  TrialLayout layout() const override;
  WalkerPose pose() const override { return trial_.start; }
  std::optional<TrialOutcome> outcome() const override { return outcome_; }

 private:
  void notePointer() { pointed_ = pointed_ || pointer_.place() != pointerAtFirst_; }
  void finish(const std::string& answer);

  TwoSidesTrial trial_;
  TaskPointer pointer_;
  glm::dvec2 pointerAtFirst_;
  bool pointed_;
  ChoiceList choices_;
  int64_t tick_ = 0;
  std::optional<TrialOutcome> outcome_{};
};

}  // namespace ocelli
