// What the sections of a study's report share: trials of a task, models of the plan, and tables of estimates.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "analysis/base/estimable.h"
#include "analysis/base/estimate.h"
#include "analysis/dataset/exclusions.h"
#include "analysis/inference/survival_data.h"
#include "analysis/plot/panel.h"
#include "analysis/report/number_text.h"
#include "analysis/report/report_document.h"
#include "analysis/report/report_origins.h"
#include "analysis/tables/table_cells.h"

namespace ocelli {

/// What a test is about, for the reader of a hypothesis.
struct TestedEffect {
  std::string
      measure;  ///< with its unit: "ratio of times, other / reference", "difference of shares, other less reference"
  Estimate estimate;
  double level = 0.95;  ///< of its interval
};

/// A p value that a hypothesis of the plan may ask for.
struct TestOutcome {
  std::string model;
  std::string term;  ///< as the plan names it; empty where the model has but one test
  Estimable<double> pValue;
  std::optional<TestedEffect> effect{};
};

/// What is filled while the report is made.
struct ReportWork {
  const AnalysisData& analysis;
  ReportDocument& document;
  std::set<std::string> only{};  ///< tasks that the report is about; empty: all
  std::vector<TestOutcome> outcomes{};
  std::vector<std::string> methods{};  ///< sentences about what was done

  bool isWanted(const std::string& task) const { return only.empty() || only.contains(task); }
};

/// What decides how things are done: "the plan", or where none was registered "the default plan".
std::string planName(const AnalysisPlan& plan);

/// What a model is, for readers, with its name in the plan: "Cox regression of times to find (find-hazard)".
std::string wordsOf(const PlannedModel& model, bool startsSentence = true);

TrialList trialsOfTask(const Dataset& data, const std::string& task);
TrialList trialsOfTask(const AnalysisData& analysis, const std::string& task);
TrialList trialsOfView(const TrialList& trials, TrialView view);
/// What figures call the view: they are drawn before marks get their words.
const std::string& labelOf(const ReportWork& work, TrialView view);
/// For what figures say of views: the text with labels in place of marks.
std::string withLabels(const ReportWork& work, const std::string& text);

/// 0, 1, ... for each different label, in the order in which they first come.
std::vector<int> numbered(const std::vector<std::string>& labels);
std::vector<std::string> subjectsOf(const TrialList& trials);

/// One line of a table of estimates, or why there is none.
struct EstimateRow {
  std::string label;
  Estimable<Estimate> estimate;
  std::string unit{};
  std::string source{};           ///< what was done, in words
  TrialList trials{};             ///< that it came from
  std::vector<RowRef> answers{};  ///< or these
};
OriginRows originRowsOf(const TrialList& trials);
OriginRows originRowsOf(const EstimateRow& row);

/// Columns: what, estimate, 95 % interval, standard error, statistic, degrees of freedom, p; those that no row has are
/// left out. Reasons stand below the table as notes. Cells that came from trials or answers are named
/// ID/LABEL/estimate, lower, upper, p, se, statistic and df in the document's origins.
void addEstimates(ReportDocument& document, const std::string& caption, const std::string& id,
                  const std::vector<EstimateRow>& rows);

/// A number, or a word about it, that is no estimate: a Bayes factor.
struct ValueRow {
  std::string label;
  std::string text;
  std::optional<double> value{};
  std::string source{};
  TrialList trials{};
  std::optional<Interval> interval{};  ///< where `text` is one
};
/// Columns: what, value. Cells are named ID/LABEL/value; of intervals ID/LABEL/lower, with ID/LABEL/upper beside it.
void addValues(ReportDocument& document, const std::string& caption, const std::string& id,
               const std::vector<ValueRow>& rows);

/// exp() of value and bounds, the standard error by the delta method; statistic and p value stay.
Estimate exponentiated(const Estimate& logarithm);
Interval intervalOf(const Estimate& estimate);

void addHeading(ReportDocument& document, int level, const std::string& text, const std::string& id = "");
void addNotEstimable(ReportDocument& document, const std::string& what, const std::string& reason);
/// The same for many things at once: one note a reason.
class ReasonNotes {
 public:
  void add(const std::string& what, const std::string& reason);
  void write(ReportDocument& document) const;

 private:
  std::vector<std::pair<std::string, std::vector<std::string>>> notes_{};  ///< reasons, with all that they are of
};

/// Whose columns the terms of a planned model can be made of: the others lack a value.
TrialList completeTrials(const PlannedModel& model, const TrialList& trials);
/// "500 trials of 45 subjects".
std::string sizeText(const TrialList& trials);

}  // namespace ocelli
