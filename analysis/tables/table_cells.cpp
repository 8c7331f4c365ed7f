#include "analysis/tables/table_cells.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "oc_core/base/number_text.h"

namespace ocelli {
namespace {

Cell newCell(std::string name, std::string unit, std::string meaning) {
  Cell cell;
  cell.name = std::move(name);
  cell.unit = std::move(unit);
  cell.meaning = std::move(meaning);
  return cell;
}

RowRef rowOf(const Trial& trial) {
  return {trial.source, trial.trialId};
}

/// Share of the trials whose flag is set, among those that have it.
Cell shareCell(std::string name, const TrialList& trials, std::optional<bool> Trial::*flag, std::string meaning) {
  Cell cell = newCell(std::move(name), "%", std::move(meaning));
  int64_t counted = 0;
  for (const Trial* trial : trials) {
    if (trial->*flag) {
      counted += *(trial->*flag) ? 1 : 0;
      cell.rows.push_back(rowOf(*trial));
    }
  }
  cell.numerator = counted;
  cell.denominator = static_cast<int64_t>(cell.rows.size());
  if (cell.rows.empty()) {
    cell.missing = "no trials";
  } else {
    cell.value = 100.0 * static_cast<double>(counted) / static_cast<double>(cell.rows.size());
  }
  return cell;
}

void setMean(Cell& cell, double sum, const std::string& missing) {
  cell.denominator = static_cast<int64_t>(cell.rows.size());
  if (cell.rows.empty()) {
    cell.missing = missing;
  } else {
    cell.value = sum / static_cast<double>(cell.rows.size());
  }
}

}  // namespace

Cell meanTimeCell(std::string name, const TrialList& trials, TimeoutsInMeans timeouts) {
  Cell cell = newCell(std::move(name), "s", "");
  double sum = 0;
  int64_t removed = 0;
  for (const Trial* trial : trials) {
    if (!trial->responseSeconds) {
      continue;
    }
    if (trial->censored.value_or(false) && timeouts == TimeoutsInMeans::kRemoved) {
      ++removed;
      continue;
    }
    sum += *trial->responseSeconds;
    cell.rows.push_back(rowOf(*trial));
  }
  cell.meaning =
      timeouts == TimeoutsInMeans::kRemoved
          ? fmt::format("mean time of searches that ended in time; {} more whose time ran out are left out", removed)
          : "mean time of searches; those whose time ran out count as if they had ended then";
  setMean(cell, sum, removed > 0 ? "time ran out in all trials" : "no trials");
  return cell;
}

Cell rightShareCell(std::string name, const TrialList& trials) {
  return shareCell(std::move(name), trials, &Trial::correct,
                   "share of right answers; none within the time is a wrong one");
}

Cell timeoutShareCell(std::string name, const TrialList& trials) {
  return shareCell(std::move(name), trials, &Trial::censored, "share of trials whose time ran out");
}

Cell meanErrorCell(std::string name, const TrialList& trials) {
  Cell cell = newCell(std::move(name), "", "mean of answer less right answer; trials without an answer are left out");
  cell.decimals = 2;
  double sum = 0;
  for (const Trial* trial : trials) {
    const std::optional<double> answer = numberFromText<double>(trial->answer);
    const std::optional<double> expected = numberFromText<double>(trial->expected);
    if (answer && expected) {
      sum += *answer - *expected;
      cell.rows.push_back(rowOf(*trial));
    }
  }
  setMean(cell, sum, "no trials");
  return cell;
}

Cell lessByCell(std::string name, const Cell& worse, const Cell& better) {
  Cell cell =
      newCell(std::move(name), "%", fmt::format("how much less {} is than {}, of the latter", better.name, worse.name));
  cell.from = Cell::From::kCells;
  cell.cells = {worse.name, better.name};
  if (worse.value && better.value && *worse.value > 0) {
    cell.value = 100 * (*worse.value - *better.value) / *worse.value;
  } else {
    cell.missing = "not available";
  }
  return cell;
}

Cell publishedCell(std::string name, std::optional<double> value, std::string unit, std::string meaning) {
  Cell cell = newCell(std::move(name), std::move(unit), std::move(meaning));
  cell.value = value;
  cell.missing = "not reported";
  cell.from = Cell::From::kText;
  const double tenths = value.value_or(0) * 10;
  cell.decimals = std::abs(tenths - std::round(tenths)) > 1e-6 ? 2 : 1;
  return cell;
}

}  // namespace ocelli
