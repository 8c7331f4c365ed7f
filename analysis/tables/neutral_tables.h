// The tables of chapter 7 for studies by other protocols: the same questions, under names of their own and without the
// values that were published for another study.
#pragma once

#include <vector>

#include "analysis/dataset/dataset.h"
#include "analysis/tables/table.h"

namespace ocelli {

/// Whether all protocols are those of Rosen 2010, by their names, "rosen2010", "rosen2010-balanced", ..., and their
/// view conditions.
bool isOfRosen2010(const Dataset& data);

/// "table-7.1/stationary/session-1/bent" becomes "find-by-session/stationary/session-1/bent"; columns of published
/// values go, rows of questions that nobody was asked, and tables without a value: of tasks that a study does
/// not have.
void makeNeutral(std::vector<Table>& tables, const ViewConditions& conditions);

}  // namespace ocelli
