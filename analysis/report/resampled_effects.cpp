#include "analysis/report/resampled_effects.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "analysis/inference/censored_difference.h"
#include "analysis/inference/sample.h"

namespace ocelli {
namespace {

/// With n units the spread of resamples is too small by a factor of about the root of (n - 1) / n, and quantiles of few
/// different resamples are coarse.
constexpr size_t kFewUnits = 10;

}  // namespace

BootstrapPlan bootstrapPlanOf(const AnalysisPlan& plan) {
  return {plan.seed, static_cast<size_t>(plan.bootstrapSamples), ResampledUnits::kSubjectsAndCases};
}

std::vector<int> caseNumbers(const TrialList& trials) {
  std::vector<std::string> items;
  items.reserve(trials.size());
  for (const Trial* trial : trials) {
    items.push_back(trial->item());
  }
  return numbered(items);
}

Estimable<BootstrapResult> bootstrapContrast(const TrialList& trials, const std::vector<double>& values,
                                             const std::vector<int>& groups, const std::vector<double>& weights,
                                             const BootstrapPlan& plan) {
  const BootstrapStatistic contrast = [&](const std::vector<ResampledRow>& rows) -> std::optional<double> {
    std::vector<double> sums(weights.size());
    std::vector<double> counts(weights.size());
    for (const ResampledRow& row : rows) {
      if (const int group = groups[row.row]; group >= 0) {
        sums[static_cast<size_t>(group)] += values[row.row];
        counts[static_cast<size_t>(group)] += 1;
      }
    }
    double above = 0;  // of groups with positive weights, and with negative ones
    double below = 0;
    for (size_t group = 0; group < weights.size(); ++group) {
      if (weights[group] != 0) {
        if (counts[group] == 0) {
          return std::nullopt;
        }
        const double part = weights[group] * sums[group] / counts[group];
        (weights[group] > 0 ? above : below) += part;
      }
    }
    return differenceOf(-below, above);
  };
  return bootstrap(numbered(subjectsOf(trials)), caseNumbers(trials), contrast, plan);
}

Estimable<BootstrapResult> bootstrapViewDifference(const TrialList& trials, const std::vector<double>& values,
                                                   const BootstrapPlan& plan) {
  std::vector<int> groups;
  for (const Trial* trial : trials) {
    groups.push_back(trial->view == TrialView::kOther ? 1 : 0);
  }
  return bootstrapContrast(trials, values, groups, {-1, 1}, plan);
}

Estimable<BootstrapResult> bootstrapCensoredViewDifference(const TrialList& trials, const std::vector<double>& values,
                                                           const std::vector<bool>& censored,
                                                           const BootstrapPlan& plan) {
  if (std::find(censored.begin(), censored.end(), true) == censored.end()) {
    return bootstrapViewDifference(trials, values, plan);
  }
  const BootstrapStatistic difference = [&](const std::vector<ResampledRow>& rows) {
    std::array<CensoredSums, 2> views;
    for (const ResampledRow& row : rows) {
      views[trials[row.row]->view == TrialView::kOther].add(values[row.row], censored[row.row]);
    }
    return censoredMeanDifference(views[0], views[1]);
  };
  return bootstrap(numbered(subjectsOf(trials)), caseNumbers(trials), difference, plan);
}

void addResampled(ReportWork& work, const std::string& caption, const std::string& id,
                  const std::vector<ResampledEffect>& effects) {
  std::vector<EstimateRow> rows;
  for (const ResampledEffect& effect : effects) {
    if (!effect.result) {
      rows.push_back({effect.label, Estimable<Estimate>::impossible(effect.result.reason()), effect.unit});
      continue;
    }
    const BootstrapResult& result = *effect.result;
    std::string source = fmt::format("{} resamples of {} subjects and {} cases, seed {}; {}", result.resamples,
                                     result.subjects, result.cases, work.analysis.plan.seed, sizeText(effect.trials));
    if (result.notEstimable > 0) {
      source += fmt::format("; {:.1f} % of the resamples gave nothing", 100 * result.notEstimable);
    }
    const auto shown = [&](const Estimate& estimate) {
      return effect.isLogarithm ? exponentiated(estimate) : estimate;
    };
    rows.push_back(
        {fmt::format("{}, percentiles", effect.label), shown(result.percentile), effect.unit, source, effect.trials});
    rows.push_back({fmt::format("{}, bias-corrected", effect.label),
                    result.bca ? Estimable<Estimate>(shown(*result.bca)) : result.bca, effect.unit, source,
                    effect.trials});
  }
  addEstimates(work.document, caption, id, rows);
  for (const ResampledEffect& effect : effects) {
    if (effect.result && std::min(effect.result->subjects, effect.result->cases) < kFewUnits) {
      work.document.add(ReportNote{
          NoteKind::kWarning,
          fmt::format("{} subjects and {} cases are few to draw from: resampled intervals are too narrow for so few.",
                      effect.result->subjects, effect.result->cases)});
      break;
    }
  }
}

}  // namespace ocelli
