// How often an answer is right, by the level of a stimulus: a psychometric function in the logarithm of the level, and
// its threshold (Wichmann, Hill 2001, The psychometric function I, Percept. Psychophys. 63(8); Watson 2017, QUEST+,
// J. Vis. 17(3)).
//
//   P(right) = guess + (1 - guess - lapse) F(slope (log level - log threshold))
//
// Fitted is the mode of the posterior of threshold, slope and lapse (maximum a posteriori). Priors: flat for log
// threshold within kThresholdReach of the levels; normal for log slope, so that answers which the levels separate
// (whose likelihood rises with the slope without end) have an estimate; for the lapse a density in proportion to
// (1 - lapse)^kLapseWeight from 0 to kMaxLapse. In a staircase the level of a trial follows from answers before it; the
// likelihood is the same as if levels had been set beforehand.
#pragma once

#include <vector>

#include "analysis/base/estimable.h"
#include "analysis/base/estimate.h"
#include "study/outline/psychometric_shape.h"

namespace ocelli {

inline constexpr double kThresholdReach = 2.302585;  ///< log 10 beyond the lowest and the highest level
inline constexpr double kLapseWeight = 19;
inline constexpr double kMaxLapse = 0.1;

struct PsychometricModel {
  const PsychometricShape* shape = &psychometricShape("logistic", "PsychometricModel");
  double guess = 0.5;              ///< 0 to below 1 - kMaxLapse
  double logSlopeMean = 1.386294;  ///< log 4: from a tenth to nine tenths of F the level triples
  double logSlopeDeviation = 1;
};

/// All trials at one level.
struct LevelCounts {
  double logLevel = 0;
  int right = 0;
  int trials = 0;
};

/// Rising by level. `levels` are above 0, one a trial.
std::vector<LevelCounts> levelCounts(const std::vector<double>& levels, const std::vector<bool>& right);

struct PsychometricPoint {
  double logThreshold = 0;
  double logSlope = 0;
  double lapse = 0;
};

double rightProbability(const PsychometricModel& model, const PsychometricPoint& point, double logLevel);
/// What is maximised, but for a constant. Minus infinity outside of the priors.
double logPosterior(const PsychometricModel& model, const std::vector<LevelCounts>& counts,
                    const PsychometricPoint& point);

struct PsychometricFit {
  PsychometricPoint point{};
  double logPosterior = 0;
  double standardError = kNotKnown;  ///< of log threshold, from the curvature of the posterior
  int trials = 0;
  bool separable = false;  ///< all wrong answers lie below all right ones: the slope is the prior's
  bool outside = false;    ///< the threshold lies beyond the lowest or the highest level
};

/// Impossible: fewer than two levels, all answers right or wrong, and where they do not become better with the level.
/// Throws InputError for a guess rate out of range, and for levels that are not finite.
Estimable<PsychometricFit> fitPsychometric(const PsychometricModel& model, const std::vector<LevelCounts>& counts);

}  // namespace ocelli
