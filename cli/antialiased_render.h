// `ocelli render --antialias`: images whose pixels are averages.
#pragma once

#include "cli/command.h"
#include "cli/scene_options.h"
#include "oc_core/camera/pinhole_camera.h"

namespace ocelli {

struct AntialiasedRender {
  SceneChoice scene;
  std::string camera;
  std::string method;
  std::string antialias;
  std::string output;
  PinholeCamera reference;
};

/// Adds --antialias.
void addAntialiasOption(CLI::App& command, std::string& antialias);

/// Draws the image and writes it. Pinholes and general pinholes are rasterised; other cameras, and all with --method
/// raycast, cast rays. Throws InputError for what does not go together.
void renderAntialiased(const AntialiasedRender& render, const CommandContext& context);

}  // namespace ocelli
