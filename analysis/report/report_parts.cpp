#include "analysis/report/report_parts.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>

#include "analysis/report/report_task.h"

namespace ocelli {
namespace {

/// Results that share a reason, of which so many are named.
constexpr size_t kMaxNamed = 4;
/// A cell that has nothing to say.
constexpr const char* kNoText = "-";

bool hasTerm(const PlannedModel& model, const std::string& term) {
  return std::any_of(model.terms.begin(), model.terms.end(), [&](const std::string& t) {
    return t == term || t.starts_with(term + ":") || t.ends_with(":" + term);
  });
}

const char* wordsOf(ModelKind kind) {
  switch (kind) {
    case ModelKind::kLinearMixed:
      return "linear mixed model";
    case ModelKind::kLogNormalMixed:
      return "log-normal mixed model";
    case ModelKind::kBinomialMixed:
      return "binomial mixed model";
    case ModelKind::kKaplanMeier:
      return "Kaplan-Meier curves";
    case ModelKind::kCox:
      return "Cox regression";
    case ModelKind::kLogNormalSurvival:
      return "log-normal regression";
    case ModelKind::kMcNemar:
      return "McNemar's test";
    case ModelKind::kSignedError:
      return "signed errors";
    case ModelKind::kEquivalence:
      return "test of equivalence";
    case ModelKind::kBayesFactor:
      return "Bayes factor";
    case ModelKind::kAgainstChance:
      return "test against chance";
    case ModelKind::kOrdinal:
      return "signed ranks";
    case ModelKind::kSignedErrorMixed:
      return "mixed model of signed errors";
    case ModelKind::kAbsoluteErrorMixed:
      return "mixed model of absolute errors";
  }
  return "";
}

}  // namespace

std::string wordsOf(const PlannedModel& model, bool startsSentence) {
  const ReportTask task = reportTask(model.task);
  const ModelOutcome outcome = modelOutcomeOf(model.kind);
  std::string words = fmt::format("{} of {} ({})", wordsOf(model.kind),
                                  outcome == ModelOutcome::kTimes       ? task.timesOutcome
                                  : outcome == ModelOutcome::kEstimates ? task.trialsName
                                                                        : task.rightOutcome,
                                  model.name);
  if (startsSentence) {
    words[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(words[0])));
  }
  return words;
}

OriginRows originRowsOf(const TrialList& trials) {
  OriginRows origin;
  origin.rows.reserve(trials.size());
  for (const Trial* trial : trials) {
    origin.rows.push_back({trial->source, trial->trialId});
  }
  return origin;
}

OriginRows originRowsOf(const EstimateRow& row) {
  return row.answers.empty() ? originRowsOf(row.trials) : OriginRows{row.answers, Cell::From::kAnswers};
}

std::string planName(const AnalysisPlan& plan) {
  return plan.isRegistered() ? "the plan" : "the default plan";
}

TrialList trialsOfTask(const Dataset& data, const std::string& task) {
  TrialList list;
  for (const Trial& trial : data.trials) {
    if (trial.task == task) {
      list.push_back(&trial);
    }
  }
  return list;
}

TrialList trialsOfTask(const AnalysisData& analysis, const std::string& task) {
  return trialsOfTask(analysis.data, task);
}

TrialList trialsOfView(const TrialList& trials, TrialView view) {
  TrialList list;
  std::copy_if(trials.begin(), trials.end(), std::back_inserter(list),
               [&](const Trial* trial) { return trial->view == view; });
  return list;
}

const std::string& labelOf(const ReportWork& work, TrialView view) {
  return work.analysis.data.conditions.labelOf(view);
}

std::string withLabels(const ReportWork& work, const std::string& text) {
  return withViewLabels(text, work.analysis.data.conditions);
}

