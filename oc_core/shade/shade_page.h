// The page of a comparison: pictures side by side, their maps, and the table.
#pragma once

#include <string>
#include <vector>

#include "oc_core/shade/shade_report.h"

namespace ocelli {

/// The names of the images of a way in the folder of the page: from its name, with what file names may not hold
/// replaced, and its number in the report.
struct ShadeImages {
  std::string picture;
  std::vector<std::string> maps;  ///< one a map
};
ShadeImages shadeImageNames(const ShadedWay& way, size_t number);

/// HTML without anything from the network.
std::string shadePage(const ShadeReport& report);

}  // namespace ocelli
