// What a maze must be, so that one can walk through it.
#pragma once

#include <string>

#include "oc_core/scene/maze.h"

namespace ocelli {

/// Throws InputError naming the cell where there is no entrance, where the entrance is not at the border behind it, a
/// cell cannot be reached from it, a landmark is outside of its cell or in a wall, an arch is where no passage is to be
/// spanned, or a size is out of range.
void validate(const Maze& maze, const std::string& where);

}  // namespace ocelli
