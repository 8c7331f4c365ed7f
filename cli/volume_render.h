// `ocelli render` of volumes: along the rays of any camera (oc_core/volume_camera, oc_core/volume_render).
#pragma once

#include <optional>
#include <string>

#include "cli/command.h"
#include "cli/scene_options.h"
#include "cli/volume_options.h"
#include "oc_core/camera/pinhole_camera.h"

namespace ocelli {

/// The options of `ocelli render` for volumes alone.
struct VolumeRenderChoice {
  std::optional<double> step;
  std::string surfaces;
  std::string surfacesFrame;
  std::string background;
  bool json = false;
};

/// Adds --step, --surfaces, --surfaces-frame, --background and --json.
void addVolumeRenderOptions(CLI::App& command, VolumeRenderChoice& choice);
/// For scenes that are no volumes: throws InputError where one of them is given.
void refuseVolumeRenderOptions(const VolumeRenderChoice& choice);
/// For volumes: throws InputError where an option that they do not have is given.
void refuseForVolumes(bool isGiven, const std::string& option, const std::string& what, const std::string& next);

struct VolumeRender {
  SceneChoice scene;
  VolumeChoice volume;
  VolumeRenderChoice options;
  std::string camera;
  std::string method;  ///< empty: along the rays, on the CPU
  std::string gl;
  std::string output;
  PinholeCamera reference;
};

/// Draws the picture and writes it. Throws InputError for what does not go together, and where it shows nothing.
void renderVolumeScene(const VolumeRender& render, const CommandContext& context);

}  // namespace ocelli
