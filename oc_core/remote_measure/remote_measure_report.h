// The figures of `ocelli remote measure` as a table for a terminal, as CSV and as JSON.
#pragma once

#include <string>

#include "oc_core/remote_measure/remote_measure.h"

namespace ocelli {

std::string remoteMeasureTable(const RemoteMeasureOptions& options, const RemoteMeasurement& measurement);
/// A line a mode and link. Fields that a mode has no value for are empty.
std::string remoteMeasureCsv(const RemoteMeasurement& measurement);
std::string remoteMeasureJson(const RemoteMeasureOptions& options, const RemoteMeasurement& measurement);

}  // namespace ocelli
