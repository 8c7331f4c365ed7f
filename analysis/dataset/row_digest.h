// Digests of rows: what two rows have in common that stand in different files, and what the hash of a data set is made
// of.
//
// A row is its fields in a fixed order, each with its kind and length, so that no two rows have the same bytes. Numbers
// of rows and runs are left out, as a merge gives new ones; so is what follows from the protocol, whose own hash stands
// beside.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/dataset/trial.h"

namespace ocelli {

class RowBytes {
 public:
  /// `kind` tells rows of different tables apart.
  explicit RowBytes(std::string_view kind) { text(kind); }

  RowBytes& text(std::string_view value);
  RowBytes& integer(int64_t value);
  RowBytes& integer(const std::optional<int64_t>& value);
  /// By its bits.
  RowBytes& real(double value);
  RowBytes& real(const std::optional<double>& value);

  Digest digest() const;

 private:
  std::string bytes_;
};

/// With the columns that no analysis reads, but that tell of a change. `view`: the name of its condition.
Digest digestOf(const TrialRow& trial, const std::string& view);

/// Of the digests in the order of their bytes: the same whatever order they came in.
Digest sha256OfRows(std::vector<Digest> rows);

}  // namespace ocelli
