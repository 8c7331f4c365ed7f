// Which column of a table of trials is what, for tables that other tools wrote (PsychoPy, jsPsych, UXF, ...). A map is
// a JSON file: column_maps/column_map.schema.json lists its fields. mapped_trials.h reads tables by it.
//
// Recipe for a map that comes with the program:
//   1. analysis/dataset/column_maps/NAME.json, with a table of the tool in column_maps/examples/NAME.csv (for tests).
//   2. Its name in the list of analysis/dataset/CMakeLists.txt.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace ocelli {

/// A text of each row: the field of a column, or the same text for all, or the file's name without its ending.
struct MappedText {
  std::string column{};
  std::string value{};
  bool isFileName = false;

  bool isSet() const { return !column.empty() || !value.empty() || isFileName; }
  bool operator==(const MappedText&) const = default;
};

/// Whether a row is of some sort: its field is one of `is`, or, where that is empty, none of `isNot`.
struct RowTest {
  std::string column{};
  std::vector<std::string> is{};
  std::vector<std::string> isNot{};
  bool mayBeMissing = false;  ///< no row passes where the table lacks the column

  bool isSet() const { return !column.empty(); }
  bool passes(const std::string& field) const;
  bool operator==(const RowTest&) const = default;
};

struct MappedTime {
  std::string column{};
  std::string minus{};  ///< a column that is taken off; or nothing
  double secondsOfUnit = 1;

  bool operator==(const MappedTime&) const = default;
};

struct MappedCorrect {
  std::string column{};
  std::vector<std::string> right{};
  std::vector<std::string> wrong{};

  bool operator==(const MappedCorrect&) const = default;
};

/// Which trials were cut off: those with one of the texts in a column; without a column, those as long as the limit.
struct MappedTimeout {
  std::string column{};
  std::vector<std::string> is{};
  std::optional<double> limitSeconds{};

  bool isSet() const { return !column.empty() || limitSeconds.has_value(); }
  bool operator==(const MappedTimeout&) const = default;
};

struct MappedCondition {
  std::string value;  ///< in the table
  std::string name;   ///< letters, digits, "-", "_", "."
  std::string label;

  bool operator==(const MappedCondition&) const = default;
};

/// Who gave the answers of all rows but those that ColumnMap::simulated picks.
enum class MappedSubjects : uint8_t { kUnknown, kPeople, kSimulated };
inline constexpr MappedSubjects kMappedSubjects[] = {MappedSubjects::kUnknown, MappedSubjects::kPeople,
                                                     MappedSubjects::kSimulated};
/// "unknown", "people", "simulated".
const char* nameOf(MappedSubjects subjects);

struct ColumnMap {
  std::string name;    ///< of the file, or of the map that comes with the program
  std::string sha256;  ///< of its text, 64 hexadecimal digits
  std::string tool = "another tool";
  char separator = ',';
  char decimalPoint = '.';
  MappedSubjects subjects = MappedSubjects::kUnknown;
  RowTest simulated{};
  std::vector<RowTest> rows{};  ///< a row is a trial where it passes all
  RowTest practice{};
  MappedText subject{};
  MappedText session{};                      ///< not set: 1
  std::vector<std::string> sessionValues{};  ///< of sessions 1, 2, ...; empty: they are numbers
  MappedText task{.value = "main"};
  MappedText block{};  ///< not set: the task
  MappedText condition{};
  std::vector<MappedCondition> conditions{};  ///< the reference first; empty: those of the table
  MappedText caseLabel{};
  MappedText trial{};  ///< not set: rows count
  MappedTime time{};
  MappedText answer{};
  MappedText expected{};
  MappedCorrect correct{};
  MappedTimeout timeout{};
  std::map<std::string, std::string> measures{};  ///< columns by name
};

/// Of the maps that come with the program: "jspsych", "psychopy", "uxf".
std::vector<std::string> builtInColumnMapNames();

/// A name, or else a file. Throws InputError that says line and field, or which names there are.
ColumnMap readColumnMap(const std::string& nameOrPath);
ColumnMap columnMapFromJsonText(const std::string& text, const std::string& name);

/// A name that conditions may have, made of a text: "wide_field" of "wide field"; empty where nothing is left of it.
std::string conditionNameFrom(const std::string& value);

}  // namespace ocelli
