#include "oc_core/base/check.h"

#include <gtest/gtest.h>

TEST(CheckDeathTest, StopsWithConditionAndPlace) {
  EXPECT_DEATH(OC_CHECK(1 + 1 == 3, "arithmetic"), "internal error: arithmetic \\(1 \\+ 1 == 3\\) at .*check_test.cpp");
}

TEST(Check, EvaluatesItsConditionOnce) {
  int calls = 0;
  OC_CHECK(++calls > 0, "the condition holds");
  EXPECT_EQ(calls, 1);
}
