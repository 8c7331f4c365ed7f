#include "analysis/report/error_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "analysis/report/model_checks.h"
#include "analysis/report/part_guard.h"
#include "analysis/report/resampled_caution.h"
#include "analysis/report/resampled_effects.h"
#include "analysis/report/response_scale.h"
#include "analysis/report/sensitivity.h"

namespace ocelli {
namespace {

constexpr double kQuarterTurn = 90;
/// Above this share of errors beyond a quarter turn, wrapping pulls a linear mean towards 0.
constexpr double kManyLargeErrors = 0.05;
/// Rows that are fitted again without cases, at most: linear models take some microseconds a row.
constexpr size_t kMaxErrorRows = 2000000;

void addErrorSensitivity(ReportWork& work, const PlannedModel& model, const ResponseScale& scale,
                         const TrialList& trials) {
  Variants variants = variantsOf(trials, {{"All trials", trials}}, kMaxErrorRows);
  variants.notes.emplace_back(kFittedModelNote);
  SensitivityTable table{
      fmt::format("{}-sensitivity", model.name),
      fmt::format("The effect of the view in the {}, analysed in other ways", wordsOf(model, false)),
      fmt::format("{}, {}", scale.axis, scale.isRatio ? "@other@ / @reference@" : "@other@ less @reference@"),
      fmt::format("@other@: {}", scale.lowerSide), fmt::format("@other@: {}", scale.upperSide)};
  table.ratio = scale.isRatio;
  table.unit = scale.effectUnit;
  addSensitivity(work, table, variants, [&](const Variant& variant) {
    const Estimable<PlannedFit> fit = fitErrors(model, variant.trials);
    const Estimable<Estimate> view = fit ? viewLogarithm(*fit) : Estimable<Estimate>::impossible(fit.reason());
    return view ? Estimable<Estimate>(shownEffect(scale, *view)) : view;
  });
}

}  // namespace

TrialList trialsOfErrorModel(const PlannedModel& model, const TrialList& trials) {
  return completeTrials(model, estimatesIn(trials).trials);
}

Estimable<PlannedFit> fitErrors(const PlannedModel& model, const TrialList& trials) {
  const Estimable<ErrorResponse> response = errorResponse(model, trials);
  return response ? fitValues(model, trials, response->values) : Estimable<PlannedFit>::impossible(response.reason());
}

std::vector<std::string> notesOfErrors(const PlannedModel& model, const TrialList& trials,
                                       const ErrorResponse& response) {
  std::vector<std::string> notes;
  const EstimateUnit* unit = unitOfEstimates(trials);
  if (response.zeros > 0) {
    notes.push_back(
        fmt::format("{} of {} estimates are exact, and an error of 0 has no logarithm: the {} counts them with half of "
                    "the smallest "
                    "error above 0, which is {}.",
                    response.zeros, trials.size(), wordsOf(model, false),
                    unit->isDirection ? fmt::format("{:.3g} degrees", response.zeroAs)
                                      : fmt::format("{:.3g} %", 100 * std::expm1(response.zeroAs))));
  }
  if (model.kind == ModelKind::kSignedErrorMixed && unit != nullptr && unit->isDirection) {
    const auto large = std::count_if(response.values.begin(), response.values.end(),
                                     [](double error) { return std::abs(error) > kQuarterTurn; });
    if (static_cast<double>(large) > kManyLargeErrors * static_cast<double>(trials.size())) {
      notes.push_back(
          fmt::format("{} of {} errors are beyond {:g} degrees. The {} does not know that directions go around, and "
                      "such errors may "
                      "have either sign: go by the mean vectors instead.",
                      large, trials.size(), kQuarterTurn, wordsOf(model, false)));
    }
  }
  return notes;
}

void addErrorModel(ReportWork& work, const ReportTask& task, const PlannedModel& model, const TrialList& all) {
  const TrialList trials = trialsOfErrorModel(model, all);
  const Estimable<ErrorResponse> response = trials.empty()
                                                ? Estimable<ErrorResponse>::impossible("no trial holds an estimate")
                                                : errorResponse(model, trials);
  const ResponseScale& scale = responseScale(model, trials);
  const Estimable<PlannedFit> fit =
      response ? fitValues(model, trials, response->values) : Estimable<PlannedFit>::impossible(response.reason());
  addPlannedFit(
      work, model, trials, fit,
      fmt::format("Mixed model of {} of {}: {}, intervals and tests by Satterthwaite's degrees of freedom",
                  model.kind == ModelKind::kAbsoluteErrorMixed ? "the logarithm of absolute errors" : "signed errors",
                  task.trialsName, scale.several));
  if (!fit) {
    return;
  }
  for (const std::string& note : notesOfErrors(model, trials, *response)) {
    work.document.add(ReportNote{NoteKind::kWarning, note});
  }
  work.methods.push_back(
      fmt::format("{} of {} were compared by the mixed model {} with Satterthwaite's degrees of freedom; its random "
                  "effects are {}.",
                  model.kind == ModelKind::kAbsoluteErrorMixed ? "Logarithms of absolute errors" : "Signed errors",
                  task.trialsName, model.name, structureMethod(model, *fit)));
  const auto part = [&](const char* what, const std::function<void()>& add) {
    addPart(work, fmt::format("Model {}, {}", model.name, what), add);
  };
  part("checks", [&] { addLinearChecks(work, model, *fit, scale.fittedLabel); });
  part("resampled", [&] {
    const Estimable<BootstrapResult> resampled =
        bootstrapViewDifference(trials, response->values, bootstrapPlanOf(work.analysis.plan));
    const char* compared = scale.isRatio ? "@other@ / @reference@" : "@other@ less @reference@";
    addResampled(work, fmt::format("{} ({}) by resampling subjects and cases", scale.axis, compared),
                 fmt::format("{}-resampled", model.name),
                 {{compared, resampled, trials, scale.effectUnit, scale.isRatio}});
    addResampledCaution(work, model, viewLogarithm(*fit), resampled, 1);
  });
  part("other ways", [&] { addErrorSensitivity(work, fittedModel(model, *fit), scale, trials); });
}

}  // namespace ocelli
