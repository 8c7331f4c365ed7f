#include "analysis/report/direction_section.h"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <numbers>

#include "analysis/inference/circular.h"
#include "analysis/inference/student.h"
#include "analysis/plot/rose_plot.h"
#include "analysis/report/measure_sections.h"
#include "analysis/report/part_guard.h"

namespace ocelli {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;

/// Of one condition: the mean vector of each subject's errors.
struct SubjectVectors {
  std::map<std::string, MeanVector> bySubject{};
  std::vector<double> errors{};  ///< degrees, of all trials
  TrialList trials{};
};

SubjectVectors vectorsOf(const EstimateTrials& estimates, TrialView view) {
  SubjectVectors result;
  std::map<std::string, std::vector<double>> angles;
  for (size_t i = 0; i < estimates.trials.size(); ++i) {
    if (estimates.trials[i]->view == view) {
      const double error = estimates.values[i].signedError();
      angles[estimates.trials[i]->subject].push_back(error / kDegrees);
      result.errors.push_back(error);
      result.trials.push_back(estimates.trials[i]);
    }
  }
  for (const auto& [subject, ofSubject] : angles) {
    result.bySubject[subject] = meanVector(ofSubject);
  }
  return result;
}

std::vector<MeanVector> listOf(const SubjectVectors& vectors) {
  std::vector<MeanVector> list;
  for (const auto& [subject, vector] : vectors.bySubject) {
    list.push_back(vector);
  }
  return list;
}

Estimate inDegrees(Estimate radians) {
  radians.value *= kDegrees;
  radians.standardError *= kDegrees;
  radians.lower *= kDegrees;
  radians.upper *= kDegrees;
  return radians;
}

Estimable<Estimate> inDegrees(const Estimable<Estimate>& radians) {
  return radians ? Estimable<Estimate>(inDegrees(*radians)) : radians;
}

/// The longer the mean vector, the smaller the deviation.
Estimate deviationOf(const Estimate& length) {
  Estimate estimate;
  estimate.value = kDegrees * circularDeviation(length.value);
  if (length.lower > 0) {
    estimate.lower = kDegrees * circularDeviation(length.upper);
    estimate.upper = kDegrees * circularDeviation(length.lower);
  }
  return estimate;
}

void addVectors(ReportWork& work, const std::string& id, const std::vector<SubjectVectors>& conditions) {
  std::vector<EstimateRow> rows;
  const std::vector<TrialView> views = work.analysis.data.conditions.all();
  for (size_t i = 0; i < views.size(); ++i) {
    const std::string condition = conditionText(work, views[i]);
    const std::vector<MeanVector> vectors = listOf(conditions[i]);
    const Estimable<CircularMean> mean = circularMean(vectors);
    const std::string source =
        fmt::format("mean vectors of {} subjects, {}", vectors.size(), sizeText(conditions[i].trials));
    const auto add = [&](const char* what, const Estimable<Estimate>& estimate, const char* unit) {
      rows.push_back({fmt::format("{}, {}", condition, what), estimate, unit, source, conditions[i].trials});
    };
    const auto missing = Estimable<Estimate>::impossible(mean ? "" : mean.reason());
    add("mean direction of error", mean ? inDegrees(mean->direction) : missing, "degrees");
    add("mean resultant length", mean ? mean->length : missing, "");
    add("circular standard deviation",
        mean && mean->length ? Estimable<Estimate>(deviationOf(*mean->length))
                             : (mean ? Estimable<Estimate>::impossible(mean->length.reason()) : missing),
        "degrees");
    std::vector<double> lengths;
    for (const MeanVector& vector : vectors) {
      lengths.push_back(vector.length());
    }
    const Estimable<Estimate> within = studentMean(lengths);
    if (within) {
      Estimate untestedLength = *within;
      untestedLength.upper = std::min(untestedLength.upper, 1.0);
      untestedLength.lower = std::max(untestedLength.lower, 0.0);
      untestedLength.statistic = untestedLength.pValue = kNotKnown;
      add("resultant length within a subject", untestedLength, "");
    }
  }
  addEstimates(work.document,
               "Mean vectors of errors by condition: each subject counts with its mean vector; intervals for other "
               "subjects (Fieller's of directions, Student's of lengths)",
               fmt::format("{}-vectors", id), rows);
}

void addUniformity(ReportWork& work, const std::string& id, const std::vector<SubjectVectors>& conditions) {
  std::vector<EstimateRow> rows;
  const std::vector<TrialView> views = work.analysis.data.conditions.all();
  for (size_t i = 0; i < views.size(); ++i) {
    std::vector<double> directions;
    for (const auto& [subject, vector] : conditions[i].bySubject) {
      directions.push_back(vector.direction());
    }
    const std::string condition = conditionText(work, views[i]);
    const std::string source = fmt::format("mean directions of the errors of {} subjects", directions.size());
    rows.push_back({fmt::format("{}, Rayleigh: resultant length of subjects' mean directions", condition),
                    rayleighTest(directions), "", source, conditions[i].trials});
    rows.push_back({fmt::format("{}, V test: component towards no error", condition), vTest(directions, 0), "", source,
                    conditions[i].trials});
  }
  for (EstimateRow& row : rows) {
    if (row.estimate) {
      // A statistic of these has no name in the column of statistics, which is of t and z.
      Estimate estimate = *row.estimate;
      estimate.statistic = kNotKnown;
      row.estimate = estimate;
    }
  }
  addEstimates(work.document,
               "Whether subjects point in some direction rather than any (Rayleigh), and towards the truth (V, "
               "one-sided): each subject counts once, with its mean direction; p values are not corrected",
               fmt::format("{}-uniformity", id), rows);
}

/// Each condition with the first: subjects who have both.
void addVectorDifferences(ReportWork& work, const std::string& id, const std::vector<SubjectVectors>& conditions) {
  std::vector<ConditionComparison> directions;
  std::vector<ConditionComparison> lengths;
  std::vector<ConditionComparison> both;
  const std::vector<TrialView> views = work.analysis.data.conditions.all();
  for (size_t i = 1; i < views.size(); ++i) {
    std::vector<MeanVector> first;
    std::vector<MeanVector> second;
    for (const auto& [subject, vector] : conditions[i].bySubject) {
      if (const auto before = conditions[0].bySubject.find(subject); before != conditions[0].bySubject.end()) {
        first.push_back(before->second);
        second.push_back(vector);
      }
    }
    TrialList trials = conditions[0].trials;
    trials.insert(trials.end(), conditions[i].trials.begin(), conditions[i].trials.end());
    const std::string label = fmt::format("{} less {}", conditionText(work, views[i]), conditionText(work, views[0]));
    directions.push_back({label, inDegrees(directionDifference(first, second)), trials});
    lengths.push_back({label, lengthDifference(first, second), trials});
    Estimable<Estimate> test = hotellingDifference(first, second);
    if (test) {
      Estimate estimate = *test;
      estimate.statistic = estimate.degreesOfFreedom = kNotKnown;
      test = estimate;
    }
    both.push_back({label, test, trials});
  }
  const std::string source = "mean vectors of subjects with both conditions";
  addComparisons(work, "Differences of mean directions of error, within subjects", fmt::format("{}-turned", id),
                 "degrees", source, directions);
  addComparisons(work, "Differences of mean resultant lengths, within subjects", fmt::format("{}-lengths", id), "",
                 source, lengths);
  addComparisons(work,
                 "Whether mean vectors differ at all, in direction or length: length of the mean difference, p by "
                 "Hotelling's test of pairs (F of 2 and n - 2 degrees of freedom)",
                 fmt::format("{}-hotelling", id), "", source, both);
  if (views.size() > 1) {
    work.document.add(ReportNote{NoteKind::kNote,
                                 "Watson and Williams' test is not used: it takes directions of different conditions "
                                 "as independent, and those of "
                                 "a subject are not."});
  }
}

void addMirrored(ReportWork& work, const std::string& id, const EstimateTrials& estimates) {
  struct Kind {
    const char* name;
    std::optional<bool> (*of)(const MirroredEstimate& estimate);
  };
  static constexpr Kind kKinds[] = {
      {"front half", [](const MirroredEstimate& each) { return std::optional(each.isFront); }},
      {"front and back reversed", [](const MirroredEstimate& each) { return each.isFrontBack; }},
      {"left and right reversed", [](const MirroredEstimate& each) { return each.isLeftRight; }},
      {"off by more than 90 degrees",
       [](const MirroredEstimate& each) { return std::optional(each.isBeyondQuarter); }}};
  std::vector<EstimateRow> rows;
  for (const TrialView view : work.analysis.data.conditions.all()) {
    for (const Kind& kind : kKinds) {
      TrialValues values;
      for (size_t i = 0; i < estimates.trials.size(); ++i) {
        const std::optional<bool> is = kind.of(mirroredEstimate(estimates.values[i]));
        if (estimates.trials[i]->view == view && is) {
          values.push_back({estimates.trials[i], *is ? 1.0 : 0.0});
        }
      }
      rows.push_back(untested(rowOfSubjects(fmt::format("{}, {}", conditionText(work, view), kind.name),
                                            subjectMeans(values), ValueScale::kShare, "shares")));
    }
  }
  addEstimates(work.document,
               fmt::format("Where estimates point to, as shares (mean over subjects), if 0 degrees is straight ahead; "
                           "reversals are of truths more than {:g} degrees from the axis that they are mirrored at",
                           kMirrorMargin),
               fmt::format("{}-mirrored", id), rows);
}

void addRoses(ReportWork& work, const std::string& id, const std::vector<SubjectVectors>& conditions) {
  RosePlot plot;
  plot.title = "Errors of directions";
  const std::vector<TrialView> views = work.analysis.data.conditions.all();
  for (size_t i = 0; i < views.size(); ++i) {
    RosePlot::Condition condition;
    condition.name = labelOf(work, views[i]);
    condition.degrees = conditions[i].errors;
    for (const auto& [subject, vector] : conditions[i].bySubject) {
      condition.subjects.push_back({kDegrees * vector.direction(), vector.length()});
    }
    if (!condition.subjects.empty()) {
      const MeanVector mean = meanVector(listOf(conditions[i]));
      condition.mean = RosePlot::Vector{kDegrees * mean.direction(), mean.length()};
    }
    if (const Estimable<CircularMean> mean = circularMean(listOf(conditions[i])); mean && mean->direction) {
      condition.interval = {kDegrees * mean->direction->lower, kDegrees * mean->direction->upper};
    }
    plot.conditions.push_back(std::move(condition));
  }
  addFigure(work,
            "Errors of directions (degrees, clockwise; 0 is the truth): areas are in proportion to shares of trials, "
            "dots are mean vectors of subjects, the arrow is their mean, the arc its 95 % interval",
            fmt::format("figure-{}-roses", id), [&] { return roseFigure(plot); });
}

}  // namespace

