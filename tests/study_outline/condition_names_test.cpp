#include "study/outline/condition_names.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oc_core/base/json_fields.h"
#include "tests/study_outline/outline_text.h"

namespace ocelli::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr const char* kConditions =
    R"({"conditions": [{"name": "flat", "view": "x"}, {"name": "bent", "label": "bent one", "view": "y"}]})";

TEST(ConditionNames, AreReadWithWhatStandsBesideThem) {
  std::vector<std::string> views;
  const auto read = [&](JsonFields& protocol, ProtocolReading) {
    return readConditionNames(protocol, [&](JsonFields& each, TrialView view) {
      EXPECT_EQ(view, kViews[views.size()]);
      views.push_back(each.text("view"));
    });
  };
  const ViewConditions conditions = readOutline(kConditions, ProtocolReading::kByStudy, read);
  EXPECT_EQ(conditions.labelOf(TrialView::kReference), "flat") << "the name";
  EXPECT_EQ(conditions.labelOf(TrialView::kOther), "bent one");
  EXPECT_THAT(views, ElementsAre("x", "y"));
  EXPECT_EQ(readOutline("{}", ProtocolReading::kByStudy, read), defaultConditions());
  EXPECT_EQ(conditionNamesOf(kConditions, "study.db"), conditions) << "whatever else they have";
}

TEST(ConditionNames, AreOneToSixteenAndDifferent) {
  const auto error = [](const std::string& list) {
    try {
      conditionNamesOf("{\n\"conditions\":\n" + list + "}", "study.db");
    } catch (const InputError& wrong) {
      return std::string(wrong.what());
    }
    return std::string();
  };
  EXPECT_THAT(error("[]"), HasSubstr("study.db:2: field \"conditions\" must be a list of 1 to 16 conditions"));
  EXPECT_EQ(error(R"([{"name": "a"}])"), "");
  EXPECT_THAT(error("[{\"name\": \"a\"},\n{\"name\": \"b\"}, {\"name\": \"b\"}]"),
              HasSubstr("study.db:4, \"conditions\" 3: field \"name\" is that of an earlier condition too"));
  EXPECT_THAT(error("[{\"name\": \"a\"},\n{\"name\": \"a\"}]"),
              HasSubstr("study.db:4, \"conditions\" 2: field \"name\" is that of the other condition too"));
  EXPECT_THAT(error(R"([{"name": "a"}, {"name": "b", "label": ""}])"), HasSubstr("must have 1 to 100 characters"));
}

}  // namespace
}  // namespace ocelli::test
