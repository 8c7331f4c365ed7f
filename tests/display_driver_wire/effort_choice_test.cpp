#include "display_driver/wire/effort_choice.h"

#include <gtest/gtest.h>

namespace ocelli {
namespace {

using wire::Effort;

/// How many frames it takes until the effort is another one.
int framesToChange(EffortChoice& choice, bool full) {
  const Effort before = choice.effort();
  for (int frames = 1; frames < 100000; ++frames) {
    choice.frameSent(full);
    if (choice.effort() != before) {
      return frames;
    }
  }
  return -1;
}

TEST(EffortChoice, beginsFastAndBecomesSmallOnAFullLink) {
  EffortChoice choice;
  EXPECT_EQ(choice.effort(), Effort::kFast);
  EXPECT_EQ(framesToChange(choice, false), -1);
  EXPECT_EQ(framesToChange(choice, true), 1);
  EXPECT_EQ(choice.effort(), Effort::kSmall);
}

TEST(EffortChoice, triesAgainLaterAndLaterWhereThatFails) {
  EffortChoice choice;
  choice.frameSent(true);
  EXPECT_EQ(framesToChange(choice, false), 48);
  choice.frameSent(true);
  EXPECT_EQ(framesToChange(choice, false), 96);
  for (int i = 0; i < 20; ++i) {
    choice.frameSent(true);
    framesToChange(choice, false);
  }
  choice.frameSent(true);
  EXPECT_EQ(framesToChange(choice, false), 3072);
}

TEST(EffortChoice, isPatientNoLongerOnceThatHeld) {
  EffortChoice choice;
  for (int i = 0; i < 5; ++i) {
    choice.frameSent(true);
    framesToChange(choice, false);
  }
  for (int i = 0; i < 100; ++i) {
    choice.frameSent(false);
  }
  choice.frameSent(true);
  EXPECT_EQ(framesToChange(choice, false), 48);
}

TEST(EffortChoice, aFullLinkKeepsItSmall) {
  EffortChoice choice;
  choice.frameSent(true);
  EXPECT_EQ(framesToChange(choice, true), -1);
}

}  // namespace
}  // namespace ocelli
