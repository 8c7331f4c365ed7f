#include "study/trial/view_condition.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/dataset/database.h"
#include "analysis/dataset/merge.h"
#include "analysis/dataset/protocol_facts.h"
#include "tests/analysis_dataset/sample_study.h"

namespace ocelli::test {
namespace {

using ::testing::HasSubstr;

std::string protocolOfConditions(const std::string& conditions) {
  return R"({"name": "a", "sessions": 1, "conditions": )" + conditions + "}";
}

const std::string kFlatAndBent =
    protocolOfConditions(R"([{"name": "flat", "label": "flat view", "view": {}}, {"name": "bent", "view": "any"}])");

std::string errorOfConditions(const std::string& conditions) {
  return analysisErrorOf([&] { protocolFacts(protocolOfConditions(conditions), "p.json"); });
}

TEST(ViewConditions, areThoseOfTheProtocol) {
  const auto conditions = protocolFacts(kFlatAndBent, "p.json").conditions;
  EXPECT_EQ(conditions.nameOf(TrialView::kReference), "flat");
  EXPECT_EQ(conditions.labelOf(TrialView::kReference), "flat view");
  EXPECT_EQ(conditions.labelOf(TrialView::kOther), "bent") << "a name where there is no label";
  EXPECT_EQ(conditions.viewNamed("bent"), TrialView::kOther);
  EXPECT_FALSE(conditions.viewNamed("gc"));
  EXPECT_EQ(protocolFacts(R"({"name": "a"})", "p.json").conditions, defaultConditions());
}

TEST(ViewConditions, haveNamesOfTheirOwn) {
  for (const char* wrong : {"{}", "[]", "3"}) {
    EXPECT_THAT(errorOfConditions(wrong), HasSubstr("must be a list of 1 to 16 conditions")) << wrong;
  }
  EXPECT_THAT(errorOfConditions(R"([{"name": "a"}, {"name": "a"}])"), HasSubstr("is that of the other condition too"));
  EXPECT_THAT(errorOfConditions(R"([{"name": "a"}, {"name": "b", "label": "a"}])"),
              HasSubstr("field \"label\" is that of"));
  EXPECT_THAT(errorOfConditions(R"([{"name": "a b"}, {"name": "c"}])"), HasSubstr("must be letters, digits"));
  EXPECT_THAT(errorOfConditions(R"([{"label": "a"}, {"name": "c"}])"), HasSubstr("name"));
  EXPECT_THAT(analysisErrorOf([] { protocolFacts("{\"name\": \"a\",\n\"sessions\": 0}", "p.json"); }),
              HasSubstr("p.json:2: field \"sessions\" must lie between 1 and 1000"));
  EXPECT_THAT(
      analysisErrorOf([] { protocolFacts("{\"name\": \"a\", \"blocks\": [\n{\"task\": \"find\"}]}", "p.json"); }),
      HasSubstr("p.json:2, \"blocks\" 1: field \"name\" is missing"));
}

TEST(ViewConditions, areWhatScalesSpeakFor) {
  const auto favored = [](const char* favors) {
    const std::string form =
        R"(], "survey": {"fields": [{"name": "q", "options": ["1", "2"], "ends": ["plain", "bent"])";
    std::string text = kFlatAndBent;
    text.replace(text.rfind(']'), 1, form + favors + "}]}");
    return protocolFacts(text, "p.json").items.at(0).lastFavors;
  };
  EXPECT_EQ(favored(R"(, "favors": ["bent", "flat"])"), TrialView::kReference);
  EXPECT_EQ(favored(""), std::nullopt) << "words stand for the two of old protocols alone";
  EXPECT_THAT(analysisErrorOf([&] { favored(R"(, "favors": ["ppc", "gc"])"); }),
              HasSubstr(R"(must be ["flat", "bent"] or ["bent", "flat"])"));
}

struct ConditionsOfData : testing::Test {
  SampleFolder folder;

  std::string study(const std::string& name, const std::string& protocol, const std::string& view) const {
    const std::string path = folder.file(name);
    SampleStudy made(path, protocol);
    made.addSubject(name == "a.db" ? "S01" : "S02");
    made.addSession(name == "a.db" ? "S01" : "S02", 1);
    SampleTrial trial;
    trial.subject = name == "a.db" ? "S01" : "S02";
    trial.view = view;
    made.addTrial(trial);
    return path;
  }
};

TEST_F(ConditionsOfData, viewsOfTrialsAreAmongThem) {
  EXPECT_EQ(readDatabase(study("a.db", kFlatAndBent, "bent")).trials.at(0).view, TrialView::kOther);
  EXPECT_THAT(analysisErrorOf([&] { readDatabase(study("b.db", kFlatAndBent, "gc")); }),
              HasSubstr("\"gc\", but must be flat or bent"));
}

TEST_F(ConditionsOfData, studiesOfOtherConditionsDoNotMix) {
  const std::string a = study("a.db", kFlatAndBent, "bent");
  const std::string b = study("b.db", kSampleProtocol, "gc");
  DatasetMergeOptions options;
  options.allowOtherProtocols = true;
  const std::string error = analysisErrorOf([&] { merge({readDatabase(a), readDatabase(b)}, options); });
  EXPECT_THAT(error, HasSubstr("different view conditions: flat with bent, and ppc with gc"));
  EXPECT_THAT(error, HasSubstr("b.db"));
  EXPECT_EQ(merge({readDatabase(a)}).conditions.nameOf(TrialView::kOther), "bent");
}

}  // namespace
}  // namespace ocelli::test
