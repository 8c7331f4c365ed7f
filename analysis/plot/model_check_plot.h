// Whether a model's assumptions hold, for the eye: residuals against fitted values, and their quantiles against those
// of a normal distribution.
#pragma once

#include <string>
#include <vector>

#include "analysis/plot/style.h"
#include "oc_core/drawing/figure.h"

namespace ocelli {

struct ModelCheckPlot {
  std::string title;
  std::vector<double> fitted;
  std::vector<double> residuals;  ///< as many; standardised ones, where the model has them
  std::string fittedLabel = "Fitted value";
  std::string residualLabel = "Residual";
  double widthMillimetres = kDoubleColumnMillimetres;
};

Figure modelCheckFigure(const ModelCheckPlot& plot);

/// Values that a model takes as normal, such as random effects, against normal quantiles: a panel each, two a row.
struct QuantilePlot {
  struct Panel {
    std::string label;
    std::vector<double> values;
  };

  std::string title;
  std::vector<Panel> panels;
  double widthMillimetres = kDoubleColumnMillimetres;
};

Figure quantileFigure(const QuantilePlot& plot);

/// What the k-th of n (k from 0) of a sorted standard normal sample lies between in 95 % of samples, and in the middle:
/// by the beta distribution of uniform order statistics.
struct NormalOrder {
  double lower = 0;
  double median = 0;
  double upper = 0;
};
NormalOrder normalOrder(size_t k, size_t n);

}  // namespace ocelli
