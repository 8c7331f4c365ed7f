// `--renderer` of the commands of `ocelli study` that draw what subjects saw.
#pragma once

#include <string>

#include "study/task/trial_image.h"

namespace CLI {
class App;
}

namespace ocelli {

/// Adds `--renderer raster|egl|osmesa`.
void addRendererOption(CLI::App& command, std::string& renderer);

/// For the thread that calls it. Throws InputError where this program was built without OpenGL and it is asked for.
StudyDrawer studyDrawer(const std::string& renderer);

}  // namespace ocelli
