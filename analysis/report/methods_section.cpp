#include "analysis/report/methods_section.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <iterator>
#include <set>

#include "analysis/inference/holm.h"
#include "analysis/report/planned_model.h"
#include "analysis/report/share_models.h"
#include "analysis/report/survey_section.h"

namespace ocelli {
namespace {

const TestOutcome* outcomeOf(const ReportWork& work, const Hypothesis& hypothesis) {
  for (const TestOutcome& outcome : work.outcomes) {
    if (outcome.model == hypothesis.model && outcome.term == hypothesis.term) {
      return &outcome;
    }
  }
  return nullptr;
}

Estimable<double> pValueOf(const ReportWork& work, const Hypothesis& hypothesis) {
  const TestOutcome* outcome = outcomeOf(work, hypothesis);
  return outcome != nullptr ? outcome->pValue : Estimable<double>::impossible("its model was not fitted");
}

/// What the test of a hypothesis is about; nullptr where it could not be done, or has no effect of its own.
const TestedEffect* effectOf(const ReportWork& work, const Hypothesis* hypothesis) {
  const TestOutcome* outcome = hypothesis != nullptr ? outcomeOf(work, *hypothesis) : nullptr;
  return outcome != nullptr && outcome->pValue && outcome->effect ? &*outcome->effect : nullptr;
}

std::string withoutPoint(std::string sentence) {
  while (sentence.ends_with('.')) {
    sentence.pop_back();
  }
  return sentence;
}

std::string startingLarge(std::string text) {
  if (!text.empty()) {
    text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  }
  return text;
}

/// The cells of an effect in the table of its family: measure, estimate, interval.
std::array<ReportCell, 3> effectCells(const TestedEffect* effect) {
  std::array<ReportCell, 3> cells{ReportCell{"-"}, ReportCell{"-"}, ReportCell{"-"}};
  if (effect == nullptr) {
    return cells;
  }
  const Estimate& estimate = effect->estimate;
  const EstimateTexts texts = textsOf(estimate);
  cells[0].text = startingLarge(effect->measure);
  if (!texts.value.empty()) {
    cells[1].text = texts.value;
    cells[1].value = estimate.value;
  }
  if (!texts.interval.empty()) {
    cells[2].text = texts.interval;
    cells[2].interval = {estimate.lower, estimate.upper};
    if (effect->level != 0.95) {
      cells[2].footnote = fmt::format("Interval of {:g} %, as two one-sided tests have it.", 100 * effect->level);
    }
  }
  return cells;
}

/// "Objects are found ...: supported. Ratio of times, other / reference: 0.80 (95 % interval 0.67 to 0.95), p = 0.012,
/// corrected p = 0.036."
std::string answerText(const std::string& statement, const std::string& result, const TestedEffect* effect,
                       double pValue, std::optional<double> adjusted) {
  std::string text = fmt::format("{}: {}.", withoutPoint(statement), result);
  if (effect != nullptr && std::isfinite(effect->estimate.value)) {
    const EstimateTexts texts = textsOf(effect->estimate);
    text += fmt::format(" {}: {}", startingLarge(effect->measure), texts.value);
    if (!texts.interval.empty()) {
      text += fmt::format(" ({:g} % interval {})", 100 * effect->level, texts.interval);
    }
    text += fmt::format(", {}", pText(pValue));
  } else if (std::isfinite(pValue)) {
    text += fmt::format(" {}", startingLarge(pText(pValue)));
  }
  if (std::isfinite(pValue)) {
    text += adjusted ? fmt::format(", corrected {}.", pText(*adjusted)) : ".";
  }
  return text;
}

/// Of a row of a table, the cell that a p value is in: "p", or of tables of values the only one.
const Cell& testCellOf(const TableRow& row) {
  const auto found =
      std::find_if(row.cells.begin(), row.cells.end(), [](const Cell& cell) { return cell.name.ends_with("/p"); });
  return found == row.cells.end() ? row.cells.front() : *found;
}

/// The row of the table of a model that shows the test of a term; of models with one test, its first row.
std::string testRowOf(const PlannedModel& model, const std::string& term) {
  return !term.empty()                           ? labelOfTerm(model, term)
         : model.kind == ModelKind::kEquivalence ? std::string(kEquivalenceTestRow)
                                                 : std::string();
}

/// The cells of the report that a hypothesis was tested by: what --explain follows. The test of the survey is that of
/// all of its questions.
std::vector<std::string> cellsOf(const ReportOrigins& origins, const PlannedModel& model, const std::string& term) {
  const bool isSurvey = model.kind == ModelKind::kOrdinal;
  const std::string row = withViewNames(testRowOf(model, term), origins.conditions);
  std::vector<std::string> cells;
  for (const Table& table : origins.tables) {
    if (table.name != (isSurvey ? kSurveyTestsTable : model.name)) {
      continue;
    }
    for (const TableRow& each : table.rows) {
      const bool isAsked = row.empty() ? isSurvey || cells.empty() : each.heads.front() == row;
      if (isAsked && (!isSurvey || testCellOf(each).value)) {
        cells.push_back(testCellOf(each).name);
      }
    }
  }
  return cells;
}

}  // namespace

void addHypotheses(ReportWork& work) {
  const AnalysisPlan& plan = work.analysis.plan;
  addHeading(work.document, 1, "What was found", "hypotheses");
  work.document.add(ReportParagraph{fmt::format(
      "{} trials of {} subjects are analysed{}.", work.analysis.flow.analysedTrials, work.analysis.flow.analysed,
      work.analysis.flow.excludedTrials > 0
          ? fmt::format("; {} trials are left out by rules of {}", work.analysis.flow.excludedTrials, planName(plan))
          : "")});
  if (!plan.isRegistered()) {
    work.document.add(
        ReportNote{NoteKind::kWarning,
                   "No plan was registered. Exclusions, models, hypotheses and families are the defaults of Ocelli: "
                   "nothing was decided for this study before its data were seen, so tests confirm nothing, and all "
                   "tables are exploratory."});
  }
  std::vector<std::string> leftOut;
  ReportList answers;  // of the first family: the questions that come first
  std::vector<ReportTable> tables;
  std::vector<ReportNote> notes;
  for (const HypothesisFamily& family : plan.families) {
    const auto isLeftOut = [&](const std::string& name) {
      const Hypothesis* hypothesis = plan.findHypothesis(name);
      const PlannedModel* model = hypothesis ? plan.findModel(hypothesis->model) : nullptr;
      return model != nullptr && !work.isWanted(model->task);
    };
    std::copy_if(family.hypotheses.begin(), family.hypotheses.end(), std::back_inserter(leftOut), isLeftOut);
    if (std::all_of(family.hypotheses.begin(), family.hypotheses.end(), isLeftOut)) {
      continue;
    }
    std::vector<double> pValues;
    std::vector<std::string> reasons;
    for (const std::string& name : family.hypotheses) {
      const Hypothesis* hypothesis = plan.findHypothesis(name);
      const Estimable<double> p =
          hypothesis ? pValueOf(work, *hypothesis) : Estimable<double>::impossible("the plan does not say what it is");
      pValues.push_back(p ? *p : kNotKnown);
      reasons.push_back(p ? "" : p.reason());
    }
    const std::vector<double> adjusted = family.holm ? holmAdjusted(pValues) : pValues;
    ReportTable table{
        fmt::format("Family {}, {}", family.name, family.holm ? "corrected by Holm's method" : "not corrected"),
        fmt::format("family-{}", family.name),
        {{"Hypothesis", "", true},
         {"Effect", "", true},
         {"Estimate"},
         {"95 % interval"},
         {"p"},
         {"Adjusted p"},
         {"Result", "", true}},
        {}};
    OriginTable origins(work.document.origins, table.id, table.caption, {"p", "adjusted"});
    for (size_t i = 0; i < pValues.size(); ++i) {
      if (isLeftOut(family.hypotheses[i])) {
        continue;
      }
      const Hypothesis* hypothesis = plan.findHypothesis(family.hypotheses[i]);
      const bool known = std::isfinite(pValues[i]);
      const std::string source =
          hypothesis ? fmt::format("p value of {} in model {}",
                                   hypothesis->term.empty() ? "the test" : hypothesis->term, hypothesis->model)
                     : "";
      const PlannedModel* model = hypothesis ? plan.findModel(hypothesis->model) : nullptr;
      const std::string origin =
          known && model
              ? origins.addRow(family.hypotheses[i], source,
                               {{}, Cell::From::kCells, cellsOf(work.document.origins, *model, hypothesis->term)}, "",
                               {pValues[i], adjusted[i]})
              : "";
      const auto cell = [&](double p, const char* number) {
        ReportCell result{!known ? std::string("-") : pValueText(p),
                          origin.empty() ? "" : fmt::format("{}/{}", origin, number), known ? source : ""};
        if (known) {
          result.value = p;
        }
        return result;
      };
      const TestedEffect* effect = known ? effectOf(work, hypothesis) : nullptr;
      const std::string result = !known ? fmt::format("cannot be tested: {}", reasons[i])
                                        : std::string(adjusted[i] < plan.alpha ? "supported" : "not supported");
      ReportCell head{hypothesis ? withoutPoint(hypothesis->statement) : family.hypotheses[i]};
      head.shortName = family.hypotheses[i];
      std::array<ReportCell, 3> shown = effectCells(effect);
      table.rows.push_back({head, shown[0], shown[1], shown[2], cell(pValues[i], "p"), cell(adjusted[i], "adjusted"),
                            ReportCell{result}});
      if (tables.empty()) {
        answers.items.push_back(answerText(head.text, result, effect, pValues[i],
                                           family.holm && known ? std::optional<double>(adjusted[i]) : std::nullopt));
      }
    }
    origins.finish();
    tables.push_back(std::move(table));
    const auto untested = std::count_if(pValues.begin(), pValues.end(), [](double p) { return !std::isfinite(p); });
    if (family.holm && untested > 0 && pValues.size() > 1) {
      notes.push_back(ReportNote{
          NoteKind::kNote,
          fmt::format("Family {}: Holm's method corrects for all of its {} hypotheses, as {} has them, also for the {} "
                      "without a p value here.",
                      family.name, pValues.size(), planName(plan), untested)});
    }
  }
  if (!answers.items.empty() || work.analysis.data.conditions.isPair()) {
    work.document.add(answers);
  }
  for (ReportTable& table : tables) {
    work.document.add(std::move(table));
  }
  for (ReportNote& note : notes) {
    work.document.add(std::move(note));
  }
  if (!leftOut.empty()) {
    work.document.add(ReportNote{
        NoteKind::kNote,
        fmt::format("Left out with their tasks, and counted in corrections: {}.", fmt::join(leftOut, ", "))});
  }
}

namespace {

/// As describe(), without the digest, which stands in the supplement.
std::string planText(const AnalysisPlan& plan) {
  const std::string text = describe(plan);
  return text.substr(0, text.find(", SHA-256"));
}

/// Who they were, where that is not plain, and what recorded their trials.
std::string subjectsText(const Dataset& data) {
  std::string text = data.isSimulated()        ? " Subjects were simulated."
                     : data.subjectsAreKnown() ? ""
                                               : " Whether subjects were people or simulated is not known.";
  std::set<std::string> tools;
  for (const DataSource& source : data.sources) {
    if (!source.tool.empty()) {
      tools.insert(source.tool);
    }
  }
  if (!tools.empty()) {
    text += fmt::format(" Trials were recorded by {}.", fmt::join(tools, ", "));
  }
  if (!data.timeoutsAreKnown) {
    text += " Whether limits of time cut trials off is not known.";
  }
  return text;
}

}  // namespace

void addMethods(ReportWork& work, const std::string& version) {
  const AnalysisPlan& plan = work.analysis.plan;
  addHeading(work.document, 1, "Methods", "methods");
  work.document.add(ReportExcerpt{
      "Methods",
      fmt::format("We analysed {} trials of {} subjects with Ocelli {}; {}. {} Within families of hypotheses p values "
                  "were corrected by Holm's method at a level of {}.{}",
                  work.analysis.flow.analysedTrials, work.analysis.flow.analysed, version, planText(plan),
                  fmt::join(work.methods, " "), plan.alpha, subjectsText(work.analysis.data))});
}

}  // namespace ocelli
