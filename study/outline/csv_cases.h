// Cases of a block that stand in a table: `"cases": {"csv": "cases.csv"}`, and the same for "practice_cases". The name
// is relative to the protocol's folder. The table takes the place of the field before the protocol is read, so that a
// database holds a text with all cases in it.
//
// The first line names the fields of a case: "row", "start.column" for a field of an object, and the name of a declared
// factor of cases for its level. Each further line is a case; an empty cell is a field that the case does not have.
// Labels and levels are texts. Other cells are numbers, true or false, lists and objects of JSON where they read so, or
// else texts.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace ocelli {

/// Where the cases of a field came from.
struct CsvCases {
  std::string pointer;  ///< JSON pointer of the field: "/blocks/0/cases"
  std::string file;
  std::vector<std::string> columns;
  std::vector<int> lines;  ///< of each case

  /// "cases.csv:4, column 2 (row)", of the case number `index` from 0. `field` names the column, where one has it.
  std::string placeOf(size_t index, const std::string& field) const;
};

struct ProtocolText {
  std::string text;  ///< with each table in the place of its field; lines stay what they were
  std::vector<CsvCases> tables{};
};

/// `text` is that of `file`. Throws InputError saying file, line and column of what is wrong with a table. A text
/// without tables stays as it is, byte by byte.
ProtocolText withCsvCases(const std::string& text, const std::filesystem::path& file);
/// The text of the file with its tables.
ProtocolText readProtocolText(const std::filesystem::path& file);

}  // namespace ocelli
