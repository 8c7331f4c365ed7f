#include "oc_core/feeds/subject_motion.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

namespace ocelli {
namespace {

constexpr double kStep = 1.0 / 30;
constexpr glm::dvec2 kX{1, 0};
constexpr glm::dvec2 kZ{0, 1};

glm::dvec2 walkerAt(double seconds) {
  return {-3 + 1.2 * seconds, -1 + 0.3 * seconds};
}

SubjectMotion toldFor(double seconds) {
  SubjectMotion motion(walkerAt(0), 0.3);
  for (double now = kStep; now < seconds; now += kStep) {
    motion.goOn(kStep);
    motion.tell(kX, walkerAt(now).x, 0.2);
    motion.tell(kZ, walkerAt(now).y, 0.2);
  }
  return motion;
}

TEST(SubjectMotion, learnsHowSomebodyWalks) {
  SubjectMotion motion = toldFor(3);
  EXPECT_LT(glm::length(motion.velocity() - glm::dvec2(1.2, 0.3)), 0.1);
  motion.goOn(1);
  EXPECT_LT(glm::length(motion.place() - walkerAt(4 - kStep)), 0.15);
}

TEST(SubjectMotion, twoLinesOfSightCross) {
  SubjectMotion motion({0, 0}, 1);
  const glm::dvec2 place(0.7, -0.4);
  const glm::dvec2 a = glm::normalize(glm::dvec2(2, 1));
  const glm::dvec2 b = glm::normalize(glm::dvec2(-1, 1));
  for (int i = 0; i < 10; ++i) {
    motion.tell(a, glm::dot(a, place), 0.05);
    motion.tell(b, glm::dot(b, place), 0.05);
  }
  EXPECT_LT(glm::length(motion.place() - place), 0.02);
}

TEST(SubjectMotion, oneLineOfSightTellsNothingAlongIt) {
  SubjectMotion motion({0, 0}, 1);
  for (int i = 0; i < 50; ++i) {
    motion.tell(kX, 0.5, 0.1);
  }
  EXPECT_NEAR(motion.deviationAlong(kZ), 1, 1e-9);
  EXPECT_LT(motion.deviationAlong(kX), 0.03);
  EXPECT_EQ(motion.place().y, 0);
}

TEST(SubjectMotion, whatIsFarOffCountsForLess) {
  SubjectMotion motion = toldFor(3);
  SubjectMotion jumped = motion;
  motion.tell(kX, motion.place().x + 0.1, 0.2);
  const double near = motion.place().x - jumped.place().x;
  const double before = jumped.place().x;
  jumped.tell(kX, before + 20, 0.2);
  EXPECT_GT(near, 0);
  EXPECT_LT(jumped.place().x - before, 20 * near) << "less than 200 times as far";
}

TEST(SubjectMotion, stepsDoNotChangeHowUnsureItIs) {
  SubjectMotion once({0, 0}, 0.1);
  SubjectMotion often = once;
  once.goOn(1);
  for (int i = 0; i < 50; ++i) {
    often.goOn(0.02);
  }
  EXPECT_NEAR(once.deviationAlong(kX), often.deviationAlong(kX), 1e-9);
}

}  // namespace
}  // namespace ocelli
