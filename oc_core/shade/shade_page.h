// The page of a comparison: pictures side by side, where first hits are wrong, steps, and the table.
#pragma once

#include <string>
#include <vector>

#include "oc_core/shade/shade_tables.h"

namespace ocelli {

/// Files in the folder of the page.
struct ShadeImages {
  std::string picture;
  std::string errors;  ///< empty for what tells no distances, and for the traced picture
  std::string steps;   ///< empty for what takes none
};

/// The names of the images of a row: from its name, with what file names may not hold replaced, and its number.
ShadeImages shadeImageNames(const ShadeFigures& row, size_t number);

/// HTML without anything from the network; one of `images` a row of the report.
std::string shadePage(const ShadeReport& report, const std::vector<ShadeImages>& images, uint32_t brightestSteps);

}  // namespace ocelli