std::vector<int> numbered(const std::vector<std::string>& labels) {
  std::map<std::string, int> numbers;
  std::vector<int> result;
  result.reserve(labels.size());
  for (const std::string& label : labels) {
    result.push_back(numbers.try_emplace(label, static_cast<int>(numbers.size())).first->second);
  }
  return result;
}

std::vector<std::string> subjectsOf(const TrialList& trials) {
  std::vector<std::string> subjects;
  subjects.reserve(trials.size());
  for (const Trial* trial : trials) {
    subjects.push_back(trial->subject);
  }
  return subjects;
}

Estimate exponentiated(const Estimate& logarithm) {
  Estimate result = logarithm;
  result.value = std::exp(logarithm.value);
  result.lower = std::exp(logarithm.lower);
  result.upper = std::exp(logarithm.upper);
  result.standardError = result.value * logarithm.standardError;
  return result;
}

Interval intervalOf(const Estimate& estimate) {
  return {estimate.value, estimate.lower, estimate.upper};
}

void addHeading(ReportDocument& document, int level, const std::string& text, const std::string& id) {
  document.add(ReportHeading{level, text, id});
}

void addNotEstimable(ReportDocument& document, const std::string& what, const std::string& reason) {
  document.add(ReportNote{NoteKind::kNotEstimable, fmt::format("{}: {}.", what, reason)});
}

void ReasonNotes::add(const std::string& what, const std::string& reason) {
  const auto said = std::find_if(notes_.begin(), notes_.end(), [&](const auto& note) { return note.first == reason; });
  if (said == notes_.end()) {
    notes_.push_back({reason, {what}});
  } else {
    said->second.push_back(what);
  }
}

void ReasonNotes::write(ReportDocument& document) const {
  for (const auto& [reason, labels] : notes_) {
    const size_t named = labels.size() > kMaxNamed ? kMaxNamed - 1 : labels.size();
    std::string what = fmt::format("{}", fmt::join(labels.begin(), labels.begin() + static_cast<int>(named), "; "));
    if (named < labels.size()) {
      what += fmt::format(" and {} more", labels.size() - named);
    }
    addNotEstimable(document, what, reason);
  }
}

namespace {

/// A column of addEstimates() after the label.
struct EstimateColumn {
  const char* title;
  const char* name;  ///< of its cells in the origins; the interval's are those of its bounds
  std::string (*text)(const Estimate& estimate, const EstimateTexts& texts, const std::string& unit);
  double (*value)(const Estimate& estimate);
};

constexpr size_t kAlwaysShown = 2;
const EstimateColumn kEstimateColumns[] = {
    {"Estimate", "estimate",
     [](const Estimate&, const EstimateTexts& texts, const std::string& unit) {
       return texts.value.empty() ? "" : texts.value + unit;
     },
     [](const Estimate& e) { return e.value; }},
    {"95 % interval", "lower",
     [](const Estimate&, const EstimateTexts& texts, const std::string&) { return texts.interval; },
     [](const Estimate&) { return kNotKnown; }},
    {"SE", "se", [](const Estimate&, const EstimateTexts& texts, const std::string&) { return texts.standardError; },
     [](const Estimate& e) { return e.standardError; }},
    {"Statistic", "statistic",
     [](const Estimate& e, const EstimateTexts&, const std::string&) { return statisticText(e); },
     [](const Estimate& e) { return e.statistic; }},
    {"df", "df",
     [](const Estimate& e, const EstimateTexts&, const std::string&) { return degreesText(e.degreesOfFreedom); },
     [](const Estimate& e) { return e.degreesOfFreedom; }},
    {"p", "p", [](const Estimate& e, const EstimateTexts&, const std::string&) { return pValueText(e.pValue); },
     [](const Estimate& e) { return e.pValue; }},
};

/// Columns without a text in any row are left out, but for the first.
void dropEmptyColumns(ReportTable& table) {
  for (size_t column = table.columns.size() - 1; column > kAlwaysShown; --column) {
    if (std::all_of(table.rows.begin(), table.rows.end(),
                    [&](const auto& row) { return row[column].text == kNoText; })) {
      const auto at = static_cast<std::ptrdiff_t>(column);
      table.columns.erase(table.columns.begin() + at);
      for (std::vector<ReportCell>& row : table.rows) {
        row.erase(row.begin() + at);
      }
    }
  }
}

}  // namespace

