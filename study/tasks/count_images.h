// What counting objects looks like, for instruction pages: a few objects in a maze, in one image of the comprehensive
// graph camera and in several of pinholes.
#pragma once

#include <vector>

#include "study/task/instruction_image.h"

namespace ocelli {

std::vector<InstructionImage> countImages();

}  // namespace ocelli
