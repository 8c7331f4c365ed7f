// What the columns of exported tables mean: once for all tables, so that a name means one thing.
#pragma once

#include <string>
#include <vector>

namespace ocelli {

struct ColumnMeaning {
  std::string name;
  std::string unit;  ///< empty where there is none
  std::string description;
};

/// Of every column that is not a task's own measure.
const std::vector<ColumnMeaning>& columnMeanings();

/// Of a task's own measure: the unit is that of the name's ending ("path_length_m").
ColumnMeaning measureMeaning(const std::string& name);

}  // namespace ocelli
