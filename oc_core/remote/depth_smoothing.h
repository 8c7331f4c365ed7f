// What was between the levels of rounded depths (remote_depth.h), as far as the image itself tells.
//
// Rounding turns slopes into steps, which look like small edges: surfaces fall apart there when their samples are
// moved. 1/z is linear across the image of a plane, so each value is moved towards the middle of its two neighbours
// along a row, a column or both, where the three lie on a line but for what rounding does. It stays within half a level
// of what was sent, so nothing is made up, and edges stay as sharp as they came.
#pragma once

#include "oc_core/remote/remote_depth.h"

namespace ocelli {

/// Fractions of levels, as RemoteDepth::values; 0 where nothing is seen.
Image<float> smoothedLevels(const Image<uint16_t>& values);

}  // namespace ocelli
