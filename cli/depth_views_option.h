// The option --from FOLDER, of commands that take views with depth in place of a scene.
#pragma once

#include <string>

#include "cli/command.h"
#include "oc_core/scene/mesh.h"

namespace ocelli {

/// Adds --from FOLDER.
void addFromOption(CLI::App& command, std::string& folder, const std::string& help);

/// Of a command whose SCENE may be missing: throws InputError where neither that nor --from is given, or both are, or
/// with --from an option that says how a scene is read.
void requireSceneOrViews(const CLI::App& command, const std::string& scene, const std::string& folder);

/// What the views of a folder show together; notes how many they are, and how many of their samples stay.
Mesh surfaceFrom(const std::string& folder, const CommandContext& context);

}  // namespace ocelli
