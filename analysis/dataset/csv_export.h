// The tables that `ocelli study export` writes (form csv) as the data of an analysis.
//
// They hold less than the database: no protocol, no consent, no planned lengths. What depends on these is not known
// then. A text that begins with ' and =, +, -, @, a tab or a carriage return loses the ', which the export put there.
#pragma once

#include "analysis/dataset/dataset.h"

namespace ocelli {

/// From subjects.csv, runs.csv, trials.csv and answers.csv of the folder, and `protocolFile` where one is given. Throws
/// InputError that says file, line and column.
Dataset readCsvExport(const std::string& folder, const std::string& protocolFile = "");

}  // namespace ocelli
