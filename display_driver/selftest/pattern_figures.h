// What a test pattern is on a display, in numbers: sentences for the checklist of a builder.
#pragma once

#include <string>
#include <vector>

#include "display_sim/frames/display_profile.h"

namespace ocelli {

std::vector<std::string> noFigures(const DisplayProfile& profile);
std::vector<std::string> darkFigures(const DisplayProfile& profile);
std::vector<std::string> axisFigures(const DisplayProfile& profile);
std::vector<std::string> phaseFigures(const DisplayProfile& profile);
std::vector<std::string> wedgesFigures(const DisplayProfile& profile);
std::vector<std::string> stairsFigures(const DisplayProfile& profile);
std::vector<std::string> boxFigures(const DisplayProfile& profile);
std::vector<std::string> sphereFigures(const DisplayProfile& profile);
std::vector<std::string> focusFigures(const DisplayProfile& profile);
std::vector<std::string> coloursFigures(const DisplayProfile& profile);
std::vector<std::string> brightnessFigures(const DisplayProfile& profile);
std::vector<std::string> whiteFigures(const DisplayProfile& profile);

}  // namespace ocelli
