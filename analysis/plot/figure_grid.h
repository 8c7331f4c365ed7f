// Several charts of the same series as one figure: a title above each, one legend above them all.
#pragma once

#include <string>
#include <vector>

#include "analysis/plot/panel.h"
#include "oc_core/drawing/figure.h"

namespace ocelli {

inline constexpr double kGridGapPoints = 12;

struct FigureGrid {
  std::string title;
  std::vector<LegendEntry> legend;
  std::vector<Figure> figures;  ///< row by row; their own titles stand above them
  size_t columns = 2;
  double widthMillimetres = kDoubleColumnMillimetres;

  /// That charts must have to fill it.
  double columnMillimetres() const;
};

Figure gridFigure(const FigureGrid& grid);

}  // namespace ocelli
