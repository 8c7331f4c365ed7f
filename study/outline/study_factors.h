// Factors of a study: the field "factors" of a protocol declares them with their levels, and the field "factors" of
// each condition, or of each case, says which level it has. Factors of conditions part the conditions into cells, one
// for each combination of levels; a design is crossed where each cell has one condition.
#pragma once

#include <string>
#include <vector>

#include "study/trial/view_condition.h"

namespace ocelli {

class JsonFields;

enum class FactorsOf : uint8_t { kConditions, kCases };

/// "factors" of the protocol; none where it is missing. Throws InputError naming the field.
std::vector<StudyFactor> readFactors(JsonFields& protocol);

/// "factors" of a condition or a case: a declared level of each factor of its kind, and of no other. Throws InputError
/// naming the field.
FactorLevels readLevels(JsonFields& owner, const std::vector<StudyFactor>& factors, FactorsOf of);

/// How the factors of conditions are crossed. Cells are told as "graph, low", in the order of the factors.
struct FactorCrossing {
  std::vector<std::string> missing;  ///< cells without a condition
  std::vector<std::string> doubled;  ///< cells of several conditions, with these: "graph, low (a, b)"
};
FactorCrossing crossingOf(const ViewConditions& conditions);

/// The cells of these factors, the levels of the last changing first: {"graph", "low"}, {"graph", "high"}, ...
std::vector<std::vector<std::string>> cellsOf(const std::vector<StudyFactor>& factors);
std::vector<StudyFactor> factorsOf(const ViewConditions& conditions, FactorsOf of);

}  // namespace ocelli
