// How wide the free space is at each square: the side of the largest square of free floor that covers it. Corridors
// have their width all along, to their very ends; rooms have their shorter side; a door has its own width.
//
// Squares stand along the axes of the grid, so distances are the larger of those along x and z.
#pragma once

#include <cstdint>
#include <vector>

#include "oc_core/walkable/walk_field.h"

namespace ocelli {

/// Of each square, the number of steps to the nearest that is missing, diagonal steps included: 1 at the border.
/// Squares of different `labels` are missing to each other; empty: all are of one.
std::vector<uint16_t> stepsToBorder(const WalkField& field, const std::vector<uint32_t>& labels = {});

/// Half of the width at each square, in steps: the free square around a center whose stepsToBorder() is n has a side of
/// 2 n - 1 squares, and n is what its squares get. What is wider than `limit` is as wide as that.
std::vector<uint16_t> halfWidths(const WalkField& field, std::vector<uint16_t> steps, uint16_t limit);

}  // namespace ocelli
