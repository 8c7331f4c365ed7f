// Images of what dithers do to the fields of dither_fields.h, and of how even surfaces are lit.
#pragma once

#include <span>
#include <vector>

#include "display_sim/dither_score/dither_fields.h"
#include "display_sim/dither_score/light_evenness.h"
#include "oc_core/image/image.h"

namespace ocelli {

/// A row for each dither. From the left: the field's first slice as it should be, as it is shown, the means of its
/// first blocks, and their errors, 32 times as large around grey.
Image<Rgb8> ditherImage(const DitherField& field, std::span<const NamedDither> dithers, int bitsPerChannel);

/// A plot for each of `measured`, side by side: light for its area, from 1/2 to 64 with a line at each doubling,
/// against the radius from 0 to 1 with a line at each tenth. Red: floor; green: cylinders; blue: wall; black: fin.
Image<Rgb8> evennessImage(const std::vector<std::vector<LightSample>>& measured);

}  // namespace ocelli
