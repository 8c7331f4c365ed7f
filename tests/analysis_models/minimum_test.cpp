#include "analysis/models/minimum.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ocelli {
namespace {

using Eigen::VectorXd;

VectorXd pair(double x, double y) {
  return (VectorXd(2) << x, y).finished();
}

// Derivatives by hand; differences of second order are exact for the square and 1e-5 off for the fourth power.
TEST(Minimum, IsFoundWithItsDerivatives) {
  const Objective valley = [](const VectorXd& p) {
    return 3 + 50 * std::pow(p[0] - 0.7, 2) + std::pow(p[1] + 0.2, 2) + std::pow(p[0] - 0.7, 4) +
           (p[0] - 0.7) * (p[1] + 0.2);
  };
  const Minimum minimum = findMinimum(valley, pair(2, 2), {});
  EXPECT_TRUE(minimum.converged) << minimum.reason;
  EXPECT_NEAR(minimum.point[0], 0.7, 1e-5);
  EXPECT_NEAR(minimum.point[1], -0.2, 1e-5);
  EXPECT_NEAR(minimum.value, 3, 1e-9);
  EXPECT_NEAR(minimum.hessian(0, 0), 100, 1e-3);
  EXPECT_NEAR(minimum.hessian(1, 1), 2, 1e-3);
  EXPECT_NEAR(minimum.hessian(0, 1), 1, 1e-3);
  EXPECT_GT(minimum.evaluations, 10);
}

TEST(Minimum, OfOneNumber) {
  const Minimum minimum =
      findMinimum([](const VectorXd& p) { return std::cosh(p[0] - 1.5); }, VectorXd::Constant(1, 0), {});
  EXPECT_TRUE(minimum.converged) << minimum.reason;
  EXPECT_NEAR(minimum.point[0], 1.5, 1e-4);
  EXPECT_NEAR(minimum.hessian(0, 0), 1, 1e-4);
}

TEST(Minimum, ASlopeWithoutEndIsNone) {
  MinimumSearch search;
  search.maxEvaluations = 200;
  const Minimum minimum =
      findMinimum([](const VectorXd& p) { return -p[0] - 2 * p[1] + p[0] * p[0]; }, pair(1, 1), search);
  EXPECT_FALSE(minimum.converged);
  EXPECT_FALSE(minimum.reason.empty());
}

TEST(Minimum, NoFiniteValueIsNone) {
  const Minimum minimum = findMinimum([](const VectorXd&) { return std::nan(""); }, pair(1, 1), {});
  EXPECT_FALSE(minimum.converged);
  EXPECT_EQ(minimum.reason, "the deviance is not a finite number");
}

// Twice the inverse, and nothing in a direction that is flat.
TEST(Minimum, CovarianceLeavesFlatDirectionsOut) {
  Eigen::MatrixXd hessian = Eigen::MatrixXd::Zero(2, 2);
  hessian(0, 0) = 8;
  Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(2, 2);
  expected(0, 0) = 0.25;
  EXPECT_TRUE(covarianceOfMinimum(hessian).isApprox(expected, 1e-14));
  hessian(1, 1) = 2;
  expected(1, 1) = 1;
  EXPECT_TRUE(covarianceOfMinimum(hessian).isApprox(expected, 1e-14));
}

}  // namespace
}  // namespace ocelli
