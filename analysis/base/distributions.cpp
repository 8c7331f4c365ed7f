#include "analysis/base/distributions.h"

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

/// Its quantiles are infinite where they are larger than a number can be.
using Overflowing =
    boost::math::policies::policy<boost::math::policies::overflow_error<boost::math::policies::ignore_error>,
                                  boost::math::policies::evaluation_error<boost::math::policies::ignore_error>>;
using Student = boost::math::students_t_distribution<double, Overflowing>;

/// In double alone: in long double, Boost 1.74 finds no median of Beta(5, 5).
using InDouble = boost::math::policies::policy<boost::math::policies::promote_double<false>>;

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
  return std::isinf(degreesOfFreedom) ? normalProbability(t) : cdf(Student(degreesOfFreedom), t);
}

double studentTail(double t, double degreesOfFreedom) {
  return std::isinf(degreesOfFreedom) ? cdf(complement(boost::math::normal(), t))
                                      : cdf(complement(Student(degreesOfFreedom), t));
}

double studentQuantile(double probability, double degreesOfFreedom) {
  return std::isinf(degreesOfFreedom) ? normalQuantile(probability) : quantile(Student(degreesOfFreedom), probability);
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

double orderStatisticQuantile(double share, size_t k, size_t n) {
  return quantile(
      boost::math::beta_distribution<double, InDouble>(static_cast<double>(k) + 1, static_cast<double>(n - k)), share);
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
