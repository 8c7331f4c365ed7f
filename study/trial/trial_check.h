// The values that columns of trials and answers must not hold, in a database or a table. A damaged file, or one that
// was changed by hand, must not give numbers that nobody measured.
#pragma once

#include <optional>
#include <string>

#include "study/trial/trial_row.h"

namespace ocelli {

struct TrialProblem {
  std::string column;
  std::string problem;  ///< "is inf, but must be a number from 0 to 1000000"
};

/// Of names of subjects, blocks, cases, forms and their fields: "has 5000 bytes, but a name has at most 1000"; or
/// empty.
std::string problemOfName(const std::string& name);

/// The first one; nothing where there is none.
std::optional<TrialProblem> problemOf(const TrialRow& trial);

/// What the columns of a trial say against each other, each of them possible by itself: that it took longer than its
/// limit (of its row, or else `limitSeconds` of its block), but its time did not run out. A whole clause, or empty.
std::string contradictionOf(const TrialRow& trial, std::optional<double> limitSeconds);

}  // namespace ocelli
