// Where raw points of one group stand beside each other, so that none hides another.
#pragma once

#include <cstddef>
#include <vector>

namespace ocelli {

/// Offsets across the axis for points at these places along it, all in points; a point takes `diameter`. Each stands as
/// near to the middle as those before it, from low to high, let it. Where that would pass `halfWidth`, all offsets
/// shrink to fit, and points overlap evenly. Independent of the order in which the places come.
std::vector<double> swarmOffsets(const std::vector<double>& places, double diameter, double halfWidth);

/// Which of the values are drawn, at most `most`: those that are finite, evenly by rank, the least and the greatest
/// with them.
std::vector<size_t> drawnPoints(const std::vector<double>& values, size_t most);
inline constexpr size_t kMaxPoints = 1200;  ///< of a group; more would be a solid bar, and a file of megabytes

}  // namespace ocelli
