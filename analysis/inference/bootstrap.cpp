#include "analysis/inference/bootstrap.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/base/distributions.h"
#include "analysis/inference/sample.h"
#include "analysis/inference/wald.h"
#include "oc_core/base/parallel.h"
#include "oc_core/base/random_numbers.h"

namespace ocelli {
namespace {

constexpr size_t kFewestResamples = 100;
constexpr double kMaxNotEstimable = 0.5;

/// The rows of a study by subject, with their cases.
class Design {
 public:
  Design(const std::vector<int>& subjects, const std::vector<int>& cases)
      : subjects_(denseLabels(subjects)), cases_(denseLabels(cases)), rows_(subjects_.count) {
    for (size_t row = 0; row < subjects.size(); ++row) {
      rows_[subjects_.of[row]].push_back(row);
    }
  }

  size_t subjectCount() const { return subjects_.count; }
  size_t caseCount() const { return cases_.count; }

  std::vector<ResampledRow> all() const {
    return drawn(std::vector<size_t>(subjects_.count, 1), std::vector<size_t>(cases_.count, 1));
  }

  std::vector<ResampledRow> resample(RandomNumbers& random) const {
    const std::vector<size_t> subjectTimes = timesDrawn(subjects_.count, random);
    return drawn(subjectTimes, timesDrawn(cases_.count, random));
  }

  std::vector<ResampledRow> withoutSubject(size_t subject) const {
    std::vector<size_t> times(subjects_.count, 1);
    times[subject] = 0;
    return drawn(times, std::vector<size_t>(cases_.count, 1));
  }

  std::vector<ResampledRow> withoutCase(size_t caseIndex) const {
    std::vector<size_t> times(cases_.count, 1);
    times[caseIndex] = 0;
    return drawn(std::vector<size_t>(subjects_.count, 1), times);
  }

 private:
  static std::vector<size_t> timesDrawn(size_t count, RandomNumbers& random) {
    std::vector<size_t> times(count);
    for (size_t i = 0; i < count; ++i) {
      ++times[random.below(count)];
    }
    return times;
  }

  /// Each subject and case so many times.
  std::vector<ResampledRow> drawn(const std::vector<size_t>& subjectTimes, const std::vector<size_t>& caseTimes) const {
    std::vector<size_t> firstCopy(caseTimes.size());  // number of the first copy of each case
    for (size_t i = 1; i < caseTimes.size(); ++i) {
      firstCopy[i] = firstCopy[i - 1] + caseTimes[i - 1];
    }
    std::vector<ResampledRow> rows;
    rows.reserve(subjects_.of.size() * 2);
    int subject = 0;
    for (size_t i = 0; i < subjectTimes.size(); ++i) {
      for (size_t copy = 0; copy < subjectTimes[i]; ++copy, ++subject) {
        for (const size_t row : rows_[i]) {
          if (caseTimes.empty()) {
            rows.push_back({row, subject, 0});
            continue;
          }
          const size_t caseIndex = cases_.of[row];
          for (size_t k = 0; k < caseTimes[caseIndex]; ++k) {
            rows.push_back({row, subject, static_cast<int>(firstCopy[caseIndex] + k)});
          }
        }
      }
    }
    return rows;
  }

  DenseLabels subjects_;
  DenseLabels cases_;
  std::vector<std::vector<size_t>> rows_;
};

/// Between sorted values, as (n + 1) p counts: Hyndman and Fan's type 6.
double quantileOfSorted(const std::vector<double>& sorted, double probability) {
  const double place = (static_cast<double>(sorted.size()) + 1) * probability - 1;
  const double inside = std::clamp(place, 0.0, static_cast<double>(sorted.size() - 1));
  const auto below = static_cast<size_t>(inside);
  const size_t above = std::min(below + 1, sorted.size() - 1);
  const double share = inside - static_cast<double>(below);
  return sorted[below] + share * (sorted[above] - sorted[below]);
}

std::vector<std::optional<double>> computeAll(size_t count, const std::function<std::optional<double>(size_t)>& one) {
  std::vector<std::optional<double>> values(count);
  parallelFor(count, 1, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      values[i] = one(i);
      if (values[i] && !std::isfinite(*values[i])) {
        values[i].reset();
      }
    }
  });
  return values;
}

/// By how much the statistic falls if a unit is left out, as its share in the deviation; nothing where one is
/// indispensable.
std::optional<std::vector<double>> leaveOneOutInfluences(size_t units,
                                                         const std::function<std::optional<double>(size_t)>& without) {
  std::vector<double> values;
  for (const std::optional<double>& value : computeAll(units, without)) {
    if (!value) {
      return std::nullopt;
    }
    values.push_back(*value);
  }
  const double mean = momentsOf(values).mean;
  const double factor = static_cast<double>(units - 1) / static_cast<double>(units);
  for (double& value : values) {
    value = factor * (mean - value);
  }
  return values;
}

