// What finding an object looks like, for instruction pages: a corridor, with the object around the corner, seen through
// the pinhole and the graph camera.
#pragma once

#include <vector>

#include "study/task/instruction_image.h"

namespace ocelli {

std::vector<InstructionImage> findImages();

}  // namespace ocelli
