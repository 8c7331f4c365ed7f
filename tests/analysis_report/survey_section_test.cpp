// What the report says of questions with scales of different lengths and meanings, and of answers that are on none.
#include "analysis/report/survey_section.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "analysis/report/study_report.h"
#include "oc_core/drawing/figure.h"
#include "tests/analysis_report/section_study.h"

namespace ocelli::test {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

class SurveySection : public testing::Test {
 protected:
  /// One question "q", answered by as many subjects.
  ReportDocument surveyOf(const std::string& field, const std::vector<std::string>& answers,
                          const std::vector<TrialView>& firstViews = {}) {
    study_ = SectionStudy();
    for (size_t i = 0; i < firstViews.size(); ++i) {
      // The second session tells nothing of what came first.
      study_.add(fmt::format("S{:02}", i), 2, TrialView::kReference, 10);
      study_.add(fmt::format("S{:02}", i), 1, firstViews[i], 10);
    }
    study_.analysis.data.sources[0].protocolText =
        field.empty() ? "" : fmt::format(R"({{"name": "made", "survey": {{"title": "S", "fields": [{}]}}}})", field);
    for (size_t i = 0; i < answers.size(); ++i) {
      FormAnswer answer;
      answer.answerId = static_cast<int64_t>(i) + 1;
      answer.subject = fmt::format("S{:02}", i);
      answer.form = "survey";
      answer.field = "q";
      answer.answer = answers[i];
      study_.analysis.data.answers.push_back(answer);
    }
    ReportDocument document;
    document.origins.sources = {"made.db"};
    ReportWork work{study_.analysis, document};
    const ReportTask task = reportTask("survey");
    task.parts.front().add(work, task);
    outcomes_ = work.outcomes;
    return document;
  }
  static std::vector<std::string> warningsOf(const ReportDocument& document) {
    std::vector<std::string> texts;
    for (const ReportElement& element : document.elements) {
      if (const auto* note = std::get_if<ReportNote>(&element); note != nullptr && note->kind == NoteKind::kWarning) {
        texts.push_back(note->text);
      }
    }
    return texts;
  }
  static std::string describedFigure(const ReportDocument& document) {
    for (const ReportElement& element : document.elements) {
      if (const auto* figure = std::get_if<ReportFigure>(&element)) {
        return figure->figure.description;
      }
    }
    return "no figure";
  }
  bool hasTest(const ReportDocument& document) const {
    EXPECT_EQ(outcomes_.size(), 1U) << "the model of the plan";
    const bool tested = outcomes_.at(0).pValue.isPossible();
    const bool hasTable = std::any_of(document.elements.begin(), document.elements.end(), [](const auto& element) {
      const auto* table = std::get_if<ReportTable>(&element);
      return table != nullptr && table->id == "survey-preference";
    });
    EXPECT_EQ(hasTable, tested);
    return tested;
  }

  SectionStudy study_;
  std::vector<TestOutcome> outcomes_{};
};

constexpr const char* kSeven = R"({"name": "q", "question": "Which view was easier?",
  "options": ["1", "2", "3", "4", "5", "6", "7"], "ends": ["this", "that"], "favors": ["ppc", "gc"]})";

TEST_F(SurveySection, sevenStepsAreTestedAgainstTheirOwnMiddle) {
  const ReportDocument document = surveyOf(kSeven, {"7", "7", "6", "6", "4", "5", "3", "7"});
  const std::string row = "Which view was easier?";
  EXPECT_EQ(cellValue(document, "survey-answers", row, "Mean"), 45.0 / 8) << "with all answers of 6 and 7";
  EXPECT_EQ(cellText(document, "survey-answers", row, "Subjects"), "8");
  EXPECT_EQ(cellText(document, "survey-answers", row, "Scale"), "1 (this) to 7 (that)");
  EXPECT_EQ(cellText(document, "survey-answers", row, "Answers"), "0 / 0 / 1 / 1 / 1 / 2 / 3");
  const std::string test = "Which view was easier? (1 (this) to 7 (that))";
  // Off the middle of 4: 3, 3, 2, 2, 0, 1, -1, 3. The median of the 36 means of pairs:
  EXPECT_EQ(cellValue(document, "survey-preference", test, "Estimate"), 1.75);
  EXPECT_TRUE(hasTest(document));
  EXPECT_THAT(describedFigure(document), HasSubstr("3 of 7; mean 5.62"));
  ASSERT_TRUE(outcomes_[0].effect);
  EXPECT_THAT(outcomes_[0].effect->measure, HasSubstr("steps from the middle of 7"));
  EXPECT_TRUE(warningsOf(document).empty());
}

