#include "analysis/report/report_parts.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace ocelli {
namespace {

/// Results that share a reason, of which so many are named.
constexpr size_t kMostNamed = 4;

bool hasTerm(const PlannedModel& model, const std::string& term) {
  return std::any_of(model.terms.begin(), model.terms.end(), [&](const std::string& t) {
    return t == term || t.starts_with(term + ":") || t.ends_with(":" + term);
  });
}

}  // namespace

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

TrialList trialsOfTask(const AnalysisData& analysis, const std::string& task) {
  TrialList list;
  for (const Trial& trial : analysis.data.trials) {
    if (trial.task == task) {
      list.push_back(&trial);
    }
  }
  return list;
}

TrialList trialsOfView(const TrialList& trials, TrialView view) {
  TrialList list;
  std::copy_if(trials.begin(), trials.end(), std::back_inserter(list),
               [&](const Trial* trial) { return trial->view == view; });
  return list;
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

std::string numberText(double value) {
  if (!std::isfinite(value)) {
    return "not known";
  }
  const double size = std::abs(value);
  return size >= 100 && size < 1e6 ? fmt::format("{:.1f}", value) : fmt::format("{:#.3g}", value);
}

std::string pText(double pValue) {
  if (!std::isfinite(pValue)) {
    return "p not known";
  }
  return pValue < 0.001 ? "p < 0.001" : fmt::format("p = {:.3f}", pValue);
}

Estimate exponentiated(const Estimate& logarithm) {
  Estimate result = logarithm;
  result.value = std::exp(logarithm.value);
  result.lower = std::exp(logarithm.lower);
  result.upper = std::exp(logarithm.upper);
  result.standardError = kNotKnown;
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
    const size_t named = labels.size() > kMostNamed ? kMostNamed - 1 : labels.size();
    std::string what = fmt::format("{}", fmt::join(labels.begin(), labels.begin() + static_cast<int>(named), "; "));
    if (named < labels.size()) {
      what += fmt::format(" and {} more", labels.size() - named);
    }
    addNotEstimable(document, what, reason);
  }
}

void addEstimates(ReportDocument& document, const std::string& caption, const std::string& id,
                  const std::vector<EstimateRow>& rows) {
  ReportTable table{caption, id, {{"What", "", true}, {"Estimate"}, {"95 % interval"}, {"p"}}, {}};
  OriginTable origins(document.origins, id, caption, {"estimate", "lower", "upper", "p"});
  for (const EstimateRow& row : rows) {
    if (!row.estimate) {
      continue;
    }
    const Estimate& e = *row.estimate;
    const std::string unit = row.unit.empty() ? "" : " " + row.unit;
    const std::string origin =
        origins.addRow(row.label, row.source, originRowsOf(row), row.unit, {e.value, e.lower, e.upper, e.pValue});
    const std::string source = origins.sourceText(row.source);
    const auto cell = [&](const std::string& text, const char* column, double value) {
      ReportCell result{text, origin.empty() ? "" : fmt::format("{}/{}", origin, column), source};
      if (std::isfinite(value)) {
        result.value = value;
      }
      return result;
    };
    const bool hasInterval = std::isfinite(e.lower) && std::isfinite(e.upper);
    const std::string interval =
        hasInterval ? fmt::format("{} to {}", numberText(e.lower), numberText(e.upper)) : std::string("-");
    const std::string p = std::isfinite(e.pValue) ? pText(e.pValue).substr(2) : std::string("-");
    table.rows.push_back({ReportCell{row.label}, cell(numberText(e.value) + unit, "estimate", e.value),
                          cell(interval, "lower", kNotKnown),
                          cell(p.starts_with("= ") ? p.substr(2) : p, "p", e.pValue)});
  }
  if (!table.rows.empty()) {
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
  OriginTable origins(document.origins, id, caption, {"value"});
  for (const ValueRow& row : rows) {
    const std::string origin =
        origins.addRow(row.label, row.source, originRowsOf(row.trials), "", {row.value.value_or(kNotKnown)});
    table.rows.push_back(
        {ReportCell{row.label}, ReportCell{row.text, origin.empty() ? "" : fmt::format("{}/value", origin),
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
