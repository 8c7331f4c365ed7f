#include "analysis/report/resampled_caution.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace ocelli {
namespace {

constexpr double kMinWidthRatio = 2.0 / 3;

bool holdsNoEffect(const Estimate& estimate) {
  return estimate.lower <= 0 && 0 <= estimate.upper;
}

}  // namespace

std::string resampledCaution(const Estimate& view, const Estimate& resampled, double perUnit) {
  const double model = view.upper - view.lower;
  const double bootstrap = (resampled.upper - resampled.lower) * perUnit;
  if (!std::isfinite(model) || !std::isfinite(bootstrap) || !(model > 0) || !(bootstrap > 0)) {
    return "";
  }
  std::string caution;
  if (std::min(model, bootstrap) < kMinWidthRatio * std::max(model, bootstrap)) {
    caution =
        fmt::format("the interval of the view by resampling subjects and cases is {:.2g} times as wide as the model's",
                    bootstrap / model);
  }
  if (holdsNoEffect(view) != holdsNoEffect(resampled)) {
    caution +=
        fmt::format("{}{} excludes that the views are alike, and {} does not", caution.empty() ? "" : "; ",
                    holdsNoEffect(view) ? "resampling" : "the model", holdsNoEffect(view) ? "the model" : "resampling");
  }
  return caution;
}

void addResampledCaution(ReportWork& work, const PlannedModel& model, const Estimable<Estimate>& view,
                         const Estimable<BootstrapResult>& resampled, double perUnit) {
  if (!view || !resampled) {
    return;
  }
  const std::string caution = resampledCaution(*view, resampled->percentile, perUnit);
  if (!caution.empty()) {
    work.document.add(ReportNote{NoteKind::kWarning, fmt::format("The {} and the bootstrap disagree: {}. Say both.",
                                                                 wordsOf(model, false), caution)});
  }
}

}  // namespace ocelli
