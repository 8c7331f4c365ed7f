#include "study/protocol/psychometric_function.h"

#include <array>
#include <cmath>

namespace ocelli {
namespace {

constexpr std::array kPsychometricShapes{
    PsychometricShape{"weibull", "Weibull: 63 % of the way from guessing to the best at the threshold",
                      [](double logLevel, double slope) { return -std::expm1(-std::exp(slope * logLevel)); }},
    PsychometricShape{"logistic", "logistic: half of the way from guessing to the best at the threshold",
                      [](double logLevel, double slope) { return 1 / (1 + std::exp(-slope * logLevel)); }},
};

}  // namespace

std::span<const PsychometricShape> psychometricShapes() {
  return kPsychometricShapes;
}

}  // namespace ocelli
