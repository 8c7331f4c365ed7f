#include "analysis/report/survey_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/inference/holm.h"
#include "analysis/inference/ordinal.h"
#include "analysis/plot/rating_plot.h"

namespace ocelli {

void addSurveySection(ReportWork& work) {
  addHeading(work.document, 1, "What subjects say", "survey");
  // The last answer of each subject, as some are asked in every session.
  std::map<std::string, std::map<std::string, std::pair<int, int>>> fields;
  for (const FormAnswer& answer : work.analysis.data.answers) {
    const std::optional<double> number = answer.form == "survey" ? numberIn(answer.answer) : std::nullopt;
    if (number && *number >= 1 && *number <= 5 && *number == std::floor(*number)) {
      auto& last = fields[answer.field][answer.subject];
      if (answer.session >= last.first) {
        last = {answer.session, static_cast<int>(*number)};
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
    for (const auto& [subject, answer] : bySubject) {
      answers.push_back(answer.second);
      ++question.counts[static_cast<size_t>(answer.second - 1)];
    }
    plot.questions.push_back(question);
    const std::string source = fmt::format("last answers of {} subjects to {}", answers.size(), field);
    const Estimable<OrdinalDistribution> distribution = ordinalDistribution(answers);
    if (distribution) {
      Estimate mean;
      mean.value = distribution->mean;
      rows.push_back({fmt::format("{}: mean (1 ppc, 5 gc)", field), mean, "", source});
    }
    const Estimable<MiddleTest> test = testAgainstMiddle(answers);
    rows.push_back(
        {fmt::format("{}: center of answer - 3, signed ranks", field),
         test ? Estimable<Estimate>(test->signedRank.center) : Estimable<Estimate>::impossible(test.reason()), "",
         source});
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
