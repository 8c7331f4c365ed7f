// One of each chart, of made-up data: for tests of them all, and to look at (plot_gallery).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "analysis/plot/figure_grid.h"
#include "analysis/plot/forest_plot.h"
#include "analysis/plot/group_plot.h"
#include "analysis/plot/heat_map.h"
#include "analysis/plot/survival_plot.h"
#include "oc_core/drawing/figure.h"

namespace ocelli {

/// Numbers that are the same everywhere.
class SampleNumbers {
 public:
  explicit SampleNumbers(uint64_t seed) : state_(seed) {}

  double uniform();
  double normal();

 private:
  uint64_t state_;
};

struct SampleFigure {
  std::string name;
  Figure figure;
};

GroupPlot sampleLearning();
GroupPlot sampleCases();
FigureGrid sampleGrid();
SurvivalPlot sampleSurvival();
ForestPlot sampleForest();
HeatMap sampleHeat();

std::vector<SampleFigure> sampleFigures();

/// Each chart without any data.
std::vector<SampleFigure> emptyFigures();

/// Each chart with as little data as there can be, some of it NaN.
std::vector<SampleFigure> tinyFigures();

}  // namespace ocelli
