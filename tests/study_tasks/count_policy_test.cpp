#include "study/tasks/count_policy.h"

#include <gtest/gtest.h>

#include <cmath>

#include "oc_core/base/conventions.h"

namespace ocelli {
namespace {

constexpr int64_t kSecond = 1'000'000'000;
constexpr double kPixelsPerMeter = 40;

HumanFactors sharpFactors() {
  HumanFactors factors;
  factors.slip = 0;
  factors.placeErrorDegrees = 1e-6;
  factors.turnErrorDegrees = 1e-6;
  factors.workingMemoryItems = 100;
  return factors;
}

class CountPolicyTest : public testing::Test {
 protected:
  /// A scene of `count` objects on one view, in a row.
  Percept single(int count) const {
    Percept percept;
    percept.views = {{0, 0, 960, 600}};
    for (int i = 0; i < count; ++i) {
      percept.objects.push_back(object(0, static_cast<LandmarkColor>(i), {100 + 110.0 * i, 300}, {3.0 * i, 0}));
    }
    return percept;
  }
  static Sighting object(int view, LandmarkColor color, const glm::dvec2& at, const glm::dvec2& place) {
    Sighting seen;
    seen.shape = LandmarkShape::kSphere;
    seen.color = color;
    seen.view = view;
    seen.pixels = 400;
    seen.centroid = at;
    seen.place = place;
    seen.perspective = PicturePerspective{{{kPixelsPerMeter, 0}, {0, kPixelsPerMeter}}};
    return seen;
  }
  /// What is answered after looking for so long: 3 to 9.
  int answerTo(const std::function<Percept(int64_t now)>& scene, double seconds, uint64_t seed = 5) {
    CountPolicy policy(vision, seed);
    MotorModel motor(factors, Controls{}, 1);
    int64_t now = 0;
    while (now < nanosecondsOf(seconds)) {
      now += nanosecondsOf(policy.think(scene(now), now, now + 3 * kSecond / 10, motor)) + 3 * kSecond / 10;
    }
    Percept asks;
    for (int i = 3; i <= 9; ++i) {
      asks.choices.push_back({{}, std::to_string(i), static_cast<Key>(static_cast<int>(Key::k0) + i), false});
    }
    policy.think(asks, now, now + 3 * kSecond / 10, motor);
    for (const TimedInput& input : motor.take(now + 60 * kSecond)) {
      if (const auto* key = std::get_if<KeyEvent>(&input.event)) {
        return static_cast<int>(key->key) - static_cast<int>(Key::k0);
      }
    }
    return -1;
  }

