// The options on dithering that commands share.
#pragma once

#include <string>
#include <vector>

#include "display_sim/dither/slice_options.h"

namespace CLI {
class Validator;
}

namespace ocelli {

std::vector<std::string> ditherNames();
/// `name` is one of ditherNames().
ColorReduction ditherOfName(const std::string& name);
/// Numbers from 0 to 1.
CLI::Validator radiusCheck();

}  // namespace ocelli
