// The options of every command that takes a SCENE.
#pragma once

#include <string>

#include "oc_core/camera/view.h"
#include "oc_core/scene/scene_source.h"

namespace CLI {
class App;
}

namespace ocelli {

struct SceneChoice {
  std::string source;
  SceneOptions options;
};

/// Adds the argument SCENE, --no-fit, --shading and --no-textures. `choice` must outlive the parsing.
void addSceneOptions(CLI::App& command, SceneChoice& choice);

/// Adds --view FILE.json. Read it with readViewOption() when the command runs.
void addViewOption(CLI::App& command, std::string& path);
/// The view of the file, or the default one where no --view was given. Throws InputError.
View readViewOption(const std::string& path);

}  // namespace ocelli
