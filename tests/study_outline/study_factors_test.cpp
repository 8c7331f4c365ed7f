#include "study/outline/study_factors.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oc_core/base/json_fields.h"
#include "study/outline/condition_names.h"
#include "tests/study_outline/outline_text.h"

namespace ocelli::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string kFactors = R"("factors": [{"name": "camera", "levels": ["pinhole", "graph"]},
  {"name": "height", "levels": ["low", "high"]}, {"name": "size", "levels": ["small", "large"], "of": "cases"}])";

std::string condition(const std::string& name, const std::string& camera, const std::string& height) {
  return R"({"name": ")" + name + R"(", "factors": {"camera": ")" + camera + R"(", "height": ")" + height + "\"}}";
}

std::string textOf(const std::string& conditions, const std::string& factors = kFactors) {
  return "{" + factors + ",\n\"conditions\": [" + conditions + "]}";
}

std::string errorOf(const std::string& text) {
  try {
    conditionNamesOf(text, "study.json");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(StudyFactors, DescribeConditions) {
  const ViewConditions conditions =
      conditionNamesOf(textOf(condition("a", "pinhole", "low") + "," + condition("b", "graph", "low")), "study.json");
  ASSERT_EQ(conditions.factors.size(), 3u);
  EXPECT_TRUE(conditions.factors[2].ofCases);
  EXPECT_THAT(conditions.factors[1].levels, ElementsAre("low", "high"));
  EXPECT_EQ(conditions.list[1].levels, (FactorLevels{{"camera", "graph"}, {"height", "low"}}));
  EXPECT_EQ(factorsOf(conditions, FactorsOf::kCases).size(), 1u);
}

TEST(StudyFactors, TellWhichCellsAreMissingOrDoubled) {
  const auto crossing = [](const std::string& conditions) {
    return crossingOf(conditionNamesOf(textOf(conditions), "study.json"));
  };
  const std::string three =
      condition("a", "pinhole", "low") + "," + condition("b", "graph", "low") + "," + condition("c", "graph", "high");
  EXPECT_THAT(crossing(three).missing, ElementsAre("pinhole, high"));
  EXPECT_THAT(crossing(three).doubled, IsEmpty());
  const FactorCrossing more =
      crossing(three + "," + condition("d", "pinhole", "high") + "," + condition("e", "pinhole", "high"));
  EXPECT_THAT(more.missing, IsEmpty());
  EXPECT_THAT(more.doubled, ElementsAre("pinhole, high (d, e)"));
  EXPECT_THAT(crossingOf(defaultConditions()).missing, IsEmpty()) << "no factors";
}

TEST(StudyFactors, HaveALevelOfEachInEachCondition) {
  EXPECT_THAT(errorOf(textOf(condition("a", "fish", "low"))),
              HasSubstr("study.json:3, \"conditions\" 1, \"factors\": field \"camera\" must be one of pinhole, graph"));
  EXPECT_THAT(errorOf(textOf(R"({"name": "a"})")), HasSubstr("field \"factors\" is missing"));
  EXPECT_THAT(errorOf(textOf(R"({"name": "a", "factors": {"camera": "graph"}})")),
              HasSubstr("field \"height\" is missing"));
  const std::string ofCases =
      textOf(R"({"name": "a", "factors": {"camera": "graph", "height": "low", "size": "small"}})");
  EXPECT_THAT(outlineErrorOf(ofCases, ProtocolReading::kByStudy,
                             [](JsonFields& fields, ProtocolReading) {
                               readConditionNames(fields, [](JsonFields&, TrialView) {});
                             }),
              HasSubstr("field \"size\" is unknown"))
      << "which is of cases";
  EXPECT_THAT(errorOf(textOf(R"({"name": "a", "factors": {}})", R"("comment": "none")")), testing::Eq(""));
  EXPECT_THAT(errorOf("{" + kFactors + "}"), HasSubstr("the field \"conditions\" is missing"));
}

TEST(StudyFactors, AreDeclaredWell) {
  const auto error = [](const std::string& factor) {
    return errorOf(R"({"factors": [{"name": "ok", "levels": ["a", "b"], "of": "cases"}, )" + factor + "]}");
  };
  EXPECT_EQ(error(R"({"name": "size", "levels": ["a", "b"], "of": "cases"})"), "");
  EXPECT_THAT(error(R"({"name": "ok", "levels": ["a", "b"]})"), HasSubstr("as that of an earlier factor"));
  EXPECT_THAT(error(R"({"name": "Size", "levels": ["a", "b"]})"), HasSubstr("small letters"));
  EXPECT_THAT(error(R"({"name": "session", "levels": ["a", "b"]})"), HasSubstr("use for something else"));
  EXPECT_THAT(error(R"({"name": "size", "levels": ["a", "a"]})"), HasSubstr("different from each other"));
  EXPECT_THAT(error(R"({"name": "size", "levels": ["a"]})"), HasSubstr("an array of 2 to 16 texts"));
  EXPECT_THAT(error(R"({"name": "size", "levels": ["a", "b"], "of": "rooms"})"), HasSubstr("conditions, cases"));
}

}  // namespace
}  // namespace ocelli::test
