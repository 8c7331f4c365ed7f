// A psychometric function: a shape (study/outline/psychometric_shape.h) with its numbers.
#pragma once

#include "study/outline/psychometric_shape.h"

namespace ocelli {

struct PsychometricFunction {
  const PsychometricShape* shape = nullptr;
  double logThreshold = 0;  ///< natural logarithm
  double slope = 1;
  double guessRate = 0.5;
  double lapseRate = 0;

  /// Chance of a right answer.
  double right(double logLevel) const {
    return guessRate + (1 - guessRate - lapseRate) * shape->value(slope * (logLevel - logThreshold));
  }
};

}  // namespace ocelli
