#include "study/trial/estimated_value.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "oc_core/base/error.h"

namespace ocelli {
namespace {

const EstimateUnit& kMetres = estimateUnit("m", "test");
const EstimateUnit& kDegrees = estimateUnit("degrees", "test");

TEST(EstimatedValue, LengthsAreOffByTheLogarithmOfTheirRatio) {
  EXPECT_DOUBLE_EQ((EstimatedValue{&kMetres, 6, 3}.signedError()), std::log(2.0));
  EXPECT_DOUBLE_EQ((EstimatedValue{&kMetres, 3, 6}.signedError()), -std::log(2.0));
  EXPECT_DOUBLE_EQ(estimateWithError(kMetres, 4, std::log(0.75)).estimate, 3);
}

TEST(EstimatedValue, DirectionsGoAround) {
  EXPECT_DOUBLE_EQ((EstimatedValue{&kDegrees, 10, 350}.signedError()), 20);
  EXPECT_DOUBLE_EQ((EstimatedValue{&kDegrees, 350, 10}.signedError()), -20);
  EXPECT_DOUBLE_EQ((EstimatedValue{&kDegrees, 270, 90}.signedError()), 180);
  EXPECT_DOUBLE_EQ((EstimatedValue{&kDegrees, 90, 270}.signedError()), 180) << "there is one that is opposite";
  for (const double error : {-540.0, -180.0, -1e-13, 0.0, 90.0, 359.0, 725.0}) {
    const EstimatedValue value = estimateWithError(kDegrees, 0, error);
    EXPECT_GE(value.estimate, 0) << error;
    EXPECT_LT(value.estimate, 360) << error;
    EXPECT_NEAR(value.signedError(), wrappedDegrees(error), 1e-9) << error;
  }
}

TEST(EstimatedValue, DirectionsAreWithinATurn) {
  EXPECT_EQ(withinTurn(0), 0);
  EXPECT_EQ(withinTurn(360), 0);
  EXPECT_EQ(withinTurn(-90), 270);
  EXPECT_EQ(withinTurn(725), 5);
  EXPECT_EQ(withinTurn(-725), 355);
  EXPECT_EQ(withinTurn(-1e-17), 0) << "not 360, to which it rounds";
  EXPECT_EQ(withinTurn(346.7), 346.7) << "to the last bit: replays compare it";
}

TEST(EstimatedValue, IsFoundInTheMeasuresThatItWrites) {
  for (const EstimateUnit& unit : estimateUnits()) {
    const EstimatedValue value{&unit, 12.5, 10};
    std::map<std::string, double> measures = measuresOf(value);
    measures["path_length_m"] = 3;
    const std::optional<EstimatedValue> found = estimatedValue(measures);
    ASSERT_TRUE(found) << unit.name;
    EXPECT_EQ(found->unit, &unit);
    EXPECT_EQ(found->estimate, 12.5);
    EXPECT_EQ(found->truth, 10);
  }
}

TEST(EstimatedValue, IsNotThereWhereItCannotBe) {
  EXPECT_FALSE(estimatedValue({}));
  EXPECT_FALSE(estimatedValue({{"estimate_m", 3}}));
  EXPECT_FALSE(estimatedValue({{"estimate_m", 3}, {"truth_degrees", 3}}));
  EXPECT_FALSE(estimatedValue({{"estimate_m", 0}, {"truth_m", 3}}));
  EXPECT_FALSE(estimatedValue({{"estimate_m", std::numeric_limits<double>::infinity()}, {"truth_m", 3}}));
  EXPECT_FALSE(estimatedValue({{"estimate_degrees", 360}, {"truth_degrees", 3}}));
  EXPECT_THROW(estimateUnit("feet", "test"), InputError);
}

TEST(EstimatedValue, IsStoredAsAShortNumber) {
  EXPECT_EQ(estimateText(3.25), "3.25");
  EXPECT_EQ(estimateText(270), "270");
  EXPECT_EQ(estimateText(1.0 / 3), "0.3333");
  EXPECT_EQ(estimateText(12345.678), "12345.678");
}

}  // namespace
}  // namespace ocelli
