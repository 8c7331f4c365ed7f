// The least zoom that a transition of a general pinhole camera allows: below it samples would fold (gpc_profile.h).
#pragma once

#include "oc_core/camera/gpc_profile.h"

namespace ocelli {

/// To the precision of double, from above: a profile of this zoom is increasing. At most 1, where none folds. `outer`
/// > 1.
double leastUnfoldedZoom(const GpcSampling& sampling, double outer);

}  // namespace ocelli
