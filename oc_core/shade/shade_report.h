// The figures of a comparison as a table to read, as JSON and as CSV.
#pragma once

#include <string>
#include <vector>

#include "oc_core/camera/view.h"
#include "oc_core/shade/effect.h"

namespace ocelli {

struct ShadeReport {
  std::string scene;
  const Effect& effect;
  std::string version = {};
  View view = {};      ///< of the picture
  glm::ivec2 size{0};  ///< of the picture, pixels
  int runs = 1;
  std::vector<ShadeFact> facts = {};
  std::vector<ShadedWay> ways = {};  ///< each with a figure a column of the effect
};

/// The columns that tables show, as indices of Effect::columns: those with a heading of which a way has a figure.
std::vector<size_t> shownColumns(const ShadeReport& report);
/// As tables show it; "-" where there is none.
std::string textOf(const FigureColumn& column, const std::optional<double>& figure);

std::string shadeTable(const ShadeReport& report);
std::string shadeJson(const ShadeReport& report);
/// A line a way.
std::string shadeCsv(const ShadeReport& report);

}  // namespace ocelli
