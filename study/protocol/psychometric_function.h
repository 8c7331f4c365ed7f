// How the share of right answers grows with the level of a stimulus: psychometric functions, a row each.
//
//   p(level) = guess + (1 - guess - lapse) * F(ln level - ln threshold, slope)
//
// The greater a level, the easier. Levels are above 0.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace ocelli {

struct PsychometricShape {
  const char* name;         ///< in protocols
  const char* description;  ///< with what F is at the threshold
  /// F of the logarithm of level by threshold, 0 to 1.
  double (*of)(double logLevel, double slope);
};

/// "weibull": 1 - exp(-(level / threshold)^slope), 0.632 at the threshold, as Watson (2017) has it; "logistic":
/// 1 / (1 + (threshold / level)^slope), 0.5 at the threshold.
std::span<const PsychometricShape> psychometricShapes();

struct PsychometricFunction {
  const PsychometricShape* shape = nullptr;
  double logThreshold = 0;  ///< natural logarithm
  double slope = 1;
  double guessRate = 0.5;
  double lapseRate = 0;

  /// Chance of a right answer.
  double right(double logLevel) const {
    return guessRate + (1 - guessRate - lapseRate) * shape->of(logLevel - logThreshold, slope);
  }
};

}  // namespace ocelli