void addEstimates(ReportDocument& document, const std::string& caption, const std::string& id,
                  const std::vector<EstimateRow>& rows) {
  ReportTable table{caption, id, {{"What", "", true}}, {}};
  for (const EstimateColumn& column : kEstimateColumns) {
    table.columns.push_back({column.title});
  }
  OriginTable origins(document.origins, id, caption, {"estimate", "lower", "upper", "p", "se", "statistic", "df"});
  for (const EstimateRow& row : rows) {
    if (!row.estimate) {
      continue;
    }
    const Estimate& e = *row.estimate;
    const EstimateTexts texts = textsOf(e);
    const std::string unit = row.unit.empty() ? "" : " " + row.unit;
    const std::string origin =
        origins.addRow(row.label, row.source, originRowsOf(row), row.unit,
                       {e.value, e.lower, e.upper, e.pValue, e.standardError, e.statistic, e.degreesOfFreedom});
    const std::string source = origins.sourceText(row.source);
    table.rows.push_back({ReportCell{row.label}});
    for (const EstimateColumn& column : kEstimateColumns) {
      const std::string text = column.text(e, texts, unit);
      ReportCell cell{text.empty() ? std::string(kNoText) : text,
                      origin.empty() ? "" : fmt::format("{}/{}", origin, column.name), source};
      if (const double value = column.value(e); std::isfinite(value)) {
        cell.value = value;
      }
      if (cell.text == texts.interval) {
        cell.interval = {e.lower, e.upper};
      }
      table.rows.back().push_back(std::move(cell));
    }
  }
  if (!table.rows.empty()) {
    dropEmptyColumns(table);
    document.add(table);
    origins.finish();
  }
  ReasonNotes reasons;
  for (const EstimateRow& row : rows) {
    if (!row.estimate) {
      reasons.add(row.label, row.estimate.reason());
    }
  }
  reasons.write(document);
}

void addValues(ReportDocument& document, const std::string& caption, const std::string& id,
               const std::vector<ValueRow>& rows) {
  ReportTable table{caption, id, {{"What", "", true}, {"Value"}}, {}};
  OriginTable origins(document.origins, id, caption, {"value", "lower", "upper"});
  for (const ValueRow& row : rows) {
    std::vector<double> numbers{row.value.value_or(kNotKnown)};
    if (row.interval) {
      numbers = {row.interval->value, row.interval->lower, row.interval->upper};
    }
    const std::string origin = origins.addRow(row.label, row.source, originRowsOf(row.trials), "", numbers);
    table.rows.push_back(
        {ReportCell{row.label},
         ReportCell{row.text, origin.empty() ? "" : fmt::format("{}/{}", origin, row.interval ? "lower" : "value"),
                    origins.sourceText(row.source), row.value}});
  }
  document.add(table);
  origins.finish();
}

TrialList completeTrials(const PlannedModel& model, const TrialList& trials) {
  TrialList list;
  std::copy_if(trials.begin(), trials.end(), std::back_inserter(list), [&](const Trial* trial) {
    return (!hasTerm(model, "moving") || trial->moving) && (!hasTerm(model, "exposure") || trial->exposureSeconds) &&
           (!hasTerm(model, "duplicates") || trial->duplicateColors) && (!hasTerm(model, "objects") || trial->objects);
  });
  return list;
}

std::string sizeText(const TrialList& trials) {
  const std::vector<std::string> subjects = subjectsOf(trials);
  return fmt::format("{} trials of {} subjects", trials.size(),
                     std::set<std::string>(subjects.begin(), subjects.end()).size());
}

}  // namespace ocelli