MirroredEstimate mirroredEstimate(const EstimatedValue& value) {
  const auto ahead = [](double degrees) { return std::cos(degrees / kDegrees); };
  const auto right = [](double degrees) { return std::sin(degrees / kDegrees); };
  const double margin = std::sin(kMirrorMargin / kDegrees);
  MirroredEstimate result;
  result.isFront = ahead(value.estimate) >= 0;
  if (std::abs(ahead(value.truth)) > margin) {
    result.isFrontBack = ahead(value.truth) * ahead(value.estimate) < 0;
  }
  if (std::abs(right(value.truth)) > margin) {
    result.isLeftRight = right(value.truth) * right(value.estimate) < 0;
  }
  result.isBeyondQuarter = std::abs(value.signedError()) > 90;
  return result;
}

void addDirectionSection(ReportWork& work, const std::string& id, const EstimateTrials& estimates) {
  std::vector<SubjectVectors> conditions;
  for (const TrialView view : work.analysis.data.conditions.all()) {
    conditions.push_back(vectorsOf(estimates, view));
  }
  addVectors(work, id, conditions);
  addRoses(work, id, conditions);
  addUniformity(work, id, conditions);
  addVectorDifferences(work, id, conditions);
  addMirrored(work, id, estimates);
}

}  // namespace ocelli
