#include "study/outline/exclusion_rule.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "oc_core/base/json_fields.h"
#include "tests/study_outline/outline_text.h"

namespace ocelli::test {
namespace {

using testing::HasSubstr;

ExclusionRule ruleOf(const std::string& what, const std::string& test, const std::string& value) {
  const std::string text =
      R"({"what": ")" + what + R"(", "test": ")" + test + R"(", "value": )" + value + R"(, "reason": "why"})";
  return readOutline(text, ProtocolReading::kByStudy,
                     [](JsonFields& fields, ProtocolReading) { return readExclusionRule(fields, 10); });
}

std::string errorOfRule(const std::string& text) {
  return outlineErrorOf(text, ProtocolReading::kByStudy,
                        [](JsonFields& fields, ProtocolReading) { return readExclusionRule(fields, 10); });
}

TEST(ExclusionRules, HaveTestsWithNames) {
  for (const ExclusionTest test : kExclusionTests) {
    EXPECT_EQ(exclusionTestOf(nameOf(test)), test);
  }
  EXPECT_FALSE(exclusionTestOf("roughly"));
}

TEST(ExclusionRules, HaveTheKindsOfTheTable) {
  for (const ExclusionKind& kind : kExclusionKinds) {
    ASSERT_TRUE(exclusionKindOf(kind.what).has_value());
    EXPECT_EQ(exclusionKindOf(kind.what)->value, kind.value);
  }
  EXPECT_EQ(exclusionKindOf("form:vision")->value, ExclusionValue::kText);
  EXPECT_FALSE(exclusionKindOf("form:"));
  EXPECT_FALSE(exclusionKindOf("mood"));
}

// The study takes a number that is written as a text, and an option that is written as a number: so must an analysis.
TEST(ExclusionRules, HaveTheValueOfTheirKindHoweverItIsWritten) {
  EXPECT_EQ(ruleOf("timeout_share", "at_least", "0.25").number, 0.25);
  EXPECT_EQ(ruleOf("timeout_share", "at_least", "\"0.25\"").number, 0.25);
  EXPECT_TRUE(std::isnan(ruleOf("timeout_share", "at_least", "\"1x\"").number));
  EXPECT_EQ(ruleOf("form:age", "is", "\"3\"").text, "3");
  EXPECT_EQ(ruleOf("form:age", "is", "3").text, "3");
  const ExclusionRule rule = ruleOf("ending", "is_not", "\"completed\"");
  EXPECT_EQ(rule.test, ExclusionTest::kIsNot);
  EXPECT_EQ(rule.text, "completed");
  EXPECT_EQ(rule.reason, "why");
  EXPECT_TRUE(rule.ofProtocol);
}

TEST(ExclusionRules, SayWhichFieldIsWrong) {
  EXPECT_THAT(errorOfRule(R"({"test": "is", "value": "x", "reason": "y"})"), HasSubstr("\"what\" is missing"));
  EXPECT_THAT(errorOfRule(R"({"what": "ending", "test": "always", "value": "x", "reason": "y"})"),
              HasSubstr("\"test\" must be one of at_least, at_most, is, is_not"));
  EXPECT_THAT(errorOfRule(R"({"what": "ending", "test": "is", "value": true, "reason": "y"})"),
              HasSubstr("\"value\" must be a text or a number"));
  EXPECT_THAT(errorOfRule(R"({"what": "ending", "test": "is", "value": "x", "reason": "01234567890"})"),
              HasSubstr("\"reason\" must have 1 to 10 characters, not 11"));
}

}  // namespace
}  // namespace ocelli::test
