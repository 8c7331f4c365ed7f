// The JSON texts of column_maps/, compiled in; column_map.h is the interface to them.
#pragma once

#include <string>
#include <vector>

namespace ocelli {

struct BuiltInColumnMap {
  std::string name;  ///< "psychopy"
  std::string json;
};

const std::vector<BuiltInColumnMap>& builtInColumnMaps();

}  // namespace ocelli
