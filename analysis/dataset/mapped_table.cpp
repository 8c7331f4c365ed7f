#include "analysis/dataset/mapped_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <string_view>

#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/base/trimmed.h"
#include "oc_core/base/utf8.h"

namespace ocelli {
namespace {

constexpr size_t kMaxFieldBytes = 10'000;  // of fields that the map uses; others may hold anything
constexpr size_t kMaxShownBytes = 60;
constexpr size_t kMaxShownColumns = 30;
constexpr int kMaxWhole = 1'000'000'000;
constexpr std::array<std::string_view, 6> kNoNumber{"", "null", "None", "NA", "N/A", "NaN"};

/// As an error shows it: short, and in quotes.
std::string shown(const std::string& field) {
  if (field.size() <= kMaxShownBytes) {
    return fmt::format("\"{}\"", cleanText(field));
  }
  return fmt::format("\"{}...\" ({} bytes)", cleanText(std::string_view(field).substr(0, kMaxShownBytes)),
                     field.size());
}

/// Empty where it is.
std::string problemOfUtf8(std::string_view text) {
  while (!text.empty()) {
    const size_t length = bytesOfFirstCharacter(text);
    if (length == 0) {
      return fmt::format("holds the byte 0x{:02x}, which is no UTF-8", static_cast<unsigned char>(text.front()));
    }
    const auto first = static_cast<unsigned char>(text.front());
    if ((first < 0x20 && first != '\t' && first != '\n' && first != '\r') || first == 0x7f) {
      return fmt::format("holds the control character 0x{:02x}", first);
    }
    text.remove_prefix(length);
  }
  return "";
}

void checkIsNoUtf16(const std::string& bytes, const std::string& path) {
  const std::string_view start = std::string_view(bytes).substr(0, 2);
  if (start == "\xff\xfe" || start == "\xfe\xff") {
    throw InputError("this table is in UTF-16", fmt::format("{}:1", path),
                     "save it as UTF-8: iconv -f UTF-16 -t UTF-8");
  }
}

constexpr const char* kSaveAsUtf8 =
    "save the table as UTF-8; of Windows and old spreadsheets: iconv -f WINDOWS-1252 -t UTF-8";

}  // namespace

MappedTable::MappedTable(const std::string& path, const ColumnMap& map)
    : path_(path),
      fileName_(std::filesystem::path(path).stem().string()),
      map_(map),
      bytes_(readFile(path)),
      reader_(bytes_, path, map.separator) {
  checkIsNoUtf16(bytes_, path_);
  readColumns();
  findColumns();
}

void MappedTable::readColumns() {
  if (!reader_.next(columns_) || (columns_.size() == 1 && columns_[0].empty())) {
    throw InputError("this table is empty: its first line must name the columns", fmt::format("{}:1", path_),
                     "a table with a row a trial");
  }
  for (size_t i = 0; i < columns_.size(); ++i) {
    if (const std::string problem = problemOfUtf8(columns_[i]); !problem.empty()) {
      throw InputError(fmt::format("the name of column {} {}", i + 1, problem), reader_.place(), kSaveAsUtf8);
    }
  }
}

void MappedTable::checkNoTwoOf(const std::string& column) const {
  if (std::count(columns_.begin(), columns_.end(), column) > 1) {
    throw InputError(fmt::format("column \"{}\" stands twice", column), fmt::format("{}:1", path_),
                     "give one of them another name");
  }
}

void MappedTable::findColumns() {
  const auto find = [&](const std::string& column, const char* fieldOfMap, bool mayBeMissing = false) {
    if (column.empty()) {
      return;
    }
    checkNoTwoOf(column);
    const auto found = std::find(columns_.begin(), columns_.end(), column);
    if (found != columns_.end()) {
      indices_[column] = static_cast<size_t>(found - columns_.begin());
      return;
    }
    if (mayBeMissing) {
      return;
    }
    std::string known;
    for (size_t i = 0; i < columns_.size(); ++i) {
      if (i == kMaxShownColumns) {
        known += fmt::format(", and {} more", columns_.size() - i);
        break;
      }
      known += columns_[i].empty() ? "" : fmt::format("{}{}", known.empty() ? "" : ", ", columns_[i]);
    }
    const bool isOne = columns_.size() == 1;
    const char* separator = isOne && columns_[0].find(';') != std::string::npos    ? "semicolon"
                            : isOne && columns_[0].find('\t') != std::string::npos ? "tab"
                            : isOne && columns_[0].find(',') != std::string::npos  ? "comma"
                                                                                   : nullptr;
    throw InputError(
        fmt::format("column \"{}\" is missing, which the map {} has for \"{}\"", column, map_.name, fieldOfMap),
        fmt::format("{}:1", path_),
        separator != nullptr
            ? fmt::format("a map with \"separator\": \"{}\", as the line seems to be separated so", separator)
            : fmt::format("a map that names a column of this table: {}", known));
  };
  find(map_.subject.column, "subject");
  find(map_.session.column, "session");
  find(map_.task.column, "task");
  find(map_.block.column, "block");
  find(map_.condition.column, "condition");
  find(map_.caseLabel.column, "case");
  find(map_.trial.column, "trial");
  find(map_.time.column, "time");
  find(map_.time.minus, "time");
  find(map_.answer.column, "answer");
  find(map_.expected.column, "expected");
  find(map_.correct.column, "correct");
  find(map_.timeout.column, "timeout");
  for (const RowTest& test : map_.rows) {
    find(test.column, "rows", test.mayBeMissing);
  }
  find(map_.practice.column, "practice", map_.practice.mayBeMissing);
  find(map_.simulated.column, "simulated", map_.simulated.mayBeMissing);
  for (const auto& [name, column] : map_.measures) {
    find(column, "measures");
  }
}

bool MappedTable::next() {
  do {
    if (!reader_.next(fields_)) {
      return false;
    }
  } while (fields_.size() == 1 && fields_[0].empty() && columns_.size() > 1);
  if (fields_.size() != columns_.size()) {
    const size_t at = std::min(fields_.size(), columns_.size());
    throw InputError(
        fmt::format("this row has {} fields, and the table {} columns: {}", fields_.size(), columns_.size(),
                    fields_.size() < columns_.size() ? fmt::format("column \"{}\" has none", columns_[at])
                                                     : fmt::format("{} has no column", shown(fields_[at]))),
        reader_.place(), "texts with the separator in quotes; or the table as the tool wrote it");
  }
  return true;
}

void MappedTable::fail(const std::string& column, const std::string& problem, const std::string& next) const {
  throw InputError(fmt::format("column \"{}\" {}", column, problem), reader_.place(),
                   next.empty() ? fmt::format("correct the row, or the map of columns ({})", map_.name) : next);
}

void MappedTable::fail(const MappedText& text, const std::string& problem, const std::string& next) const {
  fail(text.column.empty() ? "(none: by the map)" : text.column, problem, next);
}

std::string MappedTable::field(const std::string& column) const {
  const std::string& field = fields_[indices_.at(column)];
  if (field.size() > kMaxFieldBytes) {
    fail(column, fmt::format("has {} bytes, but at most {} are read", field.size(), kMaxFieldBytes));
  }
  if (const std::string problem = problemOfUtf8(field); !problem.empty()) {
    fail(column, problem, kSaveAsUtf8);
  }
  return field;
}

std::string MappedTable::text(const MappedText& text) const {
  return text.isFileName ? fileName_ : text.column.empty() ? text.value : field(text.column);
}

std::string MappedTable::name(const MappedText& text) const {
  constexpr size_t kMaxNameBytes = 1000;  // as study/trial/trial_check.h has it
  std::string name = this->text(text);
  if (trimmed(name).empty()) {
    fail(text, "is empty", "fill it; or a test in \"rows\" of the map that leaves out rows that are no trials");
  }
  if (name.size() > kMaxNameBytes) {
    fail(text, fmt::format("has {} bytes, but a name has at most {}", name.size(), kMaxNameBytes));
  }
  return name;
}

bool MappedTable::passes(const RowTest& test) const {
  return indices_.contains(test.column) && test.passes(field(test.column));
}

std::optional<double> MappedTable::number(const std::string& column) const {
  const std::string whole = field(column);
  std::string text(trimmed(whole));
  if (std::find(kNoNumber.begin(), kNoNumber.end(), text) != kNoNumber.end()) {
    return std::nullopt;
  }
  bool isNumber = true;
  if (map_.decimalPoint != '.') {
    isNumber = text.find('.') == std::string::npos;  // of thousands: what it means would be guessed
    std::replace(text.begin(), text.end(), map_.decimalPoint, '.');
  }
  double number = 0;
  const char* end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, number);
  if (!isNumber || result.ec != std::errc() || result.ptr != end || !std::isfinite(number)) {
    const bool hasOther = text.find(map_.decimalPoint == '.' ? ',' : '.') != std::string::npos;
    fail(column, fmt::format("is {}, but must be a number", shown(whole)),
         hasOther ? fmt::format("\"decimal\": \"{}\" in the map, where that is how numbers are written",
                                map_.decimalPoint == '.' ? "comma" : "point")
                  : "");
  }
  return number;
}

int MappedTable::wholeNumber(const MappedText& text, int min) const {
  const std::string whole = this->text(text);
  std::string_view digits = trimmed(whole);
  if (digits.ends_with(".0")) {  // as spreadsheets of numbers write them
    digits.remove_suffix(2);
  }
  int number = 0;
  const char* end = digits.data() + digits.size();
  const auto result = std::from_chars(digits.data(), end, number);
  if (digits.empty() || result.ec != std::errc() || result.ptr != end || number < min || number > kMaxWhole) {
    fail(text, fmt::format("is {}, but must be a whole number from {} to {}", shown(whole), min, kMaxWhole));
  }
  return number;
}

}  // namespace ocelli
