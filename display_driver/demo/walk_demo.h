// Someone who walks in a scene, on the demo's page: what a pinhole shows, and cameras whose rays turn into the ways that
// leave where he stands (sections 4.3.1 and 4.3.2).
#pragma once

#include <filesystem>
#include <string>

#include "display_driver/demo/demo_scene.h"

namespace ocelli {

/// `source` as loadScene() takes it, in metres. Someone stands where the scene's path has gone on for `steps` of its
/// points, and looks on along it. Writes the images below `folder`/`name`. The scene that it gives has rows, and no
/// figures; images that need to know where one can walk are left out where this cannot be found (canFindWalkable()).
/// Throws what the rooms throw.
DemoScene runWalkDemo(const std::string& title, const std::string& source, const std::filesystem::path& folder,
                      const std::string& name, const DemoOptions& options, const Progress& progress);

}  // namespace ocelli
