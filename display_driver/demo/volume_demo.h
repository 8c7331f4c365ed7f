// A volume on the demo's page: opened above, and seen by pinholes and by a camera whose rays bend into it.
#pragma once

#include <filesystem>
#include <string>

#include "display_driver/demo/demo_scene.h"

namespace ocelli {

/// `source` as loadVolumeScene() takes it. Writes the images below `folder`/`name`. The scene that it gives has rows,
/// and no figures. Throws what the rooms throw.
DemoScene runVolumeDemo(const std::string& title, const std::string& source, const std::filesystem::path& folder,
                        const std::string& name, const DemoOptions& options, const Progress& progress);

}  // namespace ocelli
