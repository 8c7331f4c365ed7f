// Where in the maze: cells from pale to dark under its walls, one map for each view on a common scale.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "analysis/plot/style.h"
#include "oc_core/drawing/figure.h"

namespace ocelli {

struct HeatMap {
  struct Cell {
    double x = 0;  ///< of its middle, metres
    double y = 0;
    double value = 0;  ///< NaN and what is no cell stay white
  };
  struct Mark {
    double x = 0;
    double y = 0;
    std::string name;  ///< "start"
  };
  struct Map {
    std::string name;
    std::vector<Cell> cells;
    std::vector<Mark> marks;
  };

  std::string title;
  std::string valueLabel;  ///< "Share of the time"
  std::vector<Map> maps;
  std::vector<std::array<double, 4>> walls;  ///< x, y to x, y; the same in each map; y points downwards in the image
  double cellSize = 1;
  bool percent = false;
  bool rootScale = false;  ///< shades go with the square root of values: where a few cells have most
  double widthMillimetres = kDoubleColumnMillimetres;
};

Figure heatFigure(const HeatMap& map);

}  // namespace ocelli
