// Applying a plan: which trials are analysed, which are not and why, row by row, and how many subjects came through
// each step (CONSORT 2010, item 13: the flow of participants).
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "analysis/dataset/analysis_plan.h"
#include "analysis/dataset/dataset.h"

namespace ocelli {

/// A subject that is left out as a whole, or a session.
struct ExcludedSubject {
  std::string subject;
  std::optional<int> session{};  ///< nothing: all of them
  std::string rule;              ///< "ending is unwell"
  std::string reason;
  int64_t trials = 0;  ///< that were left out with it
};

/// How many came through each step. A subject that several rules exclude counts for the first of them.
struct SubjectFlow {
  int enrolled = 0;                                     ///< subjects that the files hold
  std::optional<int> consented{};                       ///< nothing where the files do not tell
  std::string consentNote{};                            ///< why not
  int began = 0;                                        ///< have a trial that counts
  std::vector<int> completedSessions{};                 ///< [k]: subjects that completed k + 1 sessions or more
  std::vector<std::pair<std::string, int>> excluded{};  ///< reasons with subjects, in the order of the rules
  int analysed = 0;                                     ///< have a trial left
  std::vector<int> analysedWithSessions{};              ///< [k]: of them, completed k + 1 sessions or more
  int64_t trials = 0;                                   ///< that count
  int64_t excludedTrials = 0;
  int64_t analysedTrials = 0;
};

struct AnalysisData {
  Dataset data;  ///< what is analysed; `leftOut` has every row that is not
  AnalysisPlan plan;
  std::vector<ExcludedSubject> excluded;
  SubjectFlow flow;
  std::string dataSha256;               ///< dataHash() of what was read, before exclusions
  std::vector<std::string> warnings{};  ///< what a reader must not miss: whole sentences
};

/// Beside what the plan says, trials that contradict themselves (trial_check.h) are left out, and a warning names them;
/// sessions that were forced past a failed check of the timing are named whether they are left out or not.
/// Throws InputError where the plan is for another protocol, names a subject that is not there, or has a rule that
/// needs the protocol and there is none.
AnalysisData applyPlan(Dataset data, const AnalysisPlan& plan);

/// Sessions of the subject that ended as "completed".
int completedSessions(const Dataset& data, const std::string& subject);
/// By subject, for all of them.
std::map<std::string, int> completedSessions(const Dataset& data);

/// The exclusion log as CSV: source, table, row, subject, session, why; and the attempts that never counted.
std::string exclusionLogCsv(const Dataset& data);

/// "ending is unwell".
std::string describe(const ExclusionRule& rule);
/// What is wrong with a rule as it was read, as the end of a sentence about its field "what"; empty where nothing is.
std::string problemOfRule(const ExclusionRule& rule, const std::string& test, bool hasValue, bool valueIsText);

}  // namespace ocelli
