#include "analysis/inference/distributions.h"

#include <boost/math/distributions/beta.hpp>
#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/non_central_t.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <boost/math/special_functions/beta.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>
#include <numbers>

namespace ocelli {
namespace {

using boost::math::cdf;
using boost::math::complement;
using boost::math::pdf;
using boost::math::quantile;

}  // namespace

double normalDensity(double z) {
  return std::exp(-z * z / 2) / std::sqrt(2 * std::numbers::pi);
}

double normalProbability(double z) {
  return std::erfc(-z / std::numbers::sqrt2) / 2;
}

double normalQuantile(double probability) {
  return quantile(boost::math::normal(), probability);
}

double twoSidedNormal(double z) {
  return std::erfc(std::abs(z) / std::numbers::sqrt2);
}

double studentProbability(double t, double degreesOfFreedom) {
  return std::isinf(degreesOfFreedom) ? normalProbability(t) : cdf(boost::math::students_t(degreesOfFreedom), t);
}

double studentQuantile(double probability, double degreesOfFreedom) {
  return std::isinf(degreesOfFreedom) ? normalQuantile(probability)
                                      : quantile(boost::math::students_t(degreesOfFreedom), probability);
}

double twoSidedStudent(double t, double degreesOfFreedom) {
  return 2 * studentProbability(-std::abs(t), degreesOfFreedom);
}

double noncentralStudentProbability(double t, double degreesOfFreedom, double noncentrality) {
  return cdf(boost::math::non_central_t(degreesOfFreedom, noncentrality), t);
}

double chiSquaredTail(double x, double degreesOfFreedom) {
  return cdf(complement(boost::math::chi_squared(degreesOfFreedom), x));
}

double betaQuantile(double probability, double a, double b) {
  return quantile(boost::math::beta_distribution(a, b), probability);
}

double logBeta(double a, double b) {
  return logGamma(a) + logGamma(b) - logGamma(a + b);
}

double logGamma(double x) {
  return boost::math::lgamma(x);
}

double binomialDensity(int successes, int trials, double chance) {
  return pdf(boost::math::binomial(trials, chance), successes);
}

double binomialProbability(int successes, int trials, double chance) {
  return cdf(boost::math::binomial(trials, chance), successes);
}

}  // namespace ocelli
