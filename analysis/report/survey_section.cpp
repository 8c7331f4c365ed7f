#include "analysis/report/survey_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/inference/holm.h"
#include "analysis/inference/ordinal.h"
#include "analysis/plot/rating_plot.h"

namespace ocelli {
namespace {

struct LastAnswer {
  int session = 0;
  int rating = 0;  ///< 1 to 5
  RowRef row{};
};

}  // namespace

void addSurveySection(ReportWork& work) {
  addHeading(work.document, 1, "What subjects say", "survey");
  // The last answer of each subject, as some are asked in every session.
  std::map<std::string, std::map<std::string, LastAnswer>> fields;
  for (const FormAnswer& answer : work.analysis.data.answers) {
    const std::optional<double> number = answer.form == "survey" ? numberIn(answer.answer) : std::nullopt;
    if (number && *number >= 1 && *number <= 5 && *number == std::floor(*number)) {
      LastAnswer& last = fields[answer.field][answer.subject];
      if (answer.session >= last.session) {
        last = {answer.session, static_cast<int>(*number), {answer.source, answer.answerId}};
      }
    }
  }
  if (fields.empty()) {
    addNotEstimable(work.document, "Survey", "there are no answers from 1 to 5 to a form \"survey\"");
    return;
  }
  RatingPlot plot;
  plot.title = "Which view was easier";
  std::vector<EstimateRow> rows;
  std::vector<double> pValues;
  for (const auto& [field, bySubject] : fields) {
    RatingPlot::Question question{field, {}};
    std::vector<int> answers;
    std::vector<RowRef> answerRows;
    for (const auto& [subject, last] : bySubject) {
      answers.push_back(last.rating);
      answerRows.push_back(last.row);
      ++question.counts[static_cast<size_t>(last.rating - 1)];
    }
    plot.questions.push_back(question);
    const std::string source = fmt::format("last answers of {} subjects to {}", answers.size(), field);
    const Estimable<OrdinalDistribution> distribution = ordinalDistribution(answers);
    if (distribution) {
      Estimate mean;
      mean.value = distribution->mean;
      rows.push_back({fmt::format("{}: mean (1 ppc, 5 gc)", field), mean, "", source, {}, answerRows});
    }
    const Estimable<MiddleTest> test = testAgainstMiddle(answers);
    rows.push_back(
        {fmt::format("{}: center of answer - 3, signed ranks", field),
         test ? Estimable<Estimate>(test->signedRank.center) : Estimable<Estimate>::impossible(test.reason()),
         "",
         source,
         {},
         answerRows});
    pValues.push_back(test ? test->signedRank.center.pValue : kNotKnown);
  }
  work.document.add(ReportFigure{plot.title, "figure-survey", ratingFigure(plot)});
  addEstimates(work.document, "Answers against the middle of the scale", "survey-answers", rows);
  // A model of the survey is one test: the smallest p value, corrected for the number of questions.
  double smallest = kNotKnown;
  for (const double p : holmAdjusted(pValues)) {
    smallest = std::fmin(smallest, p);
  }
  for (const PlannedModel& model : work.analysis.plan.models) {
    if (model.task == "survey") {
      work.outcomes.push_back({model.name, "",
                               std::isfinite(smallest) ? Estimable<double>(smallest)
                                                       : Estimable<double>::impossible("all answers are the middle")});
    }
  }
  work.methods.push_back(
      "Answers to the survey were tested against the middle of the scale by signed ranks; the p value "
      "of the survey is the smallest of its questions, corrected by Holm's method.");
}

}  // namespace ocelli
