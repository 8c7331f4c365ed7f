#include "analysis/dataset/csv_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <set>

#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "study/trial/trial_check.h"

namespace ocelli {
namespace {

constexpr const char* kExportAgain = "export the database again, and keep spreadsheets from saving over its tables";

/// What the whole text says, read by std::from_chars.
template <class Number, class... Format>
std::optional<Number> parsed(std::string_view text, Format... format) {
  Number number{};
  const char* end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, number, format...);
  return result.ec == std::errc() && result.ptr == end ? std::optional<Number>(number) : std::nullopt;
}

}  // namespace

CsvTable::CsvTable(const std::string& path) : path_(path), bytes_(readFile(path)), reader_(bytes_, path) {
  if (!reader_.next(columns_)) {
    throw InputError("this table is empty", path_, kExportAgain);
  }
  std::set<std::string> names;
  for (const std::string& name : columns_) {
    if (!names.insert(name).second) {
      throw InputError(fmt::format("column \"{}\" stands twice", name), reader_.place(), kExportAgain);
    }
  }
}

size_t CsvTable::column(const std::string& name) const {
  const auto found = std::find(columns_.begin(), columns_.end(), name);
  if (found == columns_.end()) {
    throw InputError(fmt::format("column \"{}\" is missing", name), fmt::format("{}:1", path_), kExportAgain);
  }
  return static_cast<size_t>(found - columns_.begin());
}

bool CsvTable::next() {
  if (!reader_.next(fields_)) {
    return false;
  }
  if (fields_.size() != columns_.size()) {
    throw InputError(fmt::format("this row has {} fields, and the table {} columns", fields_.size(), columns_.size()),
                     reader_.place(), kExportAgain);
  }
  return true;
}

void CsvTable::fail(size_t column, const std::string& problem) const {
  throw InputError(fmt::format("column \"{}\" {}", columns_[column], problem), reader_.place(), kExportAgain);
}

std::string CsvTable::text(size_t column) const {
  return textOfCsv(fields_[column]);
}

std::string CsvTable::name(size_t column) const {
  const std::string value = text(column);
  if (const std::string problem = problemOfName(value); !problem.empty()) {
    fail(column, problem);
  }
  return value;
}

std::optional<int64_t> CsvTable::optionalInteger(size_t column) const {
  const std::string& field = fields_[column];
  if (field.empty()) {
    return std::nullopt;
  }
  const auto number = parsed<int64_t>(field);
  if (!number) {
    fail(column, fmt::format("is \"{}\", but must be a whole number", field));
  }
  return number;
}

int64_t CsvTable::integer(size_t column) const {
  const auto number = optionalInteger(column);
  if (!number) {
    fail(column, "is empty, but must be a whole number");
  }
  return *number;
}

int32_t CsvTable::smallInteger(size_t column) const {
  const int64_t number = integer(column);
  if (number < 0 || number > std::numeric_limits<int32_t>::max()) {
    fail(column,
         fmt::format("is {}, but must be a whole number from 0 to {}", number, std::numeric_limits<int32_t>::max()));
  }
  return static_cast<int32_t>(number);
}

std::optional<bool> CsvTable::optionalFlag(size_t column) const {
  const std::string& field = fields_[column];
  if (field.empty()) {
    return std::nullopt;
  }
  if (field != "0" && field != "1") {
    fail(column, fmt::format("is \"{}\", but must be 0 or 1", field));
  }
  return field == "1";
}

bool CsvTable::flag(size_t column) const {
  const auto value = optionalFlag(column);
  if (!value) {
    fail(column, "is empty, but must be 0 or 1");
  }
  return *value;
}

std::optional<double> CsvTable::optionalReal(size_t column) const {
  const std::string& field = fields_[column];
  if (field.empty()) {
    return std::nullopt;
  }
  const auto number = parsed<double>(field);
  if (!number || !std::isfinite(*number)) {
    fail(column, fmt::format("is \"{}\", but must be a number", field));
  }
  return number;
}

std::optional<uint64_t> CsvTable::optionalHexadecimal(size_t column) const {
  const std::string& field = fields_[column];
  if (field.empty()) {
    return std::nullopt;
  }
  const auto number = field.starts_with("0x") ? parsed<uint64_t>(std::string_view(field).substr(2), 16) : std::nullopt;
  if (!number) {
    fail(column, fmt::format("is \"{}\", but must be 0x and hexadecimal digits", field));
  }
  return number;
}

}  // namespace ocelli
