// The page of `ocelli demo`: plain HTML and CSS, no script, nothing from the network.
#pragma once

#include <string>
#include <vector>

#include "display_driver/demo/demo_scene.h"

namespace ocelli {

/// The whole of index.html. `version` is that of the program.
std::string demoPage(const std::vector<DemoScene>& scenes, const DemoOptions& options, const std::string& version);

}  // namespace ocelli
