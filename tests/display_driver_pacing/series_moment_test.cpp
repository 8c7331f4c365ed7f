#include "display_driver/pacing/series_moment.h"

#include <gtest/gtest.h>

#include <vector>

namespace ocelli {
namespace {

TEST(SeriesMoment, isTheLastThatHasBegun) {
  const std::vector<double> times{2, 3, 6};
  EXPECT_EQ(seriesMoment(times, 0, {}), 0u);
  EXPECT_EQ(seriesMoment(times, 0.99, {}), 0u);
  EXPECT_EQ(seriesMoment(times, 1, {}), 1u);
  EXPECT_EQ(seriesMoment(times, 3.99, {}), 1u);
  EXPECT_EQ(seriesMoment(times, 4, {}), 2u);
}

TEST(SeriesMoment, endsWhereTheLastHasStayedAsLongAsOneDoesInTheMean) {
  const std::vector<double> times{2, 3, 6};  // two seconds in the mean
  EXPECT_EQ(seriesMoment(times, 5.99, {}), 2u);
  EXPECT_EQ(seriesMoment(times, 6, {}), std::nullopt);
  EXPECT_EQ(seriesMoment(times, 6, {.loop = true}), 0u);
  EXPECT_EQ(seriesMoment(times, 7.5, {.loop = true}), 1u);
  EXPECT_EQ(seriesMoment(times, 13, {.loop = true}), 1u);
}

TEST(SeriesMoment, runsAtTheSpeed) {
  const std::vector<double> times{0, 1};
  EXPECT_EQ(seriesMoment(times, 0.6, {.speed = 2}), 1u);
  EXPECT_EQ(seriesMoment(times, 1.1, {.speed = 2}), std::nullopt);
  EXPECT_EQ(seriesMoment(times, 1.1, {.speed = 0.5}), 0u);
}

TEST(SeriesMoment, ofAVolumeThatStandsStillIsTheFirst) {
  EXPECT_EQ(seriesMoment({}, 1e9, {}), 0u);
  EXPECT_EQ(seriesMoment(std::vector<double>{4}, 1e9, {}), 0u);
}

}  // namespace
}  // namespace ocelli
