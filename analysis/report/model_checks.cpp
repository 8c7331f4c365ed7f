#include "analysis/report/model_checks.h"

#include <fmt/format.h>

#include "analysis/plot/binned_residual_plot.h"
#include "analysis/plot/model_check_plot.h"
#include "analysis/report/part_guard.h"

namespace ocelli {
namespace {

void addRandomEffects(ReportWork& work, const PlannedModel& model, const PlannedFit& fit) {
  QuantilePlot plot;
  plot.title = fmt::format("Random effects of the {}", wordsOf(model, false));
  for (const RandomEffectValues& effects : fit.effects) {
    plot.panels.push_back({withLabels(work, effects.name), effects.values});
  }
  addFigure(work,
            fmt::format(
                "{}: predictions for each level, against normal quantiles. Predictions are drawn in towards 0 where a "
                "level has few trials",
                plot.title),
            fmt::format("figure-{}-effects", model.name), [&] { return quantileFigure(plot); });
}

}  // namespace

void addLinearChecks(ReportWork& work, const PlannedModel& model, const PlannedFit& fit,
                     const std::string& fittedLabel) {
  const InSupplement supplement(work.document);
  ModelCheckPlot plot;
  plot.title = fmt::format("Residuals of the {}", wordsOf(model, false));
  plot.fitted = fit.fitted;
  plot.fittedLabel = fittedLabel;
  plot.residualLabel = "Standardised residual";
  for (const double residual : fit.residuals) {
    plot.residuals.push_back(residual / fit.residualDeviation);
  }
  addFigure(work, fmt::format("{}, over their standard deviation", plot.title),
            fmt::format("figure-{}-residuals", model.name), [&] { return modelCheckFigure(plot); });
  addRandomEffects(work, model, fit);
}

void addBinomialChecks(ReportWork& work, const PlannedModel& model, const TrialList& trials, const PlannedFit& fit) {
  const InSupplement supplement(work.document);
  BinnedResidualPlot plot;
  plot.title = fmt::format("Binned residuals of the {}", wordsOf(model, false));
  plot.fitted = fit.fitted;
  for (const Trial* trial : trials) {
    plot.successes.push_back(trial->correct.value_or(false));
  }
  addFigure(
      work,
      fmt::format("{}; the band holds about 95 % of the points where the model's probabilities are right", plot.title),
      fmt::format("figure-{}-residuals", model.name), [&] { return binnedResidualFigure(plot); });
  addRandomEffects(work, model, fit);
}

}  // namespace ocelli
