// How large the effect of the view is, in units that compare across studies.
#pragma once

#include <string>
#include <vector>

#include "analysis/report/report_parts.h"

namespace ocelli {

/// One mean a view of each subject who saw both, in the order of their ids.
struct SubjectMeans {
  std::vector<double> reference;
  std::vector<double> other;
  std::vector<double> differences;  ///< other less reference
};
SubjectMeans subjectMeans(const TrialList& trials, const std::vector<double>& values);

/// Of log times: standardised differences of subjects' means, and by ranks.
void addTimeEffects(ReportWork& work, const TrialList& trials, const std::vector<double>& seconds,
                    const std::string& id);
/// Of right answers: differences and ratios of shares of all trials, and standardised differences of subjects' shares.
void addShareEffects(ReportWork& work, const TrialList& trials, const std::string& id);

}  // namespace ocelli
