// Reading report.json back, as a program of a reader would.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace ocelli::test {

/// The element with this anchor; null where there is none.
nlohmann::json elementOf(const nlohmann::json& report, const std::string& id);

/// Of the table's first row whose head holds `row` in the words of the report ("ppc" is "pinhole"), or has that short
/// name, the value below the column with this title.
std::optional<double> valueIn(const nlohmann::json& report, const std::string& table, const std::string& row,
                              const std::string& column);

/// The value of the cell with this name, which --explain takes.
std::optional<double> valueOfCell(const nlohmann::json& report, const std::string& name);
/// All of these, as "name value".
std::vector<std::string> namedValues(const nlohmann::json& report);

/// Texts of notes that say what cannot be estimated.
std::vector<std::string> notEstimable(const nlohmann::json& report);

/// Every number that is none, or that its own table contradicts: "nan" in a text, a p value beyond 1, an interval that
/// leaves out its estimate, a hypothesis that is decided without a p value.
std::vector<std::string> dishonestNumbers(const nlohmann::json& report);

/// "nan" and "inf" where they stand as words in a text, with what is around them.
std::vector<std::string> numbersThatAreNone(const std::string& text);

}  // namespace ocelli::test
