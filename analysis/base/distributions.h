// Distribution functions. Their library stands behind this header alone, as it takes long to compile.
#pragma once

#include <cstddef>

#include "analysis/base/normal_tail.h"

namespace ocelli {

double normalDensity(double z);
/// P(Z <= z).
double normalProbability(double z);
/// z with P(Z <= z) = `probability`, for probabilities between 0 and 1.
double normalQuantile(double probability);
/// P(|Z| >= |z|).
double twoSidedNormal(double z);

/// Degrees of freedom may be infinite: then it is the normal distribution.
double studentProbability(double t, double degreesOfFreedom);
/// Infinite where it is larger than a number can be.
double studentQuantile(double probability, double degreesOfFreedom);
/// P(T > t).
double studentTail(double t, double degreesOfFreedom);
double twoSidedStudent(double t, double degreesOfFreedom);
/// P(T <= t) of the noncentral distribution.
double noncentralStudentProbability(double t, double degreesOfFreedom, double noncentrality);

/// P(X >= x).
double chiSquaredTail(double x, double degreesOfFreedom);

double betaQuantile(double probability, double a, double b);
/// Of number `k`, counted from 0, of `n` sorted numbers that are uniform between 0 and 1.
double orderStatisticQuantile(double share, size_t k, size_t n);
double logBeta(double a, double b);
double logGamma(double x);

double binomialDensity(int successes, int trials, double chance);
/// P(X <= successes).
double binomialProbability(int successes, int trials, double chance);

}  // namespace ocelli
