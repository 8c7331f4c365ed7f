#include "tests/analysis_report/report_reading.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <nlohmann/json.hpp>
#include <regex>

namespace ocelli::test {
namespace {

using Json = nlohmann::json;

void forEachCell(const Json& report, const auto& see) {
  for (const Json& element : report["elements"]) {
    if (element["type"] == "table") {
      for (const Json& row : element["rows"]) {
        for (size_t i = 0; i < row.size(); ++i) {
          see(element, row, i);
        }
      }
    }
  }
}

std::string titleOf(const Json& table, size_t column) {
  return column < table["columns"].size() ? table["columns"][column]["title"].get<std::string>() : "";
}

/// In the words of the report, for names of views as data write them; in small letters.
std::string inWords(const std::string& text) {
  static const std::regex kPinhole("\\bppc\\b");
  static const std::regex kGraph("\\bgc\\b");
  std::string words = std::regex_replace(std::regex_replace(text, kPinhole, "pinhole"), kGraph, "graph camera");
  std::transform(words.begin(), words.end(), words.begin(),
                 [](char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); });
  return words;
}

/// Of the last digit that the text shows.
double roundingOf(const std::string& number) {
  const size_t point = number.find('.');
  const size_t exponent = number.find('e');
  const double scale = exponent == std::string::npos ? 1 : std::pow(10, std::stod(number.substr(exponent + 1)));
  const size_t end = std::min(exponent, number.size());
  return point == std::string::npos ? scale : scale * std::pow(10, -static_cast<double>(end - point - 1));
}

}  // namespace

Json elementOf(const Json& report, const std::string& id) {
  for (const Json& element : report["elements"]) {
    if (element.value("id", "") == id) {
      return element;
    }
  }
  return nullptr;
}

std::optional<double> valueIn(const Json& report, const std::string& table, const std::string& row,
                              const std::string& column) {
  const Json element = elementOf(report, table);
  if (element.is_null() || element["type"] != "table") {
    return std::nullopt;
  }
  for (const Json& cells : element["rows"]) {
    if (inWords(cells[0]["text"]).find(inWords(row)) == std::string::npos && cells[0].value("short_name", "") != row) {
      continue;
    }
    for (size_t i = 0; i < cells.size(); ++i) {
      if (inWords(titleOf(element, i)) == inWords(column)) {
        return cells[i].contains("value") ? std::optional(cells[i]["value"].get<double>()) : std::nullopt;
      }
    }
  }
  return std::nullopt;
}

std::optional<double> valueOfCell(const Json& report, const std::string& name) {
  std::optional<double> value;
  forEachCell(report, [&](const Json&, const Json& row, size_t i) {
    if (row[i].value("id", "") == name && row[i].contains("value")) {
      value = row[i]["value"].get<double>();
    }
  });
  return value;
}

std::vector<std::string> namedValues(const Json& report) {
  std::vector<std::string> values;
  forEachCell(report, [&](const Json&, const Json& row, size_t i) {
    if (row[i].contains("id")) {
      values.push_back(fmt::format("{} {}", row[i]["id"].get<std::string>(),
                                   row[i].contains("value") ? row[i]["value"].dump() : row[i]["text"].dump()));
    }
  });
  return values;
}

std::vector<std::string> notEstimable(const Json& report) {
  std::vector<std::string> notes;
  for (const Json& element : report["elements"]) {
    if (element["type"] == "note" && element["kind"] == "not estimable") {
      notes.push_back(element["text"]);
    }
  }
  return notes;
}

std::vector<std::string> numbersThatAreNone(const std::string& text) {
  const auto isOfWord = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  std::vector<std::string> found;
  for (size_t begin = 0; begin < text.size();) {
    size_t end = begin;
    std::string word;
    for (; end < text.size() && isOfWord(text[end]) && word.size() < 16; ++end) {
      word += static_cast<char>(std::tolower(static_cast<unsigned char>(text[end])));
    }
    if (word == "nan" || word == "inf" || word == "infinity") {
      found.push_back(text.substr(begin - std::min<size_t>(begin, 40), 80));
    }
    begin = std::max(end, begin + 1);
  }
  return found;
}

std::vector<std::string> dishonestNumbers(const Json& report) {
  std::vector<std::string> found;
  const auto add = [&](const Json& table, const Json& row, const std::string& what) {
    found.push_back(fmt::format("{}, {}: {}", table.value("id", "?"), row[0]["text"].get<std::string>(), what));
  };
  forEachCell(report, [&](const Json& table, const Json& row, size_t i) {
    const Json& cell = row[i];
    const std::string text = cell["text"];
    const std::string title = titleOf(table, i);
    if (!numbersThatAreNone(text).empty()) {
      add(table, row, text);
    }
    if (!cell.contains("value")) {
      return;
    }
    if (!cell["value"].is_number() || text == "-" || text == "not known") {
      add(table, row, fmt::format("a value of {} is shown as \"{}\"", cell["value"].dump(), text));
      return;
    }
    const double value = cell["value"];
    if ((title == "p" || title == "Adjusted p") && !(value >= 0 && value <= 1)) {
      add(table, row, fmt::format("a p value of {}", value));
    }
    if (title == "Adjusted p" && row[i - 1].contains("value") && value < row[i - 1]["value"].get<double>()) {
      add(table, row, "a corrected p value is below that of the test");
    }
    // The next cell may be its interval.
    std::smatch bounds;
    static const std::regex kInterval("(-?[0-9.]+(?:e[-+][0-9]+)?) to (-?[0-9.]+(?:e[-+][0-9]+)?)");
    const std::string next = i + 1 < row.size() ? row[i + 1]["text"].get<std::string>() : "";
    if (std::regex_match(next, bounds, kInterval)) {
      const double low = std::stod(bounds[1]) - roundingOf(bounds[1]);
      const double high = std::stod(bounds[2]) + roundingOf(bounds[2]);
      if (!(low <= value && value <= high)) {
        add(table, row, fmt::format("{} is outside of {}", value, next));
      }
    }
  });
  for (const Json& element : report["elements"]) {
    if (element["type"] == "table" && element.value("id", "").starts_with("family-")) {
      for (const Json& row : element["rows"]) {
        const bool decided = row.back()["text"] == "supported" || row.back()["text"] == "not supported";
        const bool known = row[row.size() - 2].contains("value");
        if (decided != known) {
          add(element, row, row.back()["text"]);
        }
      }
    }
  }
  return found;
}

}  // namespace ocelli::test
