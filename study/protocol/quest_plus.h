// QUEST+ (A. B. Watson 2017, QUEST+: A general multidimensional Bayesian adaptive psychometric method, Journal of
// Vision 17(3):10) for one level, two answers, and three unknowns: threshold, slope and lapse rate.
//
// A grid of the unknowns, all equally likely at first, is weighted by what each answer says of them (Bayes). The next
// level is the one after whose answer the grid is expected to be surest: of the least expected entropy. The threshold
// is the mean of its logarithm over the grid.
#pragma once

#include "study/protocol/psychometric_function.h"
#include "study/protocol/staircase.h"

namespace ocelli {

struct QuestPlusOptions {
  const PsychometricShape* shape = &psychometricShapes().front();
  double guessRate = 0.5;
  double minSlope = 0.7;
  double maxSlope = 5;
  double maxLapses = 0.06;
};

class QuestPlus final : public Staircase {
 public:
  /// `levels` ascend and are above 0; two at least.
  QuestPlus(const std::vector<double>& levels, const QuestPlusOptions& options);

  /// Of the levels that are equally good, the easiest.
  size_t next(std::span<const LevelAnswer> before) const override;
  std::optional<double> threshold(std::span<const LevelAnswer> answers) const override;
  std::string summary() const override;

  /// The grid: thresholds from the least level to the greatest, slopes by equal factors, lapses by equal steps.
  const std::vector<PsychometricFunction>& grid() const { return grid_; }
  /// Of each function of the grid after these answers; the sum is 1.
  std::vector<double> posterior(std::span<const LevelAnswer> answers) const;
  /// By how much an answer to that level is expected to lower the entropy of the posterior, natural units. It is the
  /// entropy of the answer less the mean of that which each function of the grid expects of it: the same as Watson's
  /// difference of entropies of the grid, with fewer logarithms.
  double expectedGain(const std::vector<double>& posterior, size_t level) const;

 private:
  QuestPlusOptions options_;
  std::vector<double> logLevels_;
  std::vector<PsychometricFunction> grid_;
  /// Of a function at a level.
  struct Chance {
    double right = 0;     ///< of a right answer
    double logRight = 0;  ///< its logarithm
    double logWrong = 0;  ///< likewise of a wrong one
    double entropy = 0;   ///< of the answer
  };
  std::vector<std::vector<Chance>> chances_;  ///< by level and function
};

/// Reads "function", "least_slope", "most_slope" and "most_lapses".
std::unique_ptr<const Staircase> readQuestPlus(JsonFields& fields, const std::vector<double>& levels, double guessRate);

}  // namespace ocelli
