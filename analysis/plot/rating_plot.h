// Answers on a scale of 1 to 5, as bars that part at the middle answer: to the left those below, to the right those
// above.
//
//   Robbins and Heiberger 2011    Plotting Likert and other rating scales
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "analysis/plot/figure.h"
#include "analysis/plot/style.h"

namespace ocelli {

struct RatingPlot {
  struct Question {
    std::string text;
    std::array<size_t, 5> counts{};  ///< of the answers 1 to 5
  };

  std::string title;
  std::string lowest = "1: ppc was easier";
  std::string highest = "5: gc was easier";
  std::vector<Question> questions;
  double widthMillimetres = kDoubleColumnMillimetres;
};

Figure ratingFigure(const RatingPlot& plot);

}  // namespace ocelli
