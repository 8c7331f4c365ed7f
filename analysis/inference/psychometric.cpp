#include "analysis/inference/psychometric.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "analysis/inference/wald.h"
#include "oc_core/base/error.h"

namespace ocelli {
namespace {

// Where the search begins, and where it ends: far below what any data tell.
constexpr int kThresholdSteps = 24;
constexpr int kSlopeSteps = 8;
constexpr double kSlopeReach = 2;  ///< standard deviations of the prior
constexpr double kFirstStep = 0.2;
constexpr double kLastStep = 1e-7;
constexpr double kCurvatureStep = 1e-3;

double log0(double p) {
  return std::log(std::max(p, 1e-300));
}

struct Range {
  double low = 0;
  double high = 0;
};

Range thresholdRange(const std::vector<LevelCounts>& counts) {
  return {counts.front().logLevel - kThresholdReach, counts.back().logLevel + kThresholdReach};
}

double logLikelihood(const PsychometricModel& model, const std::vector<LevelCounts>& counts,
                     const PsychometricPoint& point) {
  double sum = 0;
  for (const LevelCounts& each : counts) {
    const double p = rightProbability(model, point, each.logLevel);
    sum += each.right * log0(p) + (each.trials - each.right) * log0(1 - p);
  }
  return sum;
}

/// The posterior in units in which steps of all three are alike in size.
class Search {
 public:
  Search(const PsychometricModel& model, const std::vector<LevelCounts>& counts) : model_(model), counts_(counts) {}

  PsychometricPoint best() const {
    std::array<double, 3> at = start();
    double value = of(at);
    // The compass: steps along each coordinate, and on along what the last round gained; half as long where none helps.
    for (double step = kFirstStep; step > kLastStep;) {
      const std::array<double, 3> before = at;
      const double valueBefore = value;
      for (size_t i = 0; i < at.size(); ++i) {
        for (const double sign : {1.0, -1.0}) {
          std::array<double, 3> next = at;
          next[i] += sign * step;
          clampLapse(next);
          if (const double there = of(next); there > value) {
            at = next;
            value = there;
            break;
          }
        }
      }
      if (value > valueBefore) {
        std::array<double, 3> beyond{};
        for (size_t i = 0; i < at.size(); ++i) {
          beyond[i] = 2 * at[i] - before[i];
        }
        clampLapse(beyond);
        if (const double there = of(beyond); there > value) {
          at = beyond;
          value = there;
        }
      } else {
        step /= 2;
      }
    }
    return pointOf(at);
  }

 private:
  static PsychometricPoint pointOf(const std::array<double, 3>& at) { return {at[0], at[1], at[2] * kMaxLapse}; }
  static void clampLapse(std::array<double, 3>& at) { at[2] = std::clamp(at[2], 0.0, 1.0); }
  double of(const std::array<double, 3>& at) const { return logPosterior(model_, counts_, pointOf(at)); }

  std::array<double, 3> start() const {
    const Range range = thresholdRange(counts_);
    std::array<double, 3> best{};
    double value = -INFINITY;
    for (int i = 0; i <= kThresholdSteps; ++i) {
      for (int k = 0; k <= kSlopeSteps; ++k) {
        const std::array<double, 3> at{
            range.low + (range.high - range.low) * i / kThresholdSteps,
            model_.logSlopeMean + model_.logSlopeDeviation * kSlopeReach * (2.0 * k / kSlopeSteps - 1), 0.2};
        if (const double there = of(at); there > value) {
          value = there;
          best = at;
        }
      }
    }
    return best;
  }

