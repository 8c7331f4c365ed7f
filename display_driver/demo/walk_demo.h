// A walk on the demo's page: one place as a pinhole sees it, and as cameras do that see around corners.
#pragma once

#include <filesystem>
#include <string>

#include "display_driver/demo/demo_scene.h"

namespace ocelli {

/// `source` as loadGuidedScene() takes it: a grid maze. Writes the images below `folder`/`name`. The scene that it
/// gives has a row, and no figures. Throws what the rooms throw.
DemoScene runWalkDemo(const std::string& title, const std::string& source, const std::filesystem::path& folder,
                      const std::string& name, const DemoOptions& options, const Progress& progress);

}  // namespace ocelli
