// The outlines of text, for what does not draw by Cairo.
#pragma once

#include <string_view>
#include <vector>

#include "oc_core/drawing/drawing.h"
#include "oc_core/drawing/typeface.h"

namespace ocelli {

/// The outlines of one character, each closed, as corners; what they wind around (nonzero rule) is ink.
using GlyphOutline = std::vector<std::vector<PlotPoint>>;

/// Of one line of clean text (utf8.h) at size 1, from the start of its baseline at the origin; y is upwards. Characters
/// without ink are left out. Corners are within 0.003 of the curves. Widths add up as textWidth() has them.
std::vector<GlyphOutline> textOutlines(std::string_view text, Face face);

/// How high a capital letter of the face is at size 1; 0 where there is no font.
double capitalHeight(Face face);

}  // namespace ocelli
