// A scale from little to much for heat maps: from pale yellow over teal to dark blue, on a path through CIELAB whose
// lightness falls evenly, so that equal steps look equal, also to the colour-blind and in grey print.
#pragma once

#include "oc_core/drawing/drawing.h"

namespace ocelli {

/// `share` from 0 to 1; beyond, the ends.
Paint scaleColor(double share);

/// L*, a*, b* under D65.
struct LabColor {
  double lightness = 0;
  double a = 0;
  double b = 0;
};
LabColor labOf(const Paint& paint);

}  // namespace ocelli
