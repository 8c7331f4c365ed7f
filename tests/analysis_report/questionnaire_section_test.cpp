// Scores of questionnaires by when they were asked, against values worked by hand from the published formulas.
#include "analysis/report/questionnaire_section.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "study/outline/question_kinds.h"
#include "tests/analysis_report/section_study.h"

namespace ocelli::test {
namespace {

using testing::HasSubstr;

constexpr const char* kProtocol = R"({"name": "made", "before": [{"questionnaire": "ssq"}],
  "blocks": [{"name": "find stationary", "task": "find", "after": [{"questionnaire": "sus"}]}],
  "after": [{"questionnaire": "mood"},
            {"name": "own", "title": "Own", "fields": [
              {"name": "age", "question": "How old?", "kind": "number"},
              {"name": "devices", "question": "With what?", "kind": "multiple", "required": false, "options": ["mouse", "keys"]},
              {"name": "rows", "question": "How?", "kind": "matrix", "options": ["bad", "good"], "values": [1, 2],
               "rows": [{"name": "a", "label": "Row A"}]}]}]})";

class QuestionnaireSection : public testing::Test {
 protected:
  QuestionnaireSection() { study_.analysis.data.sources[0].protocolText = kProtocol; }

  void answer(const std::string& subject, int session, const std::string& form, const std::string& field,
              const std::string& text) {
    FormAnswer given;
    given.answerId = static_cast<int64_t>(study_.analysis.data.answers.size()) + 1;
    given.subject = subject;
    given.session = session;
    given.form = form;
    given.field = field;
    given.answer = text;
    study_.analysis.data.answers.push_back(given);
  }
  /// SUS with these answers to its ten items.
  void answerSus(const std::string& subject, int session, const std::array<const char*, 10>& given) {
    const auto sus = findQuestionnaire("sus", "en");
    const std::vector<QuestionItem> items = itemsOf(sus->form.fields);
    for (size_t i = 0; i < items.size(); ++i) {
      answer(subject, session, "sus after find stationary", items[i].name, given[i]);
    }
  }
  ReportDocument document() { return documentOf(study_.analysis, addQuestionnaires); }

  SectionStudy study_{};
};

TEST_F(QuestionnaireSection, scoresHaveCountsMeansAndDeviations) {
  // 75, 100 and 50: see tests/study_outline/questionnaire_test.cpp.
  answerSus("S1", 1, {"4", "2", "5", "1", "3", "2", "4", "3", "4", "2"});
  answerSus("S2", 1, {"5", "1", "5", "1", "5", "1", "5", "1", "5", "1"});
  answerSus("S3", 1, {"3", "3", "3", "3", "3", "3", "3", "3", "3", "3"});
  const ReportDocument made = document();
  EXPECT_EQ(cellText(made, kScoresTable, "SUS", "Subjects"), "3");
  EXPECT_EQ(cellText(made, kScoresTable, "SUS", "Asked"), "after find stationary");
  EXPECT_EQ(cellValue(made, kScoresTable, "SUS", "Mean"), 75);
  EXPECT_EQ(cellValue(made, kScoresTable, "SUS", "SD"), 25) << "of 50, 75 and 100";
  EXPECT_EQ(cellValue(made, kScoresTable, "SUS", "Lowest"), 50);
  EXPECT_EQ(cellValue(made, kScoresTable, "SUS", "Highest"), 100);
}

TEST_F(QuestionnaireSection, aScoreWithAnOpenItemIsMissingAndNotZero) {
  answerSus("S1", 1, {"3", "3", "3", "3", "3", "3", "3", "3", "3", ""});
  answerSus("S2", 1, {"5", "1", "5", "1", "5", "1", "5", "1", "5", "1"});
  const ReportDocument made = document();
  EXPECT_EQ(cellText(made, kScoresTable, "SUS", "Subjects"), "1");
  EXPECT_EQ(cellText(made, kScoresTable, "SUS", "Open"), "1");
  EXPECT_EQ(cellValue(made, kScoresTable, "SUS", "Mean"), 100);
  EXPECT_EQ(cellText(made, kScoresTable, "SUS", "SD"), "-") << "of one";
}

TEST_F(QuestionnaireSection, sessionsAndViewsStandApart) {
  const std::array<const char*, 10> middle{"3", "3", "3", "3", "3", "3", "3", "3", "3", "3"};
  answerSus("S1", 1, middle);
  answerSus("S1", 2, middle);
  answerSus("S2", 1, middle);
  study_.add("S1", 1, TrialView::kReference, 10);
  study_.add("S1", 1, TrialView::kReference, 10);
  study_.add("S1", 2, TrialView::kOther, 10);
  study_.add("S2", 1, TrialView::kReference, 10);
  study_.add("S2", 1, TrialView::kOther, 10);
  std::map<std::pair<std::string, int>, std::optional<TrialView>> views;
  for (const SubjectScore& each : scoresOf(study_.analysis.data)) {
    views[{each.subject, each.session}] = each.view;
  }
  EXPECT_EQ((views[{"S1", 1}]), TrialView::kReference);
  EXPECT_EQ((views[{"S1", 2}]), TrialView::kOther);
  EXPECT_EQ((views[{"S2", 1}]), std::nullopt) << "both were seen";
  EXPECT_THAT(scoresCsv(study_.analysis.data), HasSubstr("sus after find stationary,sus,S1,2,gc,score,50\r\n"));
}

TEST_F(QuestionnaireSection, otherFormsAreDescribedByWhatTheyAsk) {
  for (const auto& [subject, age, devices] :
       {std::tuple("S1", "20", R"(["mouse"])"), std::tuple("S2", "30", R"(["mouse","keys"])"),
        std::tuple("S3", "70", "")}) {
    answer(subject, 1, "own after", "age", age);
    answer(subject, 1, "own after", "devices", devices);
    answer(subject, 1, "own after", "rows_a", "2");
  }
  const ReportDocument made = document();
  EXPECT_EQ(cellValue(made, "form-answers-1", "How old?", "Mean"), 40);
  EXPECT_EQ(cellValue(made, "form-answers-1", "How old?", "Median"), 30);
  EXPECT_EQ(cellText(made, "form-answers-1", "How old?", "Answers"), "20 to 70");
  EXPECT_EQ(cellText(made, "form-answers-1", "With what?", "Subjects"), "2") << "one left it open";
  EXPECT_EQ(cellText(made, "form-answers-1", "With what?", "Answers"), "\"keys\" (1), \"mouse\" (2)");
  EXPECT_EQ(cellText(made, "form-answers-1", "Row A", "Scale"), "1 to 2");
  EXPECT_EQ(cellValue(made, "form-answers-1", "Row A", "Mean"), 2);
}

TEST_F(QuestionnaireSection, saysSoWhereNothingWasAnswered) {
  EXPECT_FALSE(reasonsOf(document()).empty());
  EXPECT_TRUE(hasOtherForms(study_.analysis.data));
  study_.analysis.data.sources[0].protocolText = R"({"name": "made"})";
  EXPECT_FALSE(hasOtherForms(study_.analysis.data));
}

}  // namespace
}  // namespace ocelli::test
