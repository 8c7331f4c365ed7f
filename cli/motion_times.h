// Commands that take all of a scene's motion: --frames-per-second, and the motion as frames.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/command.h"
#include "cli/scene_options.h"
#include "oc_core/worlds/scene_motion.h"

namespace CLI {
class App;
}

namespace ocelli {

/// Adds --frames-per-second; `help` says of what.
void addFrameRateOption(CLI::App& command, std::optional<double>& hertz, const std::string& help);

/// A motion, and its frames: evenly spaced from its begin on, within its duration.
struct FramedMotion {
  std::unique_ptr<SceneMotion> motion;
  std::vector<double> seconds;
};

/// Throws InputError where the scene stands still, where --time is given too, and for more than 100,000 frames.
FramedMotion loadFramedMotion(const SceneChoice& scene, double hertz, const CommandContext& context);

}  // namespace ocelli