TEST_F(SurveySection, theDirectionIsThatOfTheProtocol) {
  std::string reversed = kSeven;
  reversed.replace(reversed.find(R"(["ppc", "gc"])"), 13, R"(["gc", "ppc"])");
  const std::string row = "Which view was easier? (1 (this) to 7 (that))";
  const ReportDocument document = surveyOf(reversed, {"1", "2", "1", "3", "2", "1"});
  EXPECT_GT(cellValue(document, "survey-preference", row, "Estimate").value_or(0), 1.5) << "low answers are for gc";
}

TEST_F(SurveySection, fourStepsHaveNoMiddleAnswer) {
  const ReportDocument document =
      surveyOf(R"({"name": "q", "question": "Next time?", "options": ["plain, surely", "plain", "bent", "bent, surely"],
                  "favors": ["ppc", "gc"]})",
               {"bent", "bent", "bent, surely", "plain", "bent, surely", "bent"});
  const std::string row = "Next time? (1 (plain, surely) to 4 (bent, surely))";
  // Off the middle of 2.5: 0.5, 0.5, 1.5, -0.5, 1.5, 0.5.
  EXPECT_EQ(cellValue(document, "survey-preference", row, "Estimate"), 0.5);
  EXPECT_TRUE(hasTest(document));
}

TEST_F(SurveySection, scalesThatDoNotCompareTheViewsAreDescribed) {
  const ReportDocument document = surveyOf(
      R"({"name": "q", "question": "How tired?", "options": ["1", "2", "3", "4", "5", "6", "7"], "ends": ["not", "very"]})",
      {"6", "7", "7", "5"});
  EXPECT_EQ(cellValue(document, "survey-answers", "How tired?", "Mean"), 6.25);
  EXPECT_FALSE(hasTest(document));
  EXPECT_THAT(outcomes_[0].pValue.reason(), HasSubstr("no question of the survey compares the views"));
}

TEST_F(SurveySection, unlabelledNumbersAreAScaleThatSaysNothingOfTheViews) {
  const ReportDocument document =
      surveyOf(R"({"name": "q", "question": "?", "options": ["0", "25", "50", "75", "100"]})", {"75", "100"});
  EXPECT_EQ(cellValue(document, "survey-answers", "?", "Mean"), 87.5);
  EXPECT_FALSE(hasTest(document));
}

TEST_F(SurveySection, choicesAndFreeTextAreCounted) {
  const ReportDocument choices =
      surveyOf(R"({"name": "q", "question": "Lenses?", "options": ["no", "yes", "glasses"]})", {"yes", "no", "yes"});
  EXPECT_EQ(cellText(choices, "survey-answers", "Lenses?", "Answers"), "\"no\" (1), \"yes\" (2)");
  EXPECT_EQ(cellText(choices, "survey-answers", "Lenses?", "Mean"), "-");
  EXPECT_FALSE(hasFigure(choices, "figure-survey"));
  const ReportDocument text = surveyOf(R"({"name": "q", "question": "What else?"})", {"I am Ada L.", "nothing", "4"});
  EXPECT_EQ(cellText(text, "survey-answers", "What else?", "Answers"), "3 different") << "no subject is quoted";
  EXPECT_EQ(cellText(text, "survey-answers", "What else?", "Mean"), "-");
  EXPECT_FALSE(hasTest(text));
}

TEST_F(SurveySection, answersThatAreNoOptionsAreNamedAndInNoNumber) {
  const ReportDocument document =
      surveyOf(R"({"name": "q", "question": "?", "options": ["1", "2", "3", "4", "5"], "favors": ["ppc", "gc"]})",
               {"6", "7", "7", "5", "4", "x"});
  EXPECT_THAT(warningsOf(document),
              Contains(HasSubstr("4 of 6 subjects gave answers that are not among its options, 1, 2, 3, 4, 5")));
  EXPECT_THAT(warningsOf(document), Contains(HasSubstr("\"6\" (1), \"7\" (2), \"x\" (1)")));
  EXPECT_EQ(cellText(document, "survey-answers", "?", "Subjects"), "2");
  EXPECT_EQ(cellValue(document, "survey-answers", "?", "Mean"), 4.5);
}

TEST_F(SurveySection, withoutAProtocolAScaleIsNotGuessed) {
  const ReportDocument document = surveyOf("", {"6", "7", "2"});
  EXPECT_THAT(warningsOf(document), Contains(HasSubstr("The scale of q is not known")));
  EXPECT_EQ(cellText(document, "survey-answers", "q", "Answers"), "\"2\" (1), \"6\" (1), \"7\" (1)");
  EXPECT_EQ(cellText(document, "survey-answers", "q", "Mean"), "-");
  EXPECT_FALSE(hasTest(document));
}

