#include "study/outline/psychometric_shape.h"

#include <gtest/gtest.h>

#include <cmath>

#include "oc_core/base/error.h"

namespace ocelli {
namespace {

TEST(PsychometricShapes, AreWhatTheirNamesSay) {
  const PsychometricShape& weibull = psychometricShape("weibull", "test");
  EXPECT_NEAR(weibull.value(0), 1 - std::exp(-1), 1e-15);
  EXPECT_NEAR(weibull.value(3 * std::log(2)), 1 - std::exp(-8), 1e-15) << "twice the threshold, a slope of 3";
  const PsychometricShape& logistic = psychometricShape("logistic", "test");
  EXPECT_NEAR(logistic.value(0), 0.5, 1e-15);
  EXPECT_NEAR(logistic.value(3 * std::log(2)), 8.0 / 9, 1e-15);
}

TEST(PsychometricShapes, RiseFromNothingToAll) {
  for (const PsychometricShape& shape : psychometricShapes()) {
    EXPECT_NEAR(shape.value(-50), 0, 1e-15) << shape.name;
    EXPECT_NEAR(shape.value(50), 1, 1e-15) << shape.name;
    EXPECT_LT(shape.value(-0.1), shape.value(0.1)) << shape.name;
  }
}

TEST(PsychometricShapes, SayWhichThereAre) {
  EXPECT_EQ(psychometricShapeNames(), "weibull, logistic");
  EXPECT_THROW(psychometricShape("step", "test"), InputError);
}

}  // namespace
}  // namespace ocelli
