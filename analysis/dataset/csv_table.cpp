#include "analysis/dataset/csv_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <set>
#include <sstream>

#include "analysis/base/analysis_error.h"
#include "analysis/dataset/trial_check.h"

namespace ocelli {
namespace {

constexpr std::string_view kFormulaStarts = "=+-@\t\r";
/// Of what comes through a pipe.
constexpr size_t kMaxPipeBytes = size_t{1} << 26U;
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

std::string fileBytes(const std::string& path) {
  std::error_code ignored;
  std::ifstream file(path, std::ios::binary);
  if (!file || std::filesystem::is_directory(path, ignored)) {
    throw AnalysisError(AnalysisError::Kind::kInput, "this file cannot be read", path, "check its name and its rights");
  }
  // A device may have no end.
  if (!std::filesystem::is_regular_file(path, ignored)) {
    std::string bytes(kMaxPipeBytes + 1, '\0');
    file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    bytes.resize(static_cast<size_t>(file.gcount()));
    if (bytes.size() > kMaxPipeBytes) {
      throw AnalysisError(AnalysisError::Kind::kInput,
                          fmt::format("this is no regular file, and larger than {} MiB", kMaxPipeBytes >> 20U), path,
                          "save what it gives as a file, and name that");
    }
    return bytes;
  }
  std::ostringstream bytes;
  bytes << file.rdbuf();
  return std::move(bytes).str();
}

std::string csvField(std::string_view text) {
  std::string field;
  if (!text.empty() && kFormulaStarts.find(text.front()) != std::string_view::npos) {
    field += '\'';
  }
  field += text;
  if (field.find_first_of(",\"\r\n") == std::string::npos) {
    return field;
  }
  std::string quoted = "\"";
  for (const char c : field) {
    quoted.append(c == '"' ? 2 : 1, c);
  }
  return quoted + "\"";
}

CsvTable::CsvTable(const std::string& path) : path_(path), bytes_(fileBytes(path)) {
  constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
  if (std::string_view(bytes_).starts_with(kByteOrderMark)) {
    at_ = kByteOrderMark.size();
  }
  if (!readFields()) {
    throw AnalysisError(AnalysisError::Kind::kInput, "this table is empty", path_, kExportAgain);
  }
  columns_ = std::move(fields_);
  std::set<std::string> names;
  for (const std::string& name : columns_) {
    if (!names.insert(name).second) {
      throw AnalysisError(AnalysisError::Kind::kInput, fmt::format("column \"{}\" stands twice", name),
                          fmt::format("{}:1", path_), kExportAgain);
    }
  }
}

size_t CsvTable::column(const std::string& name) const {
  const auto found = std::find(columns_.begin(), columns_.end(), name);
  if (found == columns_.end()) {
    throw AnalysisError(AnalysisError::Kind::kInput, fmt::format("column \"{}\" is missing", name),
                        fmt::format("{}:1", path_), kExportAgain);
  }
  return static_cast<size_t>(found - columns_.begin());
}

bool CsvTable::next() {
  if (!readFields()) {
    return false;
  }
  if (fields_.size() != columns_.size()) {
    throw AnalysisError(
        AnalysisError::Kind::kInput,
        fmt::format("this row has {} fields, and the table {} columns", fields_.size(), columns_.size()),
        fmt::format("{}:{}", path_, rowLine_), kExportAgain);
  }
  return true;
}

bool CsvTable::readFields() {
  fields_.clear();
  if (at_ >= bytes_.size()) {
    return false;
  }
  rowLine_ = line_;
  std::string field;
  bool inQuotes = false;
  while (at_ < bytes_.size()) {
    const char c = bytes_[at_++];
    line_ += c == '\n' ? 1 : 0;
    const bool more = at_ < bytes_.size();
    if (inQuotes) {
      if (c != '"') {
        field += c;
      } else if (more && bytes_[at_] == '"') {
        field += bytes_[at_++];
      } else {
        inQuotes = false;
      }
    } else if (c == '"') {
      inQuotes = true;
    } else if (c == ',') {
      fields_.push_back(std::move(field));
      field.clear();
    } else if (c == '\n') {
      fields_.push_back(std::move(field));
      return true;
    } else if (c != '\r' || !more || bytes_[at_] != '\n') {
      field += c;
    }
  }
  if (inQuotes) {
    throw AnalysisError(AnalysisError::Kind::kInput, "a quote of this row does not end",
                        fmt::format("{}:{}", path_, rowLine_), kExportAgain);
  }
  fields_.push_back(std::move(field));
  return true;
}

void CsvTable::fail(size_t column, const std::string& problem) const {
  throw AnalysisError(AnalysisError::Kind::kInput, fmt::format("column \"{}\" {}", columns_[column], problem),
                      fmt::format("{}:{}", path_, rowLine_), kExportAgain);
}

std::string CsvTable::text(size_t column) const {
  const std::string& field = fields_[column];
  const bool guarded = field.size() > 1 && field[0] == '\'' && kFormulaStarts.find(field[1]) != std::string_view::npos;
  return guarded ? field.substr(1) : field;
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

std::optional<int64_t> CsvTable::optionalHexadecimal(size_t column) const {
  const std::string& field = fields_[column];
  if (field.empty()) {
    return std::nullopt;
  }
  const auto number = field.starts_with("0x") ? parsed<uint64_t>(std::string_view(field).substr(2), 16) : std::nullopt;
  if (!number) {
    fail(column, fmt::format("is \"{}\", but must be 0x and hexadecimal digits", field));
  }
  return static_cast<int64_t>(*number);
}

}  // namespace ocelli
