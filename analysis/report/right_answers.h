// How often answers are right: what counts and paths have in common.
#pragma once

#include "analysis/inference/binomial_test.h"
#include "analysis/inference/equivalence.h"
#include "analysis/report/report_parts.h"

namespace ocelli {

/// Those that say whether their answer was right.
TrialList answeredTrials(TrialList trials);
Share shareOf(const TrialList& trials);

/// Share of right answers of each subject who saw both views, other less reference.
std::vector<double> shareDifferences(const TrialList& trials);
/// The mean of these, where subjects and cases are drawn from more of theirs.
Estimable<Estimate> shareDifference(const TrialList& trials);
/// Two one-sided tests of it. Throws InputError for bounds that enclose nothing.
Estimable<EquivalenceTest> shareEquivalence(const TrialList& trials, const EquivalenceBounds& bounds, double alpha);

/// A figure of the share of each view by session, a dot a subject, and a table of shares with Wilson's intervals.
void addRightAnswers(ReportWork& work, const TrialList& trials, const std::string& what, const std::string& id,
                     std::optional<double> chance);

}  // namespace ocelli
