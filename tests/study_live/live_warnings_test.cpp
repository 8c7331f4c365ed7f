#include "study/live/live_warnings.h"

#include <gtest/gtest.h>

namespace ocelli::test {
namespace {

TEST(LiveWarnings, tellOfTroubleAndOfNothingElse) {
  EXPECT_EQ(warningOf("focus_lost"), "The window lost the keyboard.");
  EXPECT_FALSE(warningOf("responses_lost").empty());
  for (const char* ordinary : {"note", "pause", "resume", "page", "break", "redo", "practice_passed", "markers", ""}) {
    EXPECT_TRUE(warningOf(ordinary).empty()) << ordinary;
  }
}

}  // namespace
}  // namespace ocelli::test
