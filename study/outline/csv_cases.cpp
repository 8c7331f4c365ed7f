#include "study/outline/csv_cases.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "oc_core/base/csv.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/base/json_document.h"
#include "oc_core/base/json_lines.h"
#include "oc_core/base/utf8.h"

namespace ocelli {
namespace {

constexpr size_t kMaxRows = 1000;
constexpr size_t kMaxColumns = 100;
constexpr const char* kLabel = "label";
constexpr const char* kFactors = "factors";

/// Names of the factors of cases, as far as the field is well-formed; readFactors() says what is wrong with it.
std::set<std::string> factorsOfCases(const nlohmann::json& protocol) {
  std::set<std::string> names;
  for (const nlohmann::json& factor : protocol.value(kFactors, nlohmann::json::array())) {
    if (factor.is_object() && factor.contains("name") && factor["name"].is_string() && factor.contains("of") &&
        factor["of"] == "cases") {
      names.insert(factor["name"].get<std::string>());
    }
  }
  return names;
}

/// A column of a table, as the fields that lead to its values: {"start", "row"}.
struct CaseColumn {
  std::vector<std::string> path{};
  bool isText = false;
};

class CaseTable {
 public:
  CaseTable(const std::filesystem::path& file, std::string shown, const std::set<std::string>& factors)
      : shown_(std::move(shown)), bytes_(readFile(file, kMaxTextBytes)), reader_(bytes_, shown_) {
    readColumns(factors);
  }

  /// An array of objects, and of each its line.
  nlohmann::ordered_json readAll(std::vector<int>& lines) {
    nlohmann::ordered_json cases = nlohmann::ordered_json::array();
    while (reader_.next(fields_)) {
      if (fields_.size() == 1 && fields_[0].empty()) {
        continue;  // an empty line
      }
      if (fields_.size() != columns_.size()) {
        throw InputError(fmt::format("this line has {} fields, but the first line names {} columns", fields_.size(),
                                     columns_.size()),
                         reader_.place(), "one field a column; quotes around fields that hold commas");
      }
      if (cases.size() == kMaxRows) {
        throw InputError(fmt::format("this table has more than {} cases", kMaxRows), reader_.place(),
                         "fewer cases, or several blocks");
      }
      cases.push_back(caseOfLine());
      const std::string place = reader_.place();
      lines.push_back(std::stoi(place.substr(place.rfind(':') + 1)));
    }
    if (cases.empty()) {
      throw InputError("this table has no cases", shown_, "a line for each case below the names of the columns");
    }
    return cases;
  }

  const std::vector<std::string>& columns() const { return names_; }

 private:
  [[noreturn]] void fail(size_t column, const std::string& problem) const {
    throw InputError(problem, fmt::format("{}, column {} ({})", reader_.place(), column + 1, names_[column]),
                     "see docs/protocols.md, \"Cases in a table\"");
  }

  void readColumns(const std::set<std::string>& factors) {
    if (!reader_.next(names_) || names_.size() > kMaxColumns) {
      throw InputError(fmt::format("the first line must name 1 to {} columns", kMaxColumns), shown_,
                       "fields of a case, such as label,row,column");
    }
    std::set<std::string> seen;
    for (size_t i = 0; i < names_.size(); ++i) {
      const std::string& name = names_[i];
      if (!seen.insert(name).second) {
        fail(i, "this column stands twice");
      }
      CaseColumn column;
      for (size_t at = 0; at <= name.size();) {
        const size_t end = std::min(name.find('.', at), name.size());
        column.path.push_back(name.substr(at, end - at));
        at = end + 1;
      }
      if (std::any_of(column.path.begin(), column.path.end(), [](const auto& part) { return part.empty(); })) {
        fail(i, "a column must have the name of a field, or of fields joined by points");
      }
      if (factors.contains(name)) {
        column.path = {kFactors, name};
      }
      column.isText = name == kLabel || column.path.front() == kFactors;
      columns_.push_back(std::move(column));
    }
  }

