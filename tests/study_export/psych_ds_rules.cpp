#include "tests/study_export/psych_ds_rules.h"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>

namespace ocelli::test {
namespace {

namespace fs = std::filesystem;
using Violations = std::vector<std::string>;
using Table = std::vector<std::vector<std::string>>;

std::string bytesOf(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream bytes;
  bytes << stream.rdbuf();
  return bytes.str();
}

/// By the pattern of well-formed byte sequences, table 3-7 of the Unicode standard.
bool isUtf8(const std::string& bytes) {
  const auto in = [&](size_t i, int least, int most) {
    return i < bytes.size() && static_cast<unsigned char>(bytes[i]) >= least &&
           static_cast<unsigned char>(bytes[i]) <= most;
  };
  for (size_t i = 0; i < bytes.size();) {
    if (in(i, 0x00, 0x7f)) {
      i += 1;
    } else if (in(i, 0xc2, 0xdf) && in(i + 1, 0x80, 0xbf)) {
      i += 2;
    } else if (((in(i, 0xe0, 0xe0) && in(i + 1, 0xa0, 0xbf)) || (in(i, 0xe1, 0xec) && in(i + 1, 0x80, 0xbf)) ||
                (in(i, 0xed, 0xed) && in(i + 1, 0x80, 0x9f)) || (in(i, 0xee, 0xef) && in(i + 1, 0x80, 0xbf))) &&
               in(i + 2, 0x80, 0xbf)) {
      i += 3;
    } else if (((in(i, 0xf0, 0xf0) && in(i + 1, 0x90, 0xbf)) || (in(i, 0xf1, 0xf3) && in(i + 1, 0x80, 0xbf)) ||
                (in(i, 0xf4, 0xf4) && in(i + 1, 0x80, 0x8f))) &&
               in(i + 2, 0x80, 0xbf) && in(i + 3, 0x80, 0xbf)) {
      i += 4;
    } else {
      return false;
    }
  }
  return true;
}

/// RFC 4180 as a machine of states.
bool readTable(const std::string& bytes, Table& table) {
  enum class In { kFieldBegins, kPlain, kQuoted, kQuoteInQuoted };
  In state = In::kFieldBegins;
  std::vector<std::string> line;
  std::string field;
  const auto endField = [&] {
    line.push_back(field);
    field.clear();
    state = In::kFieldBegins;
  };
  const auto endLine = [&] {
    endField();
    table.push_back(line);
    line.clear();
  };
  for (size_t i = 0; i < bytes.size(); ++i) {
    const char c = bytes[i];
    if (state == In::kQuoted) {
      if (c == '"') {
        state = In::kQuoteInQuoted;
      } else {
        field += c;
      }
      continue;
    }
    if (state == In::kQuoteInQuoted && c == '"') {
      field += c;
      state = In::kQuoted;
    } else if (c == ',') {
      endField();
    } else if (c == '\r' && i + 1 < bytes.size() && bytes[i + 1] == '\n') {
      endLine();
      ++i;
    } else if (c == '\n') {
      endLine();
    } else if (c == '"' && state == In::kFieldBegins) {
      state = In::kQuoted;
    } else if (c == '"' || state == In::kQuoteInQuoted) {
      return false;
    } else {
      field += c;
      state = In::kPlain;
    }
  }
  if (state == In::kQuoted) {
    return false;
  }
  if (!line.empty() || !field.empty() || state != In::kFieldBegins) {
    endLine();
  }
  return true;
}

bool hasText(const nlohmann::json& object, const char* name) {
  return object.contains(name) && object[name].is_string() && !object[name].get<std::string>().empty();
}

/// Rule 1. Returns the names that are measured.
std::set<std::string> checkDescription(const fs::path& folder, Violations& violations) {
  const std::string where = "dataset_description.json: ";
  std::set<std::string> measured;
  const fs::path file = folder / "dataset_description.json";
  if (!fs::is_regular_file(file)) {
    violations.push_back(where + "missing");
    return measured;
  }
  const std::string bytes = bytesOf(file);
  const nlohmann::json json = nlohmann::json::parse(bytes, nullptr, false);
  if (!isUtf8(bytes) || !json.is_object()) {
    violations.push_back(where + "no JSON object in UTF-8");
    return measured;
  }
  if (json.value("@type", "") != "Dataset") {
    violations.push_back(where + "@type is not Dataset");
  }
  if (!std::regex_match(json.value("@context", ""), std::regex("https?://schema\\.org/?"))) {
    violations.push_back(where + "@context is not schema.org");
  }
  for (const char* name : {"name", "description"}) {
    if (!hasText(json, name)) {
      violations.push_back(where + "no " + name);
    }
  }
  if (!json.contains("variableMeasured") || !json["variableMeasured"].is_array()) {
    violations.push_back(where + "no variableMeasured");
    return measured;
  }
  for (const nlohmann::json& variable : json["variableMeasured"]) {
    if (variable.is_string()) {
      measured.insert(variable.get<std::string>());
    } else if (variable.is_object() && variable.value("@type", "") == "PropertyValue" && hasText(variable, "name")) {
      measured.insert(variable["name"].get<std::string>());
    } else {
      violations.push_back(where + "a variable is neither a name nor a PropertyValue with a name");
    }
  }
  return measured;
}

/// Rules 3 to 5.
void checkTable(const fs::path& file, const std::set<std::string>& measured, Violations& violations) {
  const std::string where = file.filename().string() + ": ";
  const std::string bytes = bytesOf(file);
  Table table;
  if (!isUtf8(bytes)) {
    violations.push_back(where + "not UTF-8");
  }
  if (!readTable(bytes, table)) {
    violations.push_back(where + "quotes that RFC 4180 does not allow");
    return;
  }
  if (table.empty()) {
    violations.push_back(where + "no column names");
    return;
  }
  const std::vector<std::string>& names = table.front();
  std::set<std::string> seen;
  for (const std::string& name : names) {
    if (name.empty()) {
      violations.push_back(where + "a column without a name");
    } else if (!seen.insert(name).second) {
      violations.push_back(where + "column " + name + " comes twice");
    } else if (!measured.contains(name)) {
      violations.push_back(where + "column " + name + " is not in variableMeasured");
    }
  }
  const auto rowId = static_cast<size_t>(std::find(names.begin(), names.end(), "row_id") - names.begin());
  std::set<std::string> ids;
  for (size_t line = 1; line < table.size(); ++line) {
    if (table[line].size() != names.size()) {
      violations.push_back(where + "line " + std::to_string(line + 1) + " has another number of fields");
    } else if (rowId < names.size() && (table[line][rowId].empty() || !ids.insert(table[line][rowId]).second)) {
      violations.push_back(where + "row_id \"" + table[line][rowId] + "\" is empty or comes twice");
    }
  }
}

}  // namespace

std::vector<std::string> psychDsViolations(const fs::path& folder) {
  Violations violations;
  const std::set<std::string> measured = checkDescription(folder, violations);
  int tables = 0;
  if (fs::is_directory(folder / "data")) {
    const std::regex name("[a-z]+-[a-zA-Z0-9]+(_[a-z]+-[a-zA-Z0-9]+)*_data\\.csv");
    for (const auto& entry : fs::recursive_directory_iterator(folder / "data")) {
      if (!entry.is_regular_file() || entry.path().extension() != ".csv") {
        continue;
      }
      if (!std::regex_match(entry.path().filename().string(), name)) {
        violations.push_back(entry.path().filename().string() + ": not a name of a data file");
        continue;
      }
      ++tables;
      checkTable(entry.path(), measured, violations);
    }
  }
  if (tables == 0) {
    violations.push_back("data/: no data file");
  }
  return violations;
}

}  // namespace ocelli::test
