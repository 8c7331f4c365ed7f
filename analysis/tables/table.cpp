#include "analysis/tables/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "oc_core/base/csv.h"
#include "oc_core/base/utf8.h"

namespace ocelli {
namespace {

std::string numberText(const Cell& cell) {
  const double value = *cell.value;
  // What is not 0 is not shown as 0.
  const bool isSmall = value != 0 && std::abs(value) < 0.5 * std::pow(10, -cell.decimals);
  const std::string number = isSmall ? fmt::format("{:.2g}", value) : fmt::format("{:.{}f}", value, cell.decimals);
  return fmt::format("{}{}{}", number, cell.unit.empty() ? "" : " ", cell.unit);
}

std::string printable(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }, '?');
  return text;
}

std::vector<std::string> textsOf(const TableRow& row) {
  std::vector<std::string> texts;
  std::transform(row.heads.begin(), row.heads.end(), std::back_inserter(texts), printable);
  std::transform(row.cells.begin(), row.cells.end(), std::back_inserter(texts), displayText);
  return texts;
}

void appendLine(std::string& text, const std::vector<std::string>& fields, const std::vector<size_t>& widths) {
  std::string line;
  for (size_t i = 0; i < fields.size(); ++i) {
    line +=
        fmt::format("{}{}{}", i == 0 ? "" : "  ", fields[i], std::string(widths[i] - characterCount(fields[i]), ' '));
  }
  text += fmt::format("{}\n", line.substr(0, line.find_last_not_of(' ') + 1));
}

}  // namespace

std::string displayText(const Cell& cell) {
  if (!cell.value) {
    return cell.missing;
  }
  if (cell.unit == "%" && cell.numerator && cell.denominator) {
    return fmt::format("{} ({}/{})", numberText(cell), *cell.numerator, *cell.denominator);
  }
  if (cell.denominator) {
    return fmt::format("{} (n = {})", numberText(cell), *cell.denominator);
  }
  return numberText(cell);
}

std::string plainText(const Table& table) {
  std::vector<std::string> names = table.headNames;
  names.insert(names.end(), table.cellNames.begin(), table.cellNames.end());
  std::vector<std::vector<std::string>> lines{names};
  for (const TableRow& row : table.rows) {
    lines.push_back(textsOf(row));
  }
  std::vector<size_t> widths(names.size(), 0);
  for (const auto& line : lines) {
    for (size_t i = 0; i < line.size(); ++i) {
      widths[i] = std::max(widths[i], characterCount(line[i]));
    }
  }
  std::string text = fmt::format("{}\n", table.title);
  for (const auto& line : lines) {
    appendLine(text, line, widths);
  }
  if (table.rows.empty()) {
    text += "no rows\n";
  }
  for (const std::string& note : table.notes) {
    text += fmt::format("  {}\n", note);
  }
  return text;
}

std::string cellsCsv(const std::vector<Table>& tables) {
  std::string text = "table,cell,row,column,value,unit,numerator,denominator,published,missing,meaning\r\n";
  const auto number = [](const auto& value) { return value ? fmt::format("{}", *value) : std::string(); };
  for (const Table& table : tables) {
    for (const TableRow& row : table.rows) {
      std::string heads;
      for (const std::string& head : row.heads) {
        heads += fmt::format("{}{}", heads.empty() ? "" : ", ", head);
      }
      for (size_t i = 0; i < row.cells.size(); ++i) {
        const Cell& cell = row.cells[i];
        fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{},{},{},{},{}\r\n", csvText(table.name),
                       csvText(cell.name), csvText(heads), csvText(table.cellNames[i]), number(cell.value), cell.unit,
                       number(cell.numerator), number(cell.denominator), cell.isPublished() ? 1 : 0,
                       csvText(cell.value ? "" : cell.missing), csvText(cell.meaning));
      }
    }
  }
  return text;
}

const Cell* findCell(const std::vector<Table>& tables, const std::string& name) {
  for (const Table& table : tables) {
    for (const TableRow& row : table.rows) {
      const auto found =
          std::find_if(row.cells.begin(), row.cells.end(), [&](const Cell& cell) { return cell.name == name; });
      if (found != row.cells.end()) {
        return &*found;
      }
    }
  }
  return nullptr;
}

std::string namePart(const std::string& text) {
  std::string part;
  for (const char c : text) {
    const bool isUpper = c >= 'A' && c <= 'Z';
    const bool stays = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '.';
    const char next = isUpper ? static_cast<char>(c - 'A' + 'a') : stays ? c : '-';
    if (next != '-' || (!part.empty() && part.back() != '-')) {
      part += next;
    }
  }
  while (part.ends_with('-')) {
    part.pop_back();
  }
  return part.empty() ? "unnamed" : part;
}

}  // namespace ocelli
