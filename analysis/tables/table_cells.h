// The kinds of cells that tables of trials have.
#pragma once

#include <string>
#include <vector>

#include "analysis/dataset/dataset.h"
#include "analysis/tables/table.h"

namespace ocelli {

using TrialList = std::vector<const Trial*>;

/// What becomes of searches whose time ran out, in means of times.
enum class TimeoutsInMeans : uint8_t { kRemoved, kSetToLimit };

/// Mean response, seconds. The rows are those that the mean is of.
Cell meanTimeCell(std::string name, const TrialList& trials, TimeoutsInMeans timeouts);
/// Share of trials with the right answer, percent.
Cell rightShareCell(std::string name, const TrialList& trials);
/// Share of trials whose time ran out, percent.
Cell timeoutShareCell(std::string name, const TrialList& trials);
/// Mean of answer less expected answer, of trials where both are numbers.
Cell meanErrorCell(std::string name, const TrialList& trials);
/// By how much `better` is below `worse`, percent of `worse`.
Cell lessByCell(std::string name, const Cell& worse, const Cell& better);
/// Of the text, with one or two decimals as it has them; a cell that says "not reported" where it has no value.
Cell publishedCell(std::string name, std::optional<double> value, std::string unit, std::string meaning);

}  // namespace ocelli