  HumanFactors factors = sharpFactors();
  Vision vision{factors, 20};
};

TEST_F(CountPolicyTest, countsWhatStandsInOneView) {
  for (int count = 4; count <= 7; ++count) {
    EXPECT_EQ(answerTo([&](int64_t) { return single(count); }, 15), count);
  }
}

TEST_F(CountPolicyTest, doesNotCountTinyThings) {
  EXPECT_EQ(answerTo(
                [&](int64_t) {
                  Percept percept = single(6);
                  percept.objects[2].pixels = 1;  // 1/20 degree
                  return percept;
                },
                15),
            5);
}

TEST_F(CountPolicyTest, countsTwoOfOneColorInOneView) {
  EXPECT_EQ(answerTo(
                [&](int64_t) {
                  Percept percept = single(5);
                  percept.objects[4].color = percept.objects[0].color;
                  return percept;
                },
                15),
            5);
}

TEST_F(CountPolicyTest, followsWhatMoves) {
  EXPECT_EQ(answerTo(
                [&](int64_t now) {
                  Percept percept = single(5);
                  for (Sighting& seen : percept.objects) {
                    seen.centroid.y += 8 * secondsOf(now);  // 0.4 degrees a second
                    seen.place.y += 0.1 * secondsOf(now);
                  }
                  return percept;
                },
                12),
            5);
}

/// Four alike, one above the other, that go 3.2 degrees a second to the right: faster than one allows for where one
/// does not follow them.
Percept walkers(const std::function<Sighting(int, LandmarkColor, const glm::dvec2&, const glm::dvec2&)>& object,
                int64_t now) {
  Percept percept;
  percept.views = {{0, 0, 440, 600}};
  for (int i = 0; i < 4; ++i) {
    const glm::dvec2 at(60 + 64 * secondsOf(now), 90 + 140.0 * i);
    percept.objects.push_back(object(0, LandmarkColor::kOrange, at, at / kPixelsPerMeter));
    percept.objects.back().pixels = 900;  // large enough to be noticed 27 degrees from the gaze
  }
  return percept;
}

TEST_F(CountPolicyTest, followsWithItsEyesAsManyAsItCan) {
  factors.workingMemoryItems = 0;  // so that what it loses from sight counts as new
  const auto scene = [&](int64_t now) { return walkers(object, now); };
  factors.trackedItems = 4;
  EXPECT_EQ(answerTo(scene, 5), 4);
  factors.trackedItems = 0;
  EXPECT_GT(answerTo(scene, 5), 4);
}

TEST_F(CountPolicyTest, isLessSureWherePicturesAreTurnedOrSmall) {
  // One thing in two views; how often it is taken for two.
  const auto takenForTwo = [&](const PicturePerspective& first, const PicturePerspective& second, double metersApart) {
    int count = 0;
    for (uint64_t seed = 1; seed <= 60; ++seed) {
      Percept percept;
      percept.views = {{0, 0, 200, 150}, {220, 0, 200, 150}};
      for (int i = 0; i < 3; ++i) {
        percept.objects.push_back(object(0, static_cast<LandmarkColor>(i), {30 + 45.0 * i, 70}, {20.0 * i, 0}));
      }
      percept.objects[0].perspective = first;
      percept.objects.push_back(object(1, LandmarkColor::kOrange, {260, 70}, {metersApart, 0}));
      percept.objects.back().perspective = second;
      count += answerTo([&](int64_t) { return percept; }, 8, seed) > 3 ? 1 : 0;
    }
    return count;
  };
  const PicturePerspective large{{{40, 0}, {0, 40}}};
  const PicturePerspective small{{{4, 0}, {0, 4}}};
  const PicturePerspective turned{{{0, 40}, {-40, 0}}};
  factors.placeErrorDegrees = 0.5;  // 10 pixels: 0.25 m in the large one, 2.5 m in the small one
  factors.turnErrorDegrees = 20;    // of 3 m around a thing in the large one: 1 m
  EXPECT_GE(takenForTwo(large, large, 2), 55);
  EXPECT_LE(takenForTwo(small, small, 2), 40);
  EXPECT_LE(takenForTwo(large, turned, 2), takenForTwo(large, large, 2) - 5);
  factors.turnErrorDegrees = 0;
  EXPECT_GE(takenForTwo(large, turned, 2), 55);
}

/// Four objects, three of which show in both views of a matrix.
Percept matrix(const std::function<Sighting(int, LandmarkColor, const glm::dvec2&, const glm::dvec2&)>& object) {
  Percept percept;
  percept.views = {{0, 0, 200, 150}, {220, 0, 200, 150}, {440, 0, 200, 150}};
  for (int i = 0; i < 4; ++i) {
    const auto color = static_cast<LandmarkColor>(i);
    percept.objects.push_back(object(0, color, {30 + 45.0 * i, 70}, {4.0 * i, 0}));
    if (i > 0) {
      percept.objects.push_back(object(1, color, {240 + 45.0 * i, 70}, {4.0 * i, 0}));
    }
  }
  percept.objects.push_back(object(2, LandmarkColor::kPurple, {540, 70}, {40, 0}));
  return percept;
}

TEST_F(CountPolicyTest, tellsThatThingsInOtherViewsAreTheSame) {
  // It takes one thing for two in one of seven cases (exp(-2)): of three that show twice that leaves 5 or 6.
  int sum = 0;
  for (uint64_t seed = 1; seed <= 40; ++seed) {
    const int answer = answerTo([&](int64_t) { return matrix(object); }, 15, seed);
    EXPECT_GE(answer, 5);
    sum += answer;
  }
  EXPECT_NEAR(sum / 40.0, 5 + 3 * std::exp(-2), 0.38);  // four standard errors
}

TEST_F(CountPolicyTest, countsTwiceWhatItHasNotInMind) {
  factors.workingMemoryItems = 0;
  EXPECT_EQ(answerTo([&](int64_t) { return matrix(object); }, 15), 8);
}

TEST_F(CountPolicyTest, takesDistantThingsOfOneColorForOneWhereItCannotTellPlaces) {
  factors.placeErrorDegrees = 100;  // 50 m
  EXPECT_LE(answerTo(
                [&](int64_t) {
                  Percept percept = matrix(object);
                  percept.objects.back().color = LandmarkColor::kOrange;
                  return percept;
                },
                15),
            5);
}

TEST_F(CountPolicyTest, takesThingsForOneWhereThePictureTellsNoPlaces) {
  EXPECT_EQ(answerTo(
                [&](int64_t) {
                  Percept percept = matrix(object);
                  percept.objects.back().color = LandmarkColor::kOrange;
                  for (Sighting& seen : percept.objects) {
                    seen.perspective.reset();
                  }
                  return percept;
                },
                15),
            4);
}

TEST_F(CountPolicyTest, guessesForWhatItHadNoTimeToLookAt) {
  // Many views with one object each: a second is not enough for all.
  Percept percept;
  for (int i = 0; i < 8; ++i) {
    percept.views.push_back({1000.0 * i, 0, 200, 150});
    percept.objects.push_back(object(i, static_cast<LandmarkColor>(i), {1000.0 * i + 100, 75}, {10.0 * i, 0}));
  }
  EXPECT_NEAR(answerTo([&](int64_t) { return percept; }, 1.0), 8, 1);
}

}  // namespace
}  // namespace ocelli
