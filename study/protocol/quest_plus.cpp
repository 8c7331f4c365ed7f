#include "study/protocol/quest_plus.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "oc_core/base/check.h"
#include "oc_core/base/json_fields.h"

namespace ocelli {
namespace {

constexpr int kThresholds = 41;
constexpr int kSlopes = 9;
constexpr int kLapses = 4;
/// Entropies that differ by less are equal: rounding must not choose a level.
constexpr double kSameEntropy = 1e-9;
/// No answer is impossible: one of probability 0 would end all hope of the grid.
constexpr double kMinProbability = 1e-9;

/// Number `index` of `count` from `first` to `last`, by equal steps.
double stepBetween(double first, double last, int index, int count) {
  return first + (last - first) * index / (count - 1);
}

double entropyTerm(double probability) {
  return probability > 0 ? -probability * std::log(probability) : 0;
}

}  // namespace

QuestPlus::QuestPlus(const std::vector<double>& levels, const QuestPlusOptions& options) : options_(options) {
  OC_CHECK(levels.size() >= 2 && levels.front() > 0 && std::is_sorted(levels.begin(), levels.end()),
           "levels ascend and are above 0");
  for (const double level : levels) {
    logLevels_.push_back(std::log(level));
  }
  const int lapses = options.maxLapses > 0 ? kLapses : 1;
  const int slopes = options.maxSlope > options.minSlope ? kSlopes : 1;
  for (int t = 0; t < kThresholds; ++t) {
    for (int s = 0; s < slopes; ++s) {
      for (int l = 0; l < lapses; ++l) {
        grid_.push_back({.shape = options.shape,
                         .logThreshold = stepBetween(logLevels_.front(), logLevels_.back(), t, kThresholds),
                         .slope = slopes == 1 ? options.minSlope
                                              : std::exp(stepBetween(std::log(options.minSlope),
                                                                     std::log(options.maxSlope), s, slopes)),
                         .guessRate = options.guessRate,
                         .lapseRate = lapses == 1 ? 0 : stepBetween(0, options.maxLapses, l, lapses)});
      }
    }
  }
  for (const double logLevel : logLevels_) {
    std::vector<Chance>& row = chances_.emplace_back();
    for (const PsychometricFunction& function : grid_) {
      const double right = std::clamp(function.right(logLevel), kMinProbability, 1 - kMinProbability);
      row.push_back({right, std::log(right), std::log1p(-right), entropyTerm(right) + entropyTerm(1 - right)});
    }
  }
}

std::vector<double> QuestPlus::posterior(std::span<const LevelAnswer> answers) const {
  std::vector<double> logs(grid_.size(), 0);
  for (const LevelAnswer& answer : answers) {
    const std::vector<Chance>& chances = chances_.at(answer.level);
    for (size_t i = 0; i < logs.size(); ++i) {
      logs[i] += answer.correct ? chances[i].logRight : chances[i].logWrong;
    }
  }
  const double greatest = *std::max_element(logs.begin(), logs.end());
  for (double& each : logs) {
    each = std::exp(each - greatest);
  }
  const double sum = std::accumulate(logs.begin(), logs.end(), 0.0);
  for (double& each : logs) {
    each /= sum;
  }
  return logs;
}

double QuestPlus::expectedGain(const std::vector<double>& posterior, size_t level) const {
  const std::vector<Chance>& chances = chances_.at(level);
  double right = 0;
  double entropy = 0;
  for (size_t i = 0; i < grid_.size(); ++i) {
    right += posterior[i] * chances[i].right;
    entropy += posterior[i] * chances[i].entropy;
  }
  return entropyTerm(right) + entropyTerm(1 - right) - entropy;
}

size_t QuestPlus::next(std::span<const LevelAnswer> before) const {
  const std::vector<double> known = posterior(before);
  size_t best = logLevels_.size() - 1;
  double greatest = expectedGain(known, best);
  for (size_t level = best; level-- > 0;) {
    const double gain = expectedGain(known, level);
    if (gain > greatest + kSameEntropy) {
      greatest = gain;
      best = level;
    }
  }
  return best;
}

std::optional<double> QuestPlus::threshold(std::span<const LevelAnswer> answers) const {
  const std::vector<double> known = posterior(answers);
  double mean = 0;
  for (size_t i = 0; i < grid_.size(); ++i) {
    mean += known[i] * grid_[i].logThreshold;
  }
  return std::exp(mean);
}

std::string QuestPlus::summary() const {
  return fmt::format(
      "QUEST+, {}: {} of the way from guessing to the best at the threshold; slopes {:g} to {:g}, lapses to {:g}, "
      "guesses {:g}",
      options_.shape->name, options_.shape->threshold, options_.minSlope, options_.maxSlope, options_.maxLapses,
      options_.guessRate);
}

std::unique_ptr<const Staircase> readQuestPlus(JsonFields& fields, const std::vector<double>& levels,
                                               double guessRate) {
  QuestPlusOptions options;
  options.guessRate = guessRate;
  std::vector<std::string> names;
  for (const PsychometricShape& shape : psychometricShapes()) {
    names.emplace_back(shape.name);
  }
  options.shape = &psychometricShape(fields.choice("function", names, options.shape->name), fields.where());
  options.minSlope = fields.number("least_slope", 0.05, 50, options.minSlope);
  options.maxSlope = fields.number("most_slope", 0.05, 50, options.maxSlope);
  options.maxLapses = fields.number("most_lapses", 0, 0.3, options.maxLapses);
  if (options.maxSlope < options.minSlope) {
    fields.fail("most_slope", fmt::format("must be at least \"least_slope\", which is {:g}", options.minSlope));
  }
  return std::make_unique<QuestPlus>(levels, options);
}

}  // namespace ocelli
