// The names of a table's rows, for fields that choose one.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace ocelli {

/// In the table's order; a row has a `name`.
template <class Row>
std::vector<std::string> rowNames(std::span<const Row> rows) {
  std::vector<std::string> names;
  for (const Row& row : rows) {
    names.emplace_back(row.name);
  }
  return names;
}

}  // namespace ocelli
