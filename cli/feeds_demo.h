// Graph cameras from video on the demo's page: what `ocelli-feeds` makes of simulated feeds, and the same in panes.
#pragma once

#include <filesystem>
#include <optional>

#include "cli/command.h"
#include "display_driver/demo/demo_scene.h"

namespace ocelli {

/// Writes images below `folder`/feeds. Nothing where ocelli-feeds is not there, or fails; the context is told.
std::optional<DemoScene> runFeedsDemo(const std::filesystem::path& folder, const CommandContext& context);

}  // namespace ocelli