TEST_F(SurveySection, oldProtocolsAreTakenByTheirWords) {
  const ReportDocument document = surveyOf(R"({"name": "q", "question": "?", "options": ["1", "2", "3", "4", "5"],
                  "ends": ["plain view easier", "bent view easier"]})",
                                           {"5", "4", "5", "5"});
  EXPECT_TRUE(hasTest(document));
  std::string notes;
  for (const ReportElement& element : document.elements) {
    if (const auto* note = std::get_if<ReportNote>(&element)) {
      notes += note->text;
    }
  }
  EXPECT_THAT(notes, HasSubstr("taken from their words"));
}

TEST_F(SurveySection, tablesOfAnswersHaveTheirScale) {
  surveyOf(kSeven, {"6", "9"});
  ReportDocument none;
  std::string answers;
  for (const ReportFile& file : tableFiles(study_.analysis, none, {}, true)) {
    answers = file.name == "tables/answers.csv" ? file.bytes : answers;
  }
  EXPECT_THAT(answers, HasSubstr(",question,option,options,last_favors\r\n"));
  EXPECT_THAT(answers, HasSubstr("survey,q,6,Which view was easier?,6,7,gc\r\n"));
  EXPECT_THAT(answers, HasSubstr("survey,q,9,Which view was easier?,,7,gc\r\n"));
}

TEST_F(SurveySection, asksWhetherAnswersGoWithTheFirstView) {
  const char* const kField = R"({"name": "q", "question": "Which?", "options": ["a", "b"], "ends": ["x", "y"],
    "favors": ["ppc", "gc"]})";
  const TrialView ppc = TrialView::kReference;
  const TrialView gc = TrialView::kOther;
  const std::vector<std::string> answers{"a", "a", "a", "b", "a", "b", "b", "b"};
  // Odds of "b" are 1 to 3 where the reference came first, and 3 to 1 where the other did.
  const ReportDocument document = surveyOf(kField, answers, {ppc, ppc, ppc, ppc, gc, gc, gc, gc});
  const auto ratio = cellValue(document, "survey-first-view", "Which? (gc first / ppc first)", "Estimate");
  ASSERT_TRUE(ratio);
  EXPECT_NEAR(*ratio, 9, 1e-4);  // where the search for the maximum ends
  EXPECT_THAT(reasonsOf(surveyOf(kField, answers, {gc, gc, gc, gc, gc, gc, gc, gc})),
              Contains(HasSubstr("(gc first / ppc first): all subjects who answered began with the same view.")));
  EXPECT_THAT(reasonsOf(surveyOf(kField, answers)), Contains(HasSubstr("no subject with an answer has a trial")));
}

TEST(SurveyOfThreeConditions, LooksAtTheTwoThatAQuestionCompares) {
  SectionStudy study;
  study.analysis.data.conditions = {{{"a", "view a"}, {"b", "view b"}, {"c", "view c"}}};
  study.analysis.data.sources[0].protocolText =
      R"({"name": "made", "conditions": [{"name": "a", "label": "view a"}, {"name": "b", "label": "view b"},
          {"name": "c", "label": "view c"}], "survey": {"title": "S", "fields": [{"name": "q", "question": "Easier?",
          "options": ["1", "2", "3", "4", "5"], "ends": ["this", "that"], "favors": ["c", "a"]}]}})";
  // All begin with b, which the question does not compare; then half see a before c. These answer for a, the last
  // option, by one step more.
  for (int i = 0; i < 12; ++i) {
    const std::string subject = fmt::format("S{:02}", i);
    const bool aFirst = i % 2 == 0;
    study.add(subject, 1, conditionAt(1), 10);
    study.add(subject, 1, conditionAt(aFirst ? 0 : 2), 10);
    study.add(subject, 1, conditionAt(aFirst ? 2 : 0), 10);
    FormAnswer answer;
    answer.answerId = i + 1;
    answer.subject = subject;
    answer.form = "survey";
    answer.field = "q";
    answer.answer = std::to_string((aFirst ? 3 : 2) + (i % 3 == 0 ? 1 : 0) + (i % 4 < 2 ? 1 : 0));
    study.analysis.data.answers.push_back(answer);
  }
  const ReportDocument document = documentOf(study.analysis, [](ReportWork& work) {
    const ReportTask task = reportTask("survey");
    task.parts.front().add(work, task);
  });
  const std::string order = "Easier? (view a first / view c first)";
  EXPECT_GT(cellValue(document, "survey-first-view", order, "Estimate").value_or(0), 1.0)
      << "which would not be known by the first view of all, which is b for everyone";
  const std::string test = "Easier? (1 (this) to 5 (that)), towards view a";
  EXPECT_GT(cellValue(document, "survey-preference", test, "Estimate").value_or(-1), 0.0)
      << "as they are: the last option is for a, although a comes first in the protocol";
}

}  // namespace
}  // namespace ocelli::test
