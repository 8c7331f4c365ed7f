// The way of the subjects through the study, as CONSORT wants it: boxes from the top down, and to the right who left,
// with the reasons.
//
//   Schulz, Altman, Moher 2010    CONSORT 2010 statement
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "analysis/plot/style.h"
#include "oc_core/drawing/figure.h"

namespace ocelli {

struct FlowDiagram {
  struct Loss {
    std::string reason;
    size_t count = 0;
  };
  struct Stage {
    std::string label;  ///< "Took part"
    size_t count = 0;
    std::string unit = "subjects";
    std::vector<Loss> lost = {};  ///< between this stage and the next
  };

  std::string title;
  std::vector<Stage> stages;
  double widthMillimetres = kDoubleColumnMillimetres;
};

Figure flowFigure(const FlowDiagram& diagram);

}  // namespace ocelli
