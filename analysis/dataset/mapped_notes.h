// What a reader of a report on tables of another tool must be told: how they were read, and what nobody can know from
// them.
#pragma once

#include <string>
#include <vector>

#include "analysis/dataset/column_map.h"

namespace ocelli {

struct MappedCounts {
  size_t tables = 0;
  int64_t rows = 0;      ///< that are not blank
  int64_t noTrials = 0;  ///< rows that the map's tests leave out
  int64_t cases = 0;
  std::string reference{};                 ///< label of the first condition
  std::vector<std::string> noCondition{};  ///< values of the map's conditions that no row has
};

/// "subject: column participant; session: 1 for all rows; ..."
std::string describe(const ColumnMap& map);
/// Whole sentences.
std::vector<std::string> mappedNotes(const ColumnMap& map, const MappedCounts& counts);

}  // namespace ocelli
