// Answers that are numbers, on a scale or on a dial: a click or a drag sets the mark, arrows move it, and Enter or a
// click on a button that appears with it confirms.
//
// There is no mark at first. One that were there would be a number that people adjust too little from (anchoring,
// Tversky and Kahneman 1974), and a place drawn at random would only turn that into noise. Nor does a number stand at
// the mark: people would choose round ones.
//
// Right and Up move the mark up the scale, or clockwise. The first arrow puts it at the end of the scale that it leads
// away from, or ahead on the dial. An arrow that is held goes on after a while. All of it passes in ticks: the repeats
// that systems send for keys that are held do nothing.
#pragma once

#include <optional>
#include <variant>

#include "study/task/held_keys.h"
#include "study/task/task_pointer.h"

namespace ocelli {

class EstimateEntry {
 public:
  /// `button` is where the one to confirm appears. Scales begin at 0 or above.
  EstimateEntry(TrialLayout::Scale scale, const PixelRect& button) : on_(std::move(scale)), button_(button) {}
  EstimateEntry(TrialLayout::Dial dial, const PixelRect& button) : on_(dial), button_(button) {}

  /// Whether the event confirms the mark. `pointer` has taken the event already where it moves.
  bool handle(const InputEvent& event, const TaskPointer& pointer);
  /// A tick passes.
  void advance();

  /// Where the mark is: on a scale in hundredths of its unit, above 0; on a dial in tenths of a degree, 0 to below 360.
  std::optional<double> value() const;
  /// Adds scale or dial, and the button where there is a mark.
  void addTo(TrialLayout& layout) const;

 private:
  void setAt(const glm::dvec2& point);
  /// By so many steps of an arrow.
  void moveBy(double steps);

  std::variant<TrialLayout::Scale, TrialLayout::Dial> on_;  ///< with the mark where it is exactly
  PixelRect button_;
  HeldKeys held_{};
  bool dragging_ = false;
  int64_t heldTicks_ = 0;  ///< since the last arrow went down
};

}  // namespace ocelli
