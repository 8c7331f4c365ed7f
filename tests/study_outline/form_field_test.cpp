#include "study/outline/form_field.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oc_core/base/json_fields.h"
#include "tests/study_outline/outline_text.h"

namespace ocelli::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const auto kRead = [](JsonFields& fields, ProtocolReading reading) {
  return readFormField(fields, defaultConditions(), reading);
};

TEST(FormFields, AreTheSameToBoth) {
  for (const ProtocolReading reading : kBothReadings) {
    const FormField field = readOutline(R"({"name": "easier", "question": "Which?", "options": ["1", "2"],
        "ends": ["this", "that"], "favors": ["gc", "ppc"]})",
                                        reading, kRead);
    EXPECT_EQ(field.name, "easier");
    EXPECT_EQ(field.question, "Which?");
    EXPECT_THAT(field.options, ElementsAre("1", "2"));
    EXPECT_THAT(field.ends, ElementsAre("this", "that"));
    EXPECT_THAT(field.favors, ElementsAre(TrialView::kOther, TrialView::kReference));
    EXPECT_THAT(outlineErrorOf(R"({"name": "a", "question": "?", "options": ["1", "2"], "favors": ["gc", "gc"]})",
                               reading, kRead),
                HasSubstr(R"(field "favors" must be ["ppc", "gc"] or ["gc", "ppc"])"));
  }
}

TEST(FormFields, AreStrictToAStudyAlone) {
  for (const char* text :
       {R"({"name": "A", "question": "?", "options": ["1", "2"]})", R"({"name": "a", "options": ["1", "2"]})",
        R"({"name": "a", "question": "?"})", R"({"name": "a", "question": "?", "options": ["1", "1"]})",
        R"({"name": "a", "question": "?", "options": ["1", "2"], "ends": ["x"]})"}) {
    EXPECT_NE(outlineErrorOf(text, ProtocolReading::kByStudy, kRead), "") << text;
    EXPECT_EQ(outlineErrorOf(text, ProtocolReading::kByAnalysis, kRead), "") << text;
  }
  const FormField open = readOutline(R"({"name": "a"})", ProtocolReading::kByAnalysis, kRead);
  EXPECT_EQ(open.question, "a");
  EXPECT_THAT(open.options, IsEmpty());
}

}  // namespace
}  // namespace ocelli::test
