// The figures of reflections and refractions: one table that tables, JSON, CSV and the page follow from.
#pragma once

#include <optional>
#include <vector>

#include "oc_core/shade/effect.h"
#include "oc_core/shade/shade_comparison.h"

namespace ocelli {

inline constexpr uint32_t kBrightestSteps = 48;  ///< of maps of steps: the text's mean at its finest steps

struct SpecularFigure {
  FigureColumn column;
  std::optional<double> (*value)(const ShadeFigures& row);
};

const std::vector<SpecularFigure>& specularFigures();

}  // namespace ocelli
