// Numbers of trials by subject: each subject counts once, with its mean, so that neither many trials of one subject nor
// their likeness makes an interval too narrow (Matthews et al. 1990, "Analysis of serial measurements": summary
// measures).
#pragma once

#include <map>
#include <string>
#include <vector>

#include "analysis/plot/group_plot.h"
#include "analysis/report/comparison_table.h"

namespace ocelli {

struct TrialValue {
  const Trial* trial = nullptr;
  double value = 0;
};
using TrialValues = std::vector<TrialValue>;

/// Logarithms are shown as geometric means and ratios. Intervals of shares, and of differences of shares, end where
/// these do.
enum class ValueScale : uint8_t { kPlain, kLogarithm, kShare, kShareDifference };
ValueScale scaleOfDifferences(ValueScale scale);
/// On that scale, from the scale of the numbers.
Estimate shownOn(ValueScale scale, const Estimate& estimate);

/// One number a subject, and the trials that all of them came from.
struct SubjectNumbers {
  std::map<std::string, double> bySubject{};
  TrialList trials{};
};

std::vector<double> numbersOf(const SubjectNumbers& numbers);

TrialValues valuesOfView(const TrialValues& values, TrialView view);
SubjectNumbers subjectMeans(const TrialValues& values);
/// Of subjects who are in both: second - first.
SubjectNumbers subjectDifferences(const SubjectNumbers& first, const SubjectNumbers& second);

/// The mean over subjects with Student's interval and test against 0, or a ratio with the test against 1; without them
/// where all subjects are alike. Not possible for fewer than two. `what` says what the numbers are: "means".
EstimateRow rowOfSubjects(const std::string& label, const SubjectNumbers& numbers, ValueScale scale,
                          const std::string& what);

EstimateRow untested(EstimateRow row);

/// Means of either view, and the mean difference of subjects with both.
ComparisonRow compareViews(const std::string& label, const TrialValues& values, ValueScale scale);

/// A dot a subject, the mean over subjects, and its interval where there is one.
GroupValues groupOfSubjects(const SubjectNumbers& numbers, ValueScale scale);

}  // namespace ocelli
