// The options of commands whose SCENE may be a volume (oc_core/volume), beside those of every SCENE (scene_options.h).
//
// A command that works on volumes calls addVolumeOptions() after addSceneOptions(), and begins with
//
//   if (takesVolume(choice.scene)) {
//     return ...(loadVolume(choice.scene, choice.volume, context));
//   }
//   refuseVolumeOptions(choice.volume);
//
// All other commands take volumes as the mesh of an isosurface, --iso, and refuse them without it: loadScene() does.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/command.h"
#include "cli/scene_options.h"
#include "oc_core/volume/volume_scene.h"

namespace CLI {
class App;
}

namespace ocelli {

struct VolumeChoice {
  std::vector<std::string> clips;
};

/// Adds --clip. `choice` must outlive the parsing.
void addVolumeOptions(CLI::App& command, VolumeChoice& choice);

/// Adds --opacity, of commands that take the first hits of a volume for its surface (oc_core/volume_ocri).
void addOpacityOption(CLI::App& command, std::optional<double>& opacity);

/// Whether SCENE is a volume, and taken as one: not as an isosurface.
bool takesVolume(const SceneChoice& scene);

/// Throws InputError where something is said that only volumes have: for scenes that are none.
void refuseVolumeOptions(const VolumeChoice& choice);
/// The same for any option of a command: throws where it `isGiven`.
void refuseVolumeOption(bool isGiven, const std::string& option);

/// What both choices say; throws InputError for what cannot be read, or is of meshes alone.
VolumeSceneOptions volumeSceneOptionsOf(const SceneChoice& scene, const VolumeChoice& choice);

/// Throws as loadVolumeScene() does. --shading, where given, overrules what the transfer function says.
VolumeScene loadVolume(const SceneChoice& scene, const VolumeChoice& choice, const CommandContext& context);
/// What --shading says, of a volume that was loaded in another way.
void applyShading(const SceneChoice& scene, VolumeScene& volume);

}  // namespace ocelli