Estimable<Estimate> bcaOf(const Design& design, const BootstrapStatistic& statistic, const std::vector<double>& values,
                          double estimate, double level) {
  std::optional<std::vector<double>> influences = leaveOneOutInfluences(
      design.subjectCount(), [&](size_t subject) { return statistic(design.withoutSubject(subject)); });
  if (influences && design.caseCount() > 0) {
    const std::optional<std::vector<double>> ofCases = leaveOneOutInfluences(
        design.caseCount(), [&](size_t caseIndex) { return statistic(design.withoutCase(caseIndex)); });
    if (ofCases) {
      influences->insert(influences->end(), ofCases->begin(), ofCases->end());
    } else {
      influences.reset();
    }
  }
  if (!influences) {
    return Estimable<Estimate>::impossible("without one of the subjects or cases the data do not give the statistic");
  }
  return bcaInterval(values, estimate, *influences, level);
}

}  // namespace

Estimable<Estimate> bcaInterval(std::vector<double> values, double estimate, const std::vector<double>& influences,
                                double level) {
  std::sort(values.begin(), values.end());
  const auto [from, to] = std::equal_range(values.begin(), values.end(), estimate);
  const auto count = static_cast<double>(values.size());
  // Values that equal the estimate lie half on either side.
  const double below = (static_cast<double>(from - values.begin()) + static_cast<double>(to - from) / 2) / count;
  if (below <= 0 || below >= 1) {
    return Estimable<Estimate>::impossible("all resamples lie on one side of the estimate");
  }
  double squares = 0, cubes = 0;
  for (const double influence : influences) {
    squares += influence * influence;
    cubes += influence * influence * influence;
  }
  const double bias = normalQuantile(below);
  const double acceleration = squares > 0 ? cubes / (6 * std::pow(squares, 1.5)) : 0;
  const auto bound = [&](double probability) {
    const double z = bias + normalQuantile(probability);
    return quantileOfSorted(values, normalProbability(bias + z / (1 - acceleration * z)));
  };
  Estimate result;
  result.value = estimate;
  result.standardError = std::sqrt(momentsOf(values).variance);
  result.lower = bound((1 - level) / 2);
  result.upper = bound((1 + level) / 2);
  return result;
}

Estimable<BootstrapResult> bootstrap(const std::vector<int>& subjects, const std::vector<int>& cases,
                                     const BootstrapStatistic& statistic, const BootstrapPlan& plan) {
  using Result = Estimable<BootstrapResult>;
  const bool crossed = plan.units == ResampledUnits::kSubjectsAndCases;
  requireArgument(cases.size() == subjects.size() || (cases.empty() && !crossed), "subjects and cases differ in number",
                  "bootstrap");
  requireArgument(plan.resamples >= kFewestResamples, "there are too few resamples", "bootstrap");
  requireArgument(plan.level > 0 && plan.level < 1, "the level is not between 0 and 1", "bootstrap");
  const Design design(subjects, crossed ? cases : std::vector<int>());
  if (design.subjectCount() < 2 || (crossed && design.caseCount() < 2)) {
    return Result::impossible(
        fmt::format("there is only one {} to draw from", design.subjectCount() < 2 ? "subject" : "case"));
  }
  const std::optional<double> estimate = statistic(design.all());
  if (!estimate || !std::isfinite(*estimate)) {
    return Result::impossible("the data do not give the statistic");
  }
  std::vector<double> values;
  for (const std::optional<double>& value : computeAll(plan.resamples, [&](size_t i) {
         RandomNumbers random(plan.seed, i);
         return statistic(design.resample(random));
       })) {
    if (value) {
      values.push_back(*value);
    }
  }
  const double notEstimable = 1 - static_cast<double>(values.size()) / static_cast<double>(plan.resamples);
  if (notEstimable > kMaxNotEstimable) {
    return Result::impossible(fmt::format("{:.0f} % of the resamples do not give the statistic", 100 * notEstimable));
  }
  const SampleMoments moments = momentsOf(values);
  if (moments.variance == 0) {
    return Result::impossible("all resamples give the same");
  }
  BootstrapResult result{{},
                         bcaOf(design, statistic, values, *estimate, plan.level),
                         notEstimable,
                         plan.resamples,
                         design.subjectCount(),
                         design.caseCount()};
  std::sort(values.begin(), values.end());
  result.percentile.value = *estimate;
  result.percentile.standardError = std::sqrt(moments.variance);
  result.percentile.lower = quantileOfSorted(values, (1 - plan.level) / 2);
  result.percentile.upper = quantileOfSorted(values, (1 + plan.level) / 2);
  return result;
}

}  // namespace ocelli