  const PsychometricModel& model_;
  const std::vector<LevelCounts>& counts_;
};

/// Of log threshold, with the slope unknown and the lapse as it is.
double standardErrorAt(const PsychometricModel& model, const std::vector<LevelCounts>& counts,
                       const PsychometricPoint& point) {
  const double h = kCurvatureStep;
  const auto at = [&](double threshold, double slope) {
    return logPosterior(model, counts, {point.logThreshold + threshold, point.logSlope + slope, point.lapse});
  };
  const double middle = at(0, 0);
  const double ofThreshold = -(at(h, 0) - 2 * middle + at(-h, 0)) / (h * h);
  const double ofSlope = -(at(0, h) - 2 * middle + at(0, -h)) / (h * h);
  const double both = -(at(h, h) - at(h, -h) - at(-h, h) + at(-h, -h)) / (4 * h * h);
  const double determinant = ofThreshold * ofSlope - both * both;
  return determinant > 0 && ofSlope > 0 ? std::sqrt(ofSlope / determinant) : kNotKnown;
}

}  // namespace

std::vector<LevelCounts> levelCounts(const std::vector<double>& levels, const std::vector<bool>& right) {
  requireArgument(levels.size() == right.size(), "there is one answer a level", "levelCounts");
  std::map<double, LevelCounts> counts;
  for (size_t i = 0; i < levels.size(); ++i) {
    requireArgument(std::isfinite(levels[i]) && levels[i] > 0, "levels are above 0", "levelCounts");
    LevelCounts& each = counts[levels[i]];
    each.logLevel = std::log(levels[i]);
    each.right += right[i] ? 1 : 0;
    ++each.trials;
  }
  std::vector<LevelCounts> list;
  for (const auto& [level, each] : counts) {
    list.push_back(each);
  }
  return list;
}

double rightProbability(const PsychometricModel& model, const PsychometricPoint& point, double logLevel) {
  const double f = model.shape->value(std::exp(point.logSlope) * (logLevel - point.logThreshold));
  return model.guess + (1 - model.guess - point.lapse) * f;
}

double logPosterior(const PsychometricModel& model, const std::vector<LevelCounts>& counts,
                    const PsychometricPoint& point) {
  const Range range = thresholdRange(counts);
  if (point.logThreshold < range.low || point.logThreshold > range.high || point.lapse < 0 || point.lapse > kMaxLapse) {
    return -INFINITY;
  }
  const double z = (point.logSlope - model.logSlopeMean) / model.logSlopeDeviation;
  return logLikelihood(model, counts, point) - z * z / 2 + kLapseWeight * std::log1p(-point.lapse);
}

Estimable<PsychometricFit> fitPsychometric(const PsychometricModel& model, const std::vector<LevelCounts>& counts) {
  using Result = Estimable<PsychometricFit>;
  requireArgument(model.guess >= 0 && model.guess < 1 - kMaxLapse, "the guess rate is from 0 to below 0.9",
                  "fitPsychometric");
  if (counts.size() < 2) {
    return Result::impossible(counts.empty() ? "there are no trials" : "all trials have one level");
  }
  int right = 0;
  PsychometricFit fit;
  double lowestRight = INFINITY;
  double highestWrong = -INFINITY;
  for (const LevelCounts& each : counts) {
    requireArgument(std::isfinite(each.logLevel), "levels are finite", "fitPsychometric");
    right += each.right;
    fit.trials += each.trials;
    lowestRight = each.right > 0 ? std::min(lowestRight, each.logLevel) : lowestRight;
    highestWrong = each.right < each.trials ? std::max(highestWrong, each.logLevel) : highestWrong;
  }
  if (right == 0 || right == fit.trials) {
    return Result::impossible(right == 0 ? "all answers are wrong" : "all answers are right");
  }
  fit.point = Search(model, counts).best();
  fit.logPosterior = logPosterior(model, counts, fit.point);
  const double share = static_cast<double>(right) / fit.trials;
  const double ofConstant = right * std::log(share) + (fit.trials - right) * std::log(1 - share);
  if (logLikelihood(model, counts, fit.point) <= ofConstant) {
    return Result::impossible("answers do not become better with the level");
  }
  fit.standardError = standardErrorAt(model, counts, fit.point);
  fit.separable = highestWrong < lowestRight;
  fit.outside = fit.point.logThreshold < counts.front().logLevel || fit.point.logThreshold > counts.back().logLevel;
  return fit;
}

}  // namespace ocelli
