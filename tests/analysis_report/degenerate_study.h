// Small and degenerate studies, drawn from a number: few subjects and cases, sessions that were dropped, answers that
// are all right, times that are all alike or absurd, one view, missing values. Nothing that they hold may end a report.
#pragma once

#include <string>
#include <vector>

#include "analysis/dataset/exclusions.h"

namespace ocelli::test {

struct DegenerateStudy {
  std::string name;  ///< what was drawn: "7: 3 subjects, 1 session, times alike, all right, ..."
  Dataset data;
  AnalysisPlan plan;
};

/// The same number is the same study.
DegenerateStudy degenerateStudy(int number);

/// What is wrong with the report of the study, with all of its files: that there is none, parts that failed, numbers
/// that are none.
std::vector<std::string> problemsOfReport(const DegenerateStudy& study);

}  // namespace ocelli::test
