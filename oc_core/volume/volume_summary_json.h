// The figures of a volume as JSON: what `ocelli scene info --json` prints, and Python gives.
#pragma once

#include <string>

#include "oc_core/volume/volume_summary.h"

namespace ocelli {

/// {"volume", "format", "modality", "size", "type", "spacing", "unit", "anatomical", "axes",
/// "world_from_index_columns", "lower", "upper", "value_unit", "scale", "offset", "least", "greatest", "percentiles",
/// "not_finite", "bytes", "bytes_to_read", "mapped", "times", "transfer", "level"}, and "first_not_finite" where there
/// is one. `source` names the volume. Ends with a line feed.
std::string volumeSummaryJson(const std::string& source, const VolumeSummary& summary);

}  // namespace ocelli
