// Errors in false colours over a dimmed image of the truth. The colours are of the palette of Okabe and Ito: they
// differ to every kind of colour vision.
#pragma once

#include "oc_core/evaluation/frame_errors.h"

namespace ocelli {

/// sRGB. Where several hold, the first of these shows.
inline constexpr Rgb8 kWrongFrontColor{204, 121, 167};
inline constexpr Rgb8 kFalseSkinColor{86, 180, 233};
inline constexpr Rgb8 kMissingThickColor{240, 228, 66};
inline constexpr Rgb8 kMissingColor{213, 94, 0};

Image<Rgb8> errorImage(const ViewFrame& truth, const FrameComparison& comparison);

}  // namespace ocelli
