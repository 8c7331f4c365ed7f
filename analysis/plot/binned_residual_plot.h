// Whether a model of answers that are right or wrong gives them the right probabilities, for the eye: each point is the
// mean residual of trials with similar probabilities.
//
//   Gelman and Hill 2007, section 5.6   binned residuals, and twice their standard error
#pragma once

#include <string>
#include <vector>

#include "analysis/plot/style.h"
#include "oc_core/drawing/figure.h"

namespace ocelli {

struct BinnedResidualPlot {
  std::string title;
  std::vector<double> fitted;   ///< probabilities
  std::vector<bool> successes;  ///< as many
  double widthMillimetres = kDoubleColumnMillimetres;
};

Figure binnedResidualFigure(const BinnedResidualPlot& plot);

struct ResidualBin {
  double fitted = 0;    ///< mean probability
  double residual = 0;  ///< share of successes less that
  double bound = 0;     ///< two standard errors of the residual if the probabilities are right
  size_t count = 0;
};
/// As many bins as the root of the number of trials, at most 40, of about as many trials each, by probability.
std::vector<ResidualBin> residualBins(const std::vector<double>& fitted, const std::vector<bool>& successes);

}  // namespace ocelli