  nlohmann::ordered_json caseOfLine() const {
    nlohmann::ordered_json result = nlohmann::ordered_json::object();
    for (size_t i = 0; i < columns_.size(); ++i) {
      const std::string text = textOfCsv(fields_[i]);
      if (text.empty()) {
        continue;
      }
      if (cleanText(text) != text) {
        fail(i, "this field is not valid UTF-8");
      }
      nlohmann::ordered_json* at = &result;
      for (size_t part = 0; part + 1 < columns_[i].path.size(); ++part) {
        at = &(*at)[columns_[i].path[part]];
        if (!at->is_object() && !at->is_null()) {
          fail(i, "another column gives this object a value");
        }
      }
      nlohmann::ordered_json& value = (*at)[columns_[i].path.back()];
      if (!value.is_null()) {
        fail(i, "another column has this field");
      }
      value = valueOf(i, text);
    }
    return result;
  }

  nlohmann::ordered_json valueOf(size_t column, const std::string& text) const {
    if (columns_[column].isText) {
      return text;
    }
    const nlohmann::ordered_json parsed = nlohmann::ordered_json::parse(text, nullptr, false);
    if (parsed.is_number() || parsed.is_boolean() || parsed.is_structured()) {
      return parsed;
    }
    if (text.front() == '{' || text.front() == '[') {
      fail(column, "this is neither a list nor an object of JSON");
    }
    return text;
  }

  std::string shown_;
  std::string bytes_;
  CsvReader reader_;
  std::vector<std::string> names_{};
  std::vector<CaseColumn> columns_{};
  std::vector<std::string> fields_{};
};

/// Puts the text in place of a value. Lines behind it keep their numbers.
void replaceValue(std::string& text, const std::string& pointer, const std::string& by) {
  const auto [begin, end] = bytesOfJson(text, pointer);
  const auto from = text.begin() + static_cast<std::ptrdiff_t>(begin);
  const auto lines = std::count(from, text.begin() + static_cast<std::ptrdiff_t>(end), '\n');
  text.replace(begin, end - begin, by + std::string(static_cast<size_t>(lines), '\n'));
}

bool namesTable(const nlohmann::json& field) {
  return field.is_object() && field.contains("csv");
}

}  // namespace

std::string CsvCases::placeOf(size_t index, const std::string& field) const {
  std::string place = index < lines.size() ? fmt::format("{}:{}", file, lines[index]) : file;
  for (size_t i = 0; !field.empty() && i < columns.size(); ++i) {
    if (columns[i] == field || columns[i].ends_with("." + field)) {
      return fmt::format("{}, column {} ({})", place, i + 1, columns[i]);
    }
  }
  return place;
}

ProtocolText withCsvCases(const std::string& text, const std::filesystem::path& file) {
  const JsonDocument document(text, file.string());
  const nlohmann::json& protocol = document.root();
  ProtocolText result{text};
  if (!protocol.is_object() || !protocol.contains("blocks") || !protocol["blocks"].is_array()) {
    return result;
  }
  const nlohmann::json& blocks = protocol["blocks"];
  const std::set<std::string> factors = factorsOfCases(protocol);
  for (size_t i = 0; i < blocks.size(); ++i) {
    for (const char* name : {"cases", "practice_cases"}) {
      if (!blocks[i].is_object() || !blocks[i].contains(name) || !namesTable(blocks[i][name])) {
        continue;
      }
      CsvCases cases;
      cases.pointer = pointerToField(pointerToElement("/blocks", i), name);
      const nlohmann::json& field = blocks[i][name];
      const std::filesystem::path table = field["csv"].is_string() ? field["csv"].get<std::string>() : "";
      if (table.empty() || table.is_absolute() || field.size() != 1) {
        throw InputError(
            fmt::format("field \"{}\" must be a list of cases, or {{\"csv\": \"FILE\"}} with a name relative "
                        "to the folder of the protocol",
                        name),
            document.placeOf(cases.pointer), "see docs/protocols.md, \"Cases in a table\"");
      }
      const std::filesystem::path path = file.parent_path() / table;
      cases.file = path.string();
      CaseTable rows(path, cases.file, factors);
      cases.columns = rows.columns();
      replaceValue(result.text, cases.pointer, rows.readAll(cases.lines).dump());
      result.tables.push_back(std::move(cases));
    }
  }
  return result;
}

ProtocolText readProtocolText(const std::filesystem::path& file) {
  return withCsvCases(readFile(file, kMaxTextBytes), file);
}

}  // namespace ocelli
