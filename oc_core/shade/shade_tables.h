// The figures of a comparison as a table to read, as JSON and as CSV. The columns are described once, for the page too.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "oc_core/camera/view.h"
#include "oc_core/shade/shade_comparison.h"

namespace ocelli {

struct ShadeReport {
  std::string scene;
  std::string effect;
  std::string version = {};
  View view = {};           ///< of the picture
  glm::ivec2 size{0};       ///< of the picture, pixels
  View referenceView = {};  ///< of the reference images
  glm::ivec2 referenceSize{0};
  float cellSide = 0;  ///< that they are made for, world units
  int environmentHeight = 0;
  int runs = 1;
  std::vector<ShadeFigures> rows = {};
};

/// One figure of a row.
struct ShadeColumn {
  const char* field;    ///< in JSON and CSV
  const char* heading;  ///< in tables
  const char* meaning;
  int digits;    ///< behind the point, in tables
  double scale;  ///< in tables: 100 for what is a ratio
  /// Nothing where the row has no such figure.
  std::optional<double> (*value)(const ShadeFigures&);
};

const std::vector<ShadeColumn>& shadeColumns();
/// As tables show it; "-" where there is none.
std::string textOf(const ShadeColumn& column, const ShadeFigures& row);

std::string shadeTable(const ShadeReport& report);
std::string shadeJson(const ShadeReport& report);
/// A line a row.
std::string shadeCsv(const ShadeReport& report);

}  // namespace ocelli
