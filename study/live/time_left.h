// How long the trials of a session still take, about.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace ocelli {

class TimeLeft {
 public:
  /// Trials of the pace: fewer tell nothing.
  static constexpr size_t kMinTrials = 3;

  /// `typicalSeconds` is what the protocol gives for a trial, with its share of instructions, practice and breaks.
  explicit TimeLeft(double typicalSeconds) : typicalSeconds_(typicalSeconds) {}

  /// A trial of the schedule was completed.
  void trialCompleted(int64_t nanoseconds);
  /// The session stood still: the time until the next trial ends is not counted.
  void interrupted() { last_.reset(); }

  bool knowsPace() const { return intervals_.size() >= kMinTrials; }
  /// Of so many trials: their number times the median time from the end of one trial to the end of the next, so that a
  /// long break among them does not count; what the protocol says until kMinTrials such times are known.
  double seconds(int trials) const;

 private:
  double typicalSeconds_;
  std::optional<int64_t> last_{};    ///< end of the trial before
  std::vector<double> intervals_{};  ///< seconds
};

}  // namespace ocelli
