// The pane of the transfer function: how often values stand in the volume, the opacity and the colour that they get,
// and the points that are edited.
#pragma once

#include "display_sim/viewer/transfer_pointer.h"
#include "display_sim/viewer/viewer_facts.h"

namespace ocelli {

/// How high the bars of a histogram stand, 0 to 1, one for each of `columns` equal parts of the axis: the logarithm of
/// 1 more than the greatest count among the bins that a part touches, as a share of that of all bins.
std::vector<float> histogramBars(const VolumeHistogram& histogram, const ValueAxis& axis, size_t columns);

/// Bars are grey; the curve is light on a dark casing, and so are the points, round and in their own colours. The
/// chosen one is larger, with a yellow ring. Below them the colours of all values, and numbers along both axes.
void drawTransferPlot(const PanelDrawing& drawing, const WindowRect& image);

/// For the header: "not saved, point 2 of 6: value 300, opacity 12 %".
std::string transferDetail(const ViewerState& state);

}  // namespace ocelli
