#include "analysis/plot/binned_residual_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "analysis/plot/chart_text.h"
#include "analysis/plot/panel.h"

namespace ocelli {
namespace {

constexpr double kBinnedHeight = 185;
constexpr size_t kMaxBins = 40;

}  // namespace

std::vector<ResidualBin> residualBins(const std::vector<double>& fitted, const std::vector<bool>& successes) {
  std::vector<size_t> order(fitted.size());
  std::iota(order.begin(), order.end(), size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) { return fitted[a] < fitted[b]; });
  const auto root = static_cast<size_t>(std::sqrt(static_cast<double>(order.size())));
  const size_t bins = std::clamp<size_t>(root, order.empty() ? 0 : 1, kMaxBins);
  std::vector<ResidualBin> result;
  for (size_t bin = 0; bin < bins; ++bin) {
    ResidualBin mean;
    double variance = 0;
    for (size_t i = order.size() * bin / bins; i < order.size() * (bin + 1) / bins; ++i) {
      const double probability = fitted[order[i]];
      mean.fitted += probability;
      mean.residual += (successes[order[i]] ? 1 : 0) - probability;
      variance += probability * (1 - probability);
      ++mean.count;
    }
    const auto count = static_cast<double>(mean.count);
    mean.fitted /= count;
    mean.residual /= count;
    mean.bound = 2 * std::sqrt(variance) / count;
    result.push_back(mean);
  }
  return result;
}

Figure binnedResidualFigure(const BinnedResidualPlot& plot) {
  const std::vector<ResidualBin> bins = residualBins(plot.fitted, plot.successes);
  if (bins.empty()) {
    return emptyFigure(plot.title, plot.widthMillimetres, "the model has no residuals");
  }
  std::vector<double> x;
  std::vector<double> y{0};
  for (const ResidualBin& bin : bins) {
    x.push_back(bin.fitted);
    y.insert(y.end(), {bin.residual, bin.bound, -bin.bound});
  }
  const auto outside =
      std::count_if(bins.begin(), bins.end(), [](const auto& bin) { return std::abs(bin.residual) > bin.bound; });
  Figure figure{plot.title, "", plot.widthMillimetres * kPointsPerMillimetre, kBinnedHeight, {}};
  figure.description = fmt::format(
      "{} trials in {} bins of similar fitted probabilities, random effects included: share of right answers less mean "
      "probability. {} of the bins lie outside two standard errors, where about one in twenty would by chance.",
      plot.fitted.size(), bins.size(), outside);
  AxisRange xRange = AxisRange::of(x);
  xRange.percent = true;
  const Panel panel(figure.drawing, {0, 0, figure.width, kBinnedHeight},
                    AxisSpec::ofValues("Fitted probability of a right answer", xRange, false),
                    AxisSpec::ofValues("Mean residual", AxisRange::of(y)));
  std::vector<PlotPoint> outline;
  for (const ResidualBin& bin : bins) {
    outline.push_back(panel.at(bin.fitted, bin.bound));
  }
  for (auto bin = bins.rbegin(); bin != bins.rend(); ++bin) {
    outline.push_back(panel.at(bin->fitted, -bin->bound));
  }
  figure.drawing.path("band", {{outline}, true, kAxisPaint.faded(0.14), std::nullopt});
  figure.drawing.line("reference", panel.at(panel.xAxis().low(), 0), panel.at(panel.xAxis().high(), 0),
                      {kReferencePaint, kLine, {3, 2}});
  for (const ResidualBin& bin : bins) {
    figure.drawing.marker("point", {panel.at(bin.fitted, bin.residual), Marker::kCircle, kSummaryRadius,
                                    seriesStyle(1).paint, std::nullopt});
  }
  return figure;
}

}  // namespace ocelli
