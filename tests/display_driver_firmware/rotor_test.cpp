#include "display_driver/firmware/rotor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/display_driver_wire/made_volumes.h"

namespace ocelli {
namespace {

constexpr double kIdealMicroseconds = 60e6 / 720 / 2;  // a half turn at 720 a minute

TEST(Rotor, withoutErrorsEveryRefreshIsAsLong) {
  Rotor rotor(smallProfile(11), {});
  for (uint64_t i = 0; i < 1000; ++i) {
    EXPECT_EQ(rotor.refresh(), i);
    EXPECT_NEAR(rotor.lengthMicroseconds(), kIdealMicroseconds, 1e-6);
    EXPECT_NEAR(static_cast<double>(rotor.begin()), static_cast<double>(i) * kIdealMicroseconds, 1);  // rounded up
    EXPECT_TRUE(rotor.locked());
    rotor.nextRefresh();
  }
}

// What happens at a time and what is said to happen then are the same, for every slice and whatever the rounding.
TEST(Rotor, aSliceBeginsWhenItSaysSo) {
  for (const int slices : {2, 5, 9, 11, 24, 198, 1000}) {
    Rotor rotor(smallProfile(slices), {.jitter = 0.01, .seed = static_cast<uint64_t>(slices)});
    for (int refresh = 0; refresh < 30; ++refresh) {
      ASSERT_EQ(rotor.beginOf(0), rotor.begin());
      ASSERT_EQ(rotor.sliceAt(rotor.begin()), 0);
      for (int slice = 1; slice < slices; ++slice) {
        ASSERT_EQ(rotor.sliceAt(rotor.beginOf(slice)), slice) << "refresh " << refresh;
        ASSERT_EQ(rotor.sliceAt(rotor.beginOf(slice) - 1), slice - 1) << "refresh " << refresh;
      }
      ASSERT_EQ(rotor.sliceAt(rotor.end() - 1), slices - 1);
      const DeviceMicroseconds end = rotor.end();
      rotor.nextRefresh();
      ASSERT_EQ(rotor.begin(), end);
    }
  }
}

TEST(Rotor, jitterHasItsDeviationAndDoesNotAddUp) {
  Rotor rotor(smallProfile(198), {.jitter = 0.002, .controllerGain = 0.2, .seed = 4});
  double sum = 0;
  double squares = 0;
  constexpr int kRefreshes = 20000;
  for (int i = 0; i < kRefreshes; ++i) {
    const double error = rotor.lengthMicroseconds() / kIdealMicroseconds - 1;
    sum += error;
    squares += error * error;
    EXPECT_LT(std::abs(rotor.phaseErrorDegrees()), 180 * 0.002 * 10);
    rotor.nextRefresh();
  }
  // The controller takes 0.2 of the phase error back: the length's variance is that of the jitter times
  // 1 + g^2 / (1 - (1 - g)^2) = 1.11. Five standard errors of so many refreshes are below 3 %.
  EXPECT_NEAR(std::sqrt(squares / kRefreshes), 0.002 * std::sqrt(1.0 + 0.04 / 0.36), 0.03 * 0.002);
  EXPECT_NEAR(sum / kRefreshes, 0, 1e-5);
}

TEST(Rotor, theSameSeedTurnsTheSame) {
  Rotor a(smallProfile(), {.jitter = 0.01, .seed = 3});
  Rotor b(smallProfile(), {.jitter = 0.01, .seed = 3});
  Rotor other(smallProfile(), {.jitter = 0.01, .seed = 4});
  bool differs = false;
  for (int i = 0; i < 10; ++i) {
    EXPECT_EQ(a.end(), b.end());
    differs = differs || a.end() != other.end();
    a.nextRefresh();
    b.nextRefresh();
    other.nextRefresh();
  }
  EXPECT_TRUE(differs);
}

// A motor that runs at another rate: the controller holds it at the error at which what it takes back is what is lost.
TEST(Rotor, driftIsHeldAndTakenBack) {
  Rotor rotor(smallProfile(198), {.controllerGain = 0.2});
  rotor.setRate(0.99);
  for (int i = 0; i < 200; ++i) {
    rotor.nextRefresh();
  }
  const double late = (1 / 0.99 - 1) / 0.2;  // in refreshes
  EXPECT_NEAR(rotor.phaseErrorDegrees(), -180 * late, 1e-6);
  EXPECT_FALSE(rotor.locked());
  rotor.setRate(1);
  for (int i = 0; i < 100; ++i) {
    rotor.nextRefresh();
  }
  EXPECT_NEAR(rotor.phaseErrorDegrees(), 0, 1e-6);
  EXPECT_TRUE(rotor.locked());
}

TEST(Rotor, withoutAControllerItRunsAway) {
  Rotor rotor(smallProfile(198), {.controllerGain = 0});
  rotor.setRate(1.001);
  for (int i = 0; i < 1000; ++i) {
    rotor.nextRefresh();
  }
  EXPECT_GT(rotor.phaseErrorDegrees(), 170);  // one refresh in a thousand
  EXPECT_FALSE(rotor.locked());
}

TEST(Rotor, aDisplayWhoseSecondHalfTurnHasItsOwnSlicesRefreshesOnceATurn) {
  DisplayProfile profile = smallProfile(11);
  profile.secondHalfTurn = SecondHalfTurn::kOwn;
  Rotor rotor(profile, {});
  EXPECT_NEAR(rotor.lengthMicroseconds(), 2 * kIdealMicroseconds, 1e-6);
  EXPECT_EQ(rotor.sliceAt(rotor.end() - 1), 21);
}

}  // namespace
}  // namespace ocelli
