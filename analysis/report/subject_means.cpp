#include "analysis/report/subject_means.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/inference/sample.h"
#include "analysis/inference/student.h"

namespace ocelli {
namespace {

Estimate withoutInterval(double value) {
  Estimate estimate;
  estimate.value = value;
  return estimate;
}

Estimate cut(Estimate estimate, double least, double most) {
  // Unknown bounds stay so.
  estimate.lower = estimate.lower < least ? least : estimate.lower;
  estimate.upper = estimate.upper > most ? most : estimate.upper;
  return estimate;
}

}  // namespace

std::vector<double> numbersOf(const SubjectNumbers& numbers) {
  std::vector<double> values;
  values.reserve(numbers.bySubject.size());
  for (const auto& [subject, value] : numbers.bySubject) {
    values.push_back(value);
  }
  return values;
}

ValueScale scaleOfDifferences(ValueScale scale) {
  switch (scale) {
    case ValueScale::kPlain:
    case ValueScale::kLogarithm:
      return scale;
    case ValueScale::kShare:
      return ValueScale::kShareDifference;
    case ValueScale::kShareDifference:
      return ValueScale::kPlain;
  }
  return scale;
}

Estimate shownOn(ValueScale scale, const Estimate& estimate) {
  switch (scale) {
    case ValueScale::kPlain:
      return estimate;
    case ValueScale::kLogarithm:
      return exponentiated(estimate);
    case ValueScale::kShare:
      return cut(estimate, 0, 1);
    case ValueScale::kShareDifference:
      return cut(estimate, -1, 1);
  }
  return estimate;
}

EstimateRow untested(EstimateRow row) {
  if (row.estimate) {
    Estimate estimate = *row.estimate;
    estimate.statistic = estimate.pValue = kNotKnown;
    row.estimate = estimate;
  }
  return row;
}
TrialValues valuesOfView(const TrialValues& values, TrialView view) {
  TrialValues some;
  std::copy_if(values.begin(), values.end(), std::back_inserter(some),
               [&](const TrialValue& value) { return value.trial->view == view; });
  return some;
}

SubjectNumbers subjectMeans(const TrialValues& values) {
  SubjectNumbers means;
  std::map<std::string, int> counts;
  means.trials.reserve(values.size());
  for (const TrialValue& value : values) {
    means.bySubject[value.trial->subject] += value.value;
    ++counts[value.trial->subject];
    means.trials.push_back(value.trial);
  }
  for (auto& [subject, mean] : means.bySubject) {
    mean /= counts[subject];
  }
  return means;
}

SubjectNumbers subjectDifferences(const SubjectNumbers& first, const SubjectNumbers& second) {
  SubjectNumbers differences;
  for (const auto& [subject, value] : first.bySubject) {
    if (const auto other = second.bySubject.find(subject); other != second.bySubject.end()) {
      differences.bySubject[subject] = differenceOf(value, other->second);
    }
  }
  for (const TrialList* trials : {&first.trials, &second.trials}) {
    std::copy_if(trials->begin(), trials->end(), std::back_inserter(differences.trials),
                 [&](const Trial* trial) { return differences.bySubject.contains(trial->subject); });
  }
  return differences;
}

EstimateRow rowOfSubjects(const std::string& label, const SubjectNumbers& numbers, ValueScale scale,
                          const std::string& what) {
  const std::vector<double> values = numbersOf(numbers);
  const Estimable<Estimate> mean = studentMean(values);
  EstimateRow row{label, mean, "",
                  fmt::format("mean of the {} of {} subjects ({} trials), Student's interval", what, values.size(),
                              numbers.trials.size()),
                  numbers.trials};
  if (values.size() < 2) {
    row.estimate = Estimable<Estimate>::impossible(values.empty() ? "no subject has such trials"
                                                                  : "only one subject has such trials");
    return row;
  }
  if (!mean) {
    row.estimate = withoutInterval(momentsOf(values).mean);
    row.source = fmt::format("mean of the {} of {} subjects ({} trials), who are all alike: there is no interval", what,
                             values.size(), numbers.trials.size());
  }
  row.estimate = shownOn(scale, *row.estimate);
  if (scale == ValueScale::kLogarithm) {
    row.source = fmt::format("exponential of the {}", row.source);
  }
  return row;
}

ComparisonRow compareViews(const std::string& label, const TrialValues& values, ValueScale scale) {
  const bool ratio = scale == ValueScale::kLogarithm;
  const SubjectNumbers reference = subjectMeans(valuesOfView(values, TrialView::kReference));
  const SubjectNumbers other = subjectMeans(valuesOfView(values, TrialView::kOther));
  const SubjectNumbers difference = subjectDifferences(reference, other);
  const char* what = ratio ? "mean logarithms" : "means";
  ComparisonRow row{
      label, untested(rowOfSubjects(fmt::format("{}, @reference@", label), reference, scale, what)),
      untested(rowOfSubjects(fmt::format("{}, @other@", label), other, scale, what)),
      rowOfSubjects(fmt::format("{}, {}", label, ratio ? "@other@ / @reference@" : "@other@ less @reference@"),
                    difference, scaleOfDifferences(scale),
                    fmt::format("differences (@other@ less @reference@) of {}", what)),
      ""};
  row.subjects =
      fmt::format("{}, {}, {}", reference.bySubject.size(), other.bySubject.size(), difference.bySubject.size());
  if (!row.difference.estimate && difference.bySubject.empty()) {
    row.difference.estimate = Estimable<Estimate>::impossible("no subject has such trials in both views");
  }
  return row;
}

GroupValues groupOfSubjects(const SubjectNumbers& numbers, ValueScale scale) {
  GroupValues group{{kNotKnown, kNotKnown, kNotKnown}, {}};
  std::vector<double> values = numbersOf(numbers);
  if (values.empty()) {
    return group;
  }
  const Estimable<Estimate> mean = studentMean(values);
  group.summary = intervalOf(shownOn(scale, mean ? *mean : withoutInterval(momentsOf(values).mean)));
  if (scale == ValueScale::kLogarithm) {
    std::transform(values.begin(), values.end(), values.begin(), [](double value) { return std::exp(value); });
  }
  group.raw = std::move(values);
  return group;
}

}  // namespace ocelli
