// The page of `ocelli demo`: plain HTML and CSS, no script, nothing from the network.
#pragma once

#include <string>
#include <vector>

#include "cli/demo_scene.h"

namespace ocelli {

/// The whole of index.html. `version` is that of the program.
std::string demoPage(const std::vector<DemoScene>& scenes, const DemoOptions& options, const std::string& version);

/// The text with everything escaped that HTML would read as markup.
std::string htmlFromText(const std::string& text);

}  // namespace ocelli
