// Answers to choose from: a click on one, its key, or, where no answer has these as its key, arrows and Enter.
#pragma once

#include <optional>
#include <vector>

#include "study/task/task_pointer.h"

namespace ocelli {

class ChoiceList {
 public:
  explicit ChoiceList(std::vector<TrialLayout::Choice> choices) : choices_(std::move(choices)) {}

  /// The index of the answer that the event chooses, if it does. `pointer` has not taken the event yet.
  std::optional<int> handle(const InputEvent& event, const TaskPointer& pointer);
  const std::vector<TrialLayout::Choice>& choices() const { return choices_; }

 private:
  void mark(int index);

  std::vector<TrialLayout::Choice> choices_;
  int marked_ = -1;  ///< by arrows
};

}  // namespace ocelli
