// The page of `ocelli remote measure`: figures, charts and pictures side by side. Plain HTML and CSS, no script,
// nothing from the network.
#pragma once

#include <filesystem>
#include <string>

#include "oc_core/remote_measure/remote_measure.h"

namespace ocelli {

/// Writes index.html and its pictures into a folder that is there. Throws WorkError.
void writeRemoteMeasurePage(const std::filesystem::path& folder, const std::string& version,
                            const RemoteMeasureOptions& options, const RemoteMeasurement& measurement);

/// The text of index.html alone.
std::string remoteMeasurePage(const std::string& version, const RemoteMeasureOptions& options,
                              const RemoteMeasurement& measurement);

}  // namespace ocelli
