// What `ocelli scene info` says of a volume.
#pragma once

#include <string>

#include "oc_core/volume/volume_summary.h"

namespace ocelli {

std::string volumeInfoAsText(const std::string& source, const VolumeSummary& summary);

}  // namespace ocelli
