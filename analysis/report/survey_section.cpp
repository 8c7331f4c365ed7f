#include "analysis/report/survey_section.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "analysis/dataset/form_item.h"
#include "analysis/inference/holm.h"
#include "analysis/inference/ordinal.h"
#include "analysis/inference/proportional_odds.h"
#include "analysis/plot/rating_plot.h"
#include "analysis/report/part_guard.h"

namespace ocelli {
namespace {

constexpr const char* kForm = "survey";
constexpr size_t kMaxListed = 20;   ///< different answers to a question without a scale
constexpr size_t kMaxAnswer = 200;  ///< bytes of an answer that are listed

std::vector<RowRef> rowsOf(const ItemAnswers& item) {
  std::vector<RowRef> rows;
  for (const ItemAnswers::Answer& answer : item.answers) {
    rows.push_back({answer.row->source, answer.row->answerId});
  }
  return rows;
}

std::vector<int> placesOf(const ItemAnswers& item) {
  std::vector<int> places;
  for (const ItemAnswers::Answer& answer : item.answers) {
    places.push_back(answer.place);
  }
  return places;
}

/// An answer as a table can hold it; a longer one ends with its length.
std::string shortAnswer(const std::string& answer) {
  if (answer.size() <= kMaxAnswer) {
    return answer;
  }
  const auto continuesCharacter = [&](size_t at) { return (static_cast<unsigned char>(answer[at]) & 0xC0U) == 0x80U; };
  size_t end = kMaxAnswer;
  while (end > 0 && continuesCharacter(end)) {
    --end;
  }
  return fmt::format("{}... [{} bytes]", answer.substr(0, end), answer.size());
}

/// "\"6\" (2), \"7\" (1)".
std::string answerCounts(const std::map<std::string, int>& counts) {
  std::vector<std::string> parts;
  for (const auto& [answer, count] : counts) {
    parts.push_back(fmt::format("\"{}\" ({})", shortAnswer(answer), count));
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

/// Answers that are none of the options, and questions that nothing is known of.
void addCautions(ReportWork& work, const std::vector<ItemAnswers>& items) {
  std::vector<std::string> unknown;
  std::vector<std::string> byWords;
  for (const ItemAnswers& each : items) {
    const FormItem& item = each.item;
    if (!each.notOptions.empty()) {
      std::map<std::string, int> counts;
      for (const FormAnswer* row : each.notOptions) {
        ++counts[row->answer];
      }
      work.document.add(ReportNote{
          NoteKind::kWarning,
          fmt::format(
              "Question \"{}\" ({}): {} of {} subjects gave answers that are not among its options, {}. They are "
              "in no number of it: {}.",
              item.label(), item.name, each.notOptions.size(), each.notOptions.size() + each.answers.size(),
              fmt::join(item.options, ", "), answerCounts(counts))});
    }
    if (!item.isInProtocol()) {
      unknown.push_back(item.name);
    } else if (item.favorsFromWords) {
      byWords.push_back(fmt::format("\"{}\"", item.label()));
    }
  }
  if (!unknown.empty()) {
    work.document.add(ReportNote{
        NoteKind::kWarning,
        fmt::format(
            "The scale of {} is not known, as no protocol here has the question: answers are counted, and neither "
            "averaged nor tested. For exported tables --protocol FILE gives it.",
            fmt::join(unknown, ", "))});
  }
  if (!byWords.empty()) {
    work.document.add(ReportNote{
        NoteKind::kNote, fmt::format("The protocol does not say which view the ends of these scales speak for (field "
                                     "\"favors\"): it was taken from their words. {}.",
                                     fmt::join(byWords, ", "))});
  }
}

/// Questions with the same scale stand in one figure.
void addFigures(ReportWork& work, const std::vector<ItemAnswers>& items) {
  std::set<const ItemAnswers*> drawn;
  int figures = 0;
  for (const ItemAnswers& first : items) {
    const FormItem& scale = first.item;
    if (!scale.isScale() || first.answers.empty() || drawn.contains(&first)) {
      continue;
    }
    RatingPlot plot;
    plot.title = scale.comparesViews() ? "Answers that compare the views" : "Answers on a scale";
    plot.parted = scale.comparesViews();
    plot.lowest = scale.ends.size() == 2 ? scale.ends.front() : "";
    plot.highest = scale.ends.size() == 2 ? scale.ends.back() : "";
    plot.lastIsOther = scale.lastFavors == TrialView::kOther;
    plot.steps.clear();
    for (int place = 1; place <= scale.steps(); ++place) {
      const std::string& option = scale.options[static_cast<size_t>(place - 1)];
      plot.steps.push_back(option.size() <= 3 ? option : std::to_string(place));
    }
    for (const ItemAnswers& other : items) {
      if (other.answers.empty() || other.item.options != scale.options || other.item.ends != scale.ends ||
          other.item.lastFavors != scale.lastFavors) {
        continue;
      }
      drawn.insert(&other);
      RatingPlot::Question question{other.item.label(), std::vector<size_t>(scale.options.size())};
      double sum = 0;
      for (const ItemAnswers::Answer& answer : other.answers) {
        ++question.counts[static_cast<size_t>(answer.place - 1)];
        sum += scale.numberAt(answer.place);
      }
      question.mean = sum / static_cast<double>(other.answers.size());
      plot.questions.push_back(std::move(question));
    }
    addFigure(work, fmt::format("{}, {}; the last answer of each subject", plot.title, scale.scaleText()),
              ++figures == 1 ? std::string("figure-survey") : fmt::format("figure-survey-{}", figures),
              [&] { return ratingFigure(plot); });
  }
}

/// Each question on its own scale: how many answered, what on average, and what most.
void addDescriptions(ReportWork& work, const std::vector<ItemAnswers>& items) {
  const char* id = "survey-answers";
  ReportTable table{
      "Answers to the survey, each question on its own scale; the last answer of each subject",
      id,
      {{"Question", "", true}, {"Scale", "", true}, {"Subjects"}, {"Mean"}, {"Median"}, {"Answers", "", true}},
      {}};
  OriginTable origins(work.document.origins, id, table.caption, {"subjects", "mean", "median"});
  for (const ItemAnswers& each : items) {
    const FormItem& item = each.item;
    double mean = kNotKnown;
    double median = kNotKnown;
    std::string counts;
    if (item.isScale() && !each.answers.empty()) {
      const OrdinalDistribution distribution = *ordinalDistribution(placesOf(each), item.steps());
      mean = item.numberAt(distribution.mean);
      median = item.numberAt(distribution.median);
      counts = fmt::format("{}", fmt::join(distribution.counts, " / "));
    } else {
      std::map<std::string, int> given;
      for (const ItemAnswers::Answer& answer : each.answers) {
        ++given[answer.row->answer];
      }
      const bool anyText = item.isInProtocol() && item.options.empty();  // in a subject's own words
      counts = anyText || given.size() > kMaxListed ? fmt::format("{} different", given.size()) : answerCounts(given);
    }
    const auto subjects = static_cast<double>(each.answers.size());
    const std::string meaning = fmt::format("last answers of {} subjects to {}", each.answers.size(), item.name);
    const std::string origin =
        origins.addRow(item.name, meaning, {rowsOf(each), Cell::From::kAnswers}, "", {subjects, mean, median});
    const std::string source = origins.sourceText(meaning);
    const auto cell = [&](const std::string& text, const char* column, double value) {
      ReportCell result{text, origin.empty() ? "" : fmt::format("{}/{}", origin, column), source};
      if (std::isfinite(value)) {
        result.value = value;
      }
      return result;
    };
    ReportCell question{item.label()};
    question.shortName = item.isInProtocol() ? item.name : "";
    table.rows.push_back({question,
                          ReportCell{!item.isInProtocol()   ? std::string("not known")
                                     : item.isScale()       ? item.scaleText()
                                     : item.options.empty() ? std::string("any text")
                                                            : std::string("choices without an order")},
                          cell(std::to_string(each.answers.size()), "subjects", subjects),
                          cell(std::isfinite(mean) ? fixedText(mean, 2) : "-", "mean", mean),
                          cell(std::isfinite(median) ? fixedText(median, 1) : "-", "median", median),
                          ReportCell{counts}});
  }
  work.document.add(table);
  origins.finish();
}

/// What a question that compares the views says of them.
struct PreferenceTest {
  Estimable<Estimate> shift;  ///< towards the other condition, in steps
  std::string measure;
};

/// The two conditions that a question compares, for readers: of a pair @reference@ and @other@, or else those of the
/// first and the last option.
struct ComparedWords {
  std::string from;
  std::string towards;
};

ComparedWords comparedBy(const ReportWork& work, const FormItem& item) {
  const ViewConditions& conditions = work.analysis.data.conditions;
  return conditions.isPair() || !item.firstFavors || !item.lastFavors
             ? ComparedWords{kReferenceMark, kOtherMark}
             : ComparedWords{conditions.labelOf(*item.firstFavors), conditions.labelOf(*item.lastFavors)};
}

/// The places of answers as if the last option of the scale spoke for the other condition; of other numbers of
/// conditions than two, as they are.
std::vector<int> placesTowardsOther(const ReportWork& work, const ItemAnswers& each) {
  std::vector<int> places = placesOf(each);
  if (work.analysis.data.conditions.isPair() && each.item.lastFavors == TrialView::kReference) {
    for (int& place : places) {
      place = each.item.steps() + 1 - place;
    }
  }
  return places;
}

PreferenceTest testPreference(const ReportWork& work, const ItemAnswers& each) {
  const FormItem& item = each.item;
  const std::vector<int> places = placesTowardsOther(work, each);
  const Estimable<MiddleTest> test = testAgainstMiddle(places, item.steps());
  return {test ? Estimable<Estimate>(test->signedRank.center) : Estimable<Estimate>::impossible(test.reason()),
          fmt::format("\"{}\": steps from the middle of {} towards {}", item.label(), item.steps(),
                      comparedBy(work, item).towards)};
}

/// The model of the survey is one test: the smallest p value, corrected for the number of questions.
void addOutcome(ReportWork& work, const std::vector<PreferenceTest>& tests) {
  std::vector<double> pValues;
  for (const PreferenceTest& test : tests) {
    pValues.push_back(test.shift ? test.shift->pValue : kNotKnown);
  }
  const std::vector<double> adjusted = holmAdjusted(pValues);
  std::optional<size_t> smallest;
  for (size_t i = 0; i < adjusted.size(); ++i) {
    if (std::isfinite(adjusted[i]) && (!smallest || adjusted[i] < adjusted[*smallest])) {
      smallest = i;
    }
  }
  for (const PlannedModel& model : work.analysis.plan.models) {
    if (model.task != kForm) {
      continue;
    }
    TestOutcome outcome{
        model.name, "",
        Estimable<double>::impossible(tests.empty() ? "no question of the survey compares the views, as far "
                                                      "as the protocol tells"
                                                    : "all answers are the middle")};
    if (smallest) {
      outcome.pValue = adjusted[*smallest];
      outcome.effect = TestedEffect{tests[*smallest].measure, *tests[*smallest].shift};
    }
    work.outcomes.push_back(outcome);
  }
}

void addPreferences(ReportWork& work, const std::vector<ItemAnswers>& items) {
  const bool isPair = work.analysis.data.conditions.isPair();
  std::vector<EstimateRow> rows;
  std::vector<PreferenceTest> tests;
  for (const ItemAnswers& each : items) {
    if (each.item.comparesViews() && !each.answers.empty()) {
      tests.push_back(testPreference(work, each));
      rows.push_back({isPair ? fmt::format("{} ({})", each.item.label(), each.item.scaleText())
                             : fmt::format("{} ({}), towards {}", each.item.label(), each.item.scaleText(),
                                           comparedBy(work, each.item).towards),
                      tests.back().shift,
                      "steps",
                      fmt::format("last answers of {} subjects to {}", each.answers.size(), each.item.name),
                      {},
                      rowsOf(each)});
    }
  }
  if (!rows.empty()) {
    addEstimates(
        work.document,
        fmt::format("Which view the answers speak for: steps from the middle of each scale, above 0 towards {} "
                    "(Hodges-Lehmann center, Wilcoxon's signed ranks)",
                    isPair ? kOtherMark : "the view that the last option speaks for"),
        kSurveyTestsTable, rows);
  }
  addOutcome(work, tests);
}

/// Which of the views that the question compares each subject saw first.
std::map<std::string, TrialView> firstViews(const Dataset& data, const FormItem& item) {
  std::map<std::string, const Trial*> first;
  for (const Trial& trial : data.trials) {
    if (!data.conditions.isPair() && item.firstFavors != trial.view && item.lastFavors != trial.view) {
      continue;
    }
    const Trial*& known = first[trial.subject];
    if (known == nullptr || std::pair(trial.session, trial.planIndex) < std::pair(known->session, known->planIndex)) {
      known = &trial;
    }
  }
  std::map<std::string, TrialView> views;
  for (const auto& [subject, trial] : first) {
    views[subject] = trial->view;
  }
  return views;
}

/// Whether answers go with the view that came first.
void addOrder(ReportWork& work, const std::vector<ItemAnswers>& items) {
  const bool isPair = work.analysis.data.conditions.isPair();
  std::vector<EstimateRow> rows;
  for (const ItemAnswers& each : items) {
    if (!each.item.comparesViews() || each.answers.empty()) {
      continue;
    }
    const std::map<std::string, TrialView> began = firstViews(work.analysis.data, each.item);
    const TrialView other = isPair ? TrialView::kOther : *each.item.lastFavors;
    const ComparedWords words = comparedBy(work, each.item);
    const std::vector<int> all = placesTowardsOther(work, each);
    std::vector<int> places;
    Covariate otherFirst{"other view first", {}};
    std::vector<RowRef> answers;
    for (size_t i = 0; i < all.size(); ++i) {
      const FormAnswer& row = *each.answers[i].row;
      if (const auto found = began.find(row.subject); found != began.end()) {
        places.push_back(all[i]);
        otherFirst.values.push_back(found->second == other ? 1 : 0);
        answers.push_back({row.source, row.answerId});
      }
    }
    using Ratio = Estimable<Estimate>;
    Ratio ratio = Ratio::impossible("no subject with an answer has a trial");
    const auto& first = otherFirst.values;
    if (!places.empty() && std::count(first.begin(), first.end(), first.front()) == std::ssize(first)) {
      ratio = Ratio::impossible("all subjects who answered began with the same view");
    } else if (!places.empty()) {
      const Estimable<ProportionalOddsFit> fit = fitProportionalOdds(places, {otherFirst});
      ratio = fit ? Ratio(fit->terms.front().oddsRatio) : Ratio::impossible(fit.reason());
    }
    rows.push_back({fmt::format("{} ({} first / {} first)", each.item.label(), words.towards, words.from),
                    ratio,
                    "",
                    fmt::format("last answers of {} subjects to {}, by the view of their first trial", places.size(),
                                each.item.name),
                    {},
                    answers});
  }
  if (!rows.empty()) {
    addEstimates(work.document,
                 isPair
                     ? "Whether answers go with the view of a subject's first trial: odds ratio of an answer farther "
                       "towards @other@ where @other@ came first (proportional odds)"
                     : "Whether answers go with which of the two views a subject saw first: odds ratio of an answer "
                       "farther towards the view of the last option where that came first (proportional odds)",
                 "survey-first-view", rows);
  }
}

void addSurveySection(ReportWork& work, const ReportTask& /*task*/) {
  addHeading(work.document, 1, "What subjects say", "survey");
  const std::vector<ItemAnswers> items = answersToForm(work.analysis.data, kForm);
  if (items.empty()) {
    addNotEstimable(work.document, "Survey", "there are no answers to a form \"survey\"");
    addOutcome(work, {});
    return;
  }
  addCautions(work, items);
  addFigures(work, items);
  addDescriptions(work, items);
  addPreferences(work, items);
  addOrder(work, items);
  work.methods.push_back(
      "Answers to questions of the survey that compare the views were tested against the middle of their own scale by "
      "signed ranks; the p value of the survey is the smallest of these questions, corrected by Holm's method. Other "
      "questions are described.");
}

}  // namespace

ReportTask surveyReportTask() {
  ReportTask task;
  task.name = kForm;
  task.title = "Survey";
  task.trialsName = "surveys";
  task.timesOutcome = task.rightOutcome = "the survey";
  task.hasTrials = false;
  task.parts = {{"Survey", "", 0, addSurveySection}};
  task.models = {{"survey", kForm, ModelKind::kOrdinal}};
  task.hypotheses = {{{"survey-preference", "One of the views is said to be easier", "survey", ""}}};
  return task;
}

}  // namespace ocelli
