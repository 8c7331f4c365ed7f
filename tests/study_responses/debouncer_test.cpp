#include "study/responses/debouncer.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/study_responses/pseudo_box.h"

namespace ocelli::test {
namespace {

struct Passed {
  int64_t time = 0;
  bool pressed = false;

  bool operator==(const Passed&) const = default;
};

/// Changes of one key at these milliseconds, press and release by turns, and then a long quiet.
std::vector<Passed> passedOf(Debouncer& debouncer, const std::vector<int>& times) {
  std::vector<Passed> passed;
  const auto keep = [&](const std::vector<KeyChange>& changes) {
    for (const KeyChange& change : changes) {
      passed.push_back({change.nanoseconds / kMillisecond, change.pressed});
    }
  };
  bool pressed = false;
  for (const int time : times) {
    pressed = !pressed;
    keep(debouncer.take({Key::k1, pressed, time * kMillisecond}));
  }
  keep(debouncer.update(1'000'000 * kMillisecond));
  return passed;
}

TEST(Debouncer, LetsThePressPassAtOnceAndCountsItsBouncesOnce) {
  Debouncer debouncer(10 * kMillisecond);
  EXPECT_EQ(debouncer.take({Key::k1, true, 0}).size(), 1u) << "no response is late";
  EXPECT_TRUE(debouncer.take({Key::k1, false, kMillisecond}).empty());
  EXPECT_TRUE(debouncer.take({Key::k1, true, 2 * kMillisecond}).empty());
  EXPECT_TRUE(debouncer.take({Key::k1, false, 3 * kMillisecond}).empty());
  EXPECT_TRUE(debouncer.take({Key::k1, true, 4 * kMillisecond}).empty());
  EXPECT_TRUE(debouncer.update(50 * kMillisecond).empty());
  EXPECT_EQ(debouncer.take({Key::k1, false, 80 * kMillisecond}).size(), 1u);
  EXPECT_EQ(debouncer.bounces(), 2);
}

TEST(Debouncer, KeepsAShortTapWithItsTimes) {
  Debouncer debouncer(10 * kMillisecond);
  EXPECT_EQ(passedOf(debouncer, {0, 4, 100, 103}),
            (std::vector<Passed>{{0, true}, {4, false}, {100, true}, {103, false}}));
  EXPECT_EQ(debouncer.bounces(), 0);
}

TEST(Debouncer, TellsOfAHeldBackChangeWhenItsTimeIsOver) {
  Debouncer debouncer(10 * kMillisecond);
  debouncer.take({Key::k1, true, 0});
  debouncer.take({Key::k1, false, 4 * kMillisecond});
  EXPECT_TRUE(debouncer.update(10 * kMillisecond - 1).empty());
  const std::vector<KeyChange> released = debouncer.update(10 * kMillisecond);
  ASSERT_EQ(released.size(), 1u);
  EXPECT_EQ(released.front().nanoseconds, 4 * kMillisecond);
  EXPECT_FALSE(released.front().pressed);
}

TEST(Debouncer, LetsRepeatsOfAHeldKeyPass) {
  Debouncer debouncer(10 * kMillisecond);
  debouncer.take({Key::kLeft, true, 0});
  EXPECT_EQ(debouncer.take({Key::kLeft, true, 500 * kMillisecond}).size(), 1u);
  EXPECT_EQ(debouncer.take({Key::kLeft, true, 533 * kMillisecond}).size(), 1u);
  EXPECT_EQ(debouncer.bounces(), 0);
}

TEST(Debouncer, TreatsEachKeyByItself) {
  Debouncer debouncer(10 * kMillisecond);
  EXPECT_EQ(debouncer.take({Key::k1, true, 0}).size(), 1u);
  EXPECT_EQ(debouncer.take({Key::k2, true, kMillisecond}).size(), 1u);
  EXPECT_EQ(debouncer.take({Key::k3, false, kMillisecond}).size(), 1u) << "pressed before the run began";
}

TEST(Debouncer, IsNoneWithoutATime) {
  Debouncer debouncer(0);
  EXPECT_EQ(passedOf(debouncer, {0, 1, 2, 3}), (std::vector<Passed>{{0, true}, {1, false}, {2, true}, {3, false}}));
}

/// The rule in its plainest form, millisecond by millisecond: `down[t]` is the contact from t on.
struct PlainRule {
  PlainRule(const std::vector<bool>& down, int window) {
    bool state = false;
    int accepted = -window;
    int changed = 0;
    for (int t = 0; t < static_cast<int>(down.size()); ++t) {
      const bool before = t > 0 && down[static_cast<size_t>(t) - 1];
      const bool now = down[static_cast<size_t>(t)];
      if (before != state && t >= accepted + window) {  // it stayed until the time was over
        passed.push_back({changed, before});
        state = before;
        accepted = changed;
      }
      if (now == before) {
        continue;
      }
      changed = t;
      if (t >= accepted + window) {
        passed.push_back({t, now});
        state = now;
        accepted = t;
      } else if (now == state) {
        ++bounces;
      }
    }
  }
  std::vector<Passed> passed;
  int bounces = 0;
};

TEST(Debouncer, IsTheRuleForEveryContactOfFourteenMilliseconds) {
  constexpr int kBits = 14;
  for (int window = 1; window <= 5; ++window) {
    for (int pattern = 0; pattern < 1 << kBits; ++pattern) {
      std::vector<bool> down;
      std::vector<int> times;
      for (int t = 0; t < kBits; ++t) {
        down.push_back((pattern >> t & 1) != 0);
        if (down.back() != (t > 0 && down[static_cast<size_t>(t) - 1])) {
          times.push_back(t);
        }
      }
      down.resize(kBits + 2 * static_cast<size_t>(window) + 1, down.back());
      const PlainRule rule(down, window);
      Debouncer debouncer(window * kMillisecond);
      const std::vector<Passed> passed = passedOf(debouncer, times);
      ASSERT_EQ(passed, rule.passed) << "pattern " << pattern << ", window " << window;
      ASSERT_EQ(debouncer.bounces(), rule.bounces);
      // Whatever it is: presses and releases by turns, the first at once, and the last as the contact is.
      for (size_t i = 0; i < passed.size(); ++i) {
        ASSERT_EQ(passed[i].pressed, i % 2 == 0);
        ASSERT_TRUE(i == 0 || passed[i].time > passed[i - 1].time);
      }
      ASSERT_EQ(passed.empty(), times.empty());
      if (!times.empty()) {
        ASSERT_EQ(passed.front().time, times.front());
        ASSERT_EQ(passed.back().pressed, down.back());
      }
    }
  }
}

}  // namespace
}  // namespace ocelli::test
