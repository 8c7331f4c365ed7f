// n-down-1-up (H. Levitt 1971, Transformed up-down methods in psychoacoustics, Journal of the Acoustical Society of
// America 49): after n right answers in a row the next level is harder, after a wrong one it is easier. Where it
// settles n right answers in a row have the chance 1/2, so that the share of right ones is 0.5^(1/n): 0.794 of 3.
//
// The threshold is the geometric mean of the levels at which the staircase turned, without those that it took to get
// there; an even number of them, so that turns from above and from below are as many.
#pragma once

#include "study/protocol/staircase.h"

namespace ocelli {

struct UpDownOptions {
  int rightInARow = 3;
  int firstStep = 2;  ///< levels, until it turns for the first time; then single ones
};

class UpDown final : public Staircase {
 public:
  /// `levels` ascend and are above 0. It begins at the greatest.
  UpDown(std::vector<double> levels, const UpDownOptions& options);

  size_t next(std::span<const LevelAnswer> before) const override;
  std::optional<double> threshold(std::span<const LevelAnswer> answers) const override;
  std::string summary() const override;

  /// The share of right answers at which it settles.
  double target() const;
  /// Indices of the levels at which it turned, in order.
  std::vector<size_t> turns(std::span<const LevelAnswer> answers) const;

 private:
  struct Walk {
    size_t level = 0;  ///< the next
    std::vector<size_t> turns{};
  };
  Walk walk(std::span<const LevelAnswer> answers) const;

  std::vector<double> levels_;
  UpDownOptions options_;
};

/// Reads "right_in_a_row" and "first_step".
std::unique_ptr<const Staircase> readUpDown(JsonFields& fields, const std::vector<double>& levels, double guessRate);

}  // namespace ocelli
