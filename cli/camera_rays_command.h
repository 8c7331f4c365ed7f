// `ocelli camera rays`, and what `ocelli camera info` tells of ray maps.
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace ocelli {

class CommandContext;

void addCameraRays(CLI::App& camera, const CommandContext& context);

/// Prints what a ray map consists of.
void printRayMapInfo(const std::string& file, bool json, const CommandContext& context);

}  // namespace ocelli
