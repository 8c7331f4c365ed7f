// Answers on scales of two or more steps. Where the scale compares the views, as bars that part at the middle of the
// scale: to the left those below, to the right those above. Else as bars of all answers.
//
//   Robbins and Heiberger 2011    Plotting Likert and other rating scales
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "analysis/plot/style.h"
#include "oc_core/drawing/figure.h"

namespace ocelli {

struct RatingPlot {
  struct Question {
    std::string text;
    std::vector<size_t> counts{};  ///< of each step
    double mean = 0;               ///< on the scale, as it is written beside the bar
  };

  std::string title;
  std::vector<std::string> steps{"1", "2", "3", "4", "5"};  ///< what each step is called: short
  std::string lowest{};                                     ///< what the first step means; may be empty
  std::string highest{};                                    ///< and the last
  bool parted = true;                                       ///< the scale compares the views
  bool lastIsOther = true;                                  ///< the last step speaks for the second view: its colours
  std::vector<Question> questions;
  double widthMillimetres = kDoubleColumnMillimetres;
};

/// Questions without answers are left out. Throws InputError where a question has not one count a step.
Figure ratingFigure(const RatingPlot& plot);

}  // namespace ocelli
