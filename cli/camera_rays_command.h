// `ocelli camera rays`, and what `ocelli camera info` tells of ray maps; and the options of commands that write the
// rays of a camera in other ways.
#pragma once

#include <string>

#include "cli/scene_options.h"
#include "oc_core/camera/pinhole_camera.h"
#include "oc_core/camera/ray_map.h"

namespace CLI {
class App;
}

namespace ocelli {

class CommandContext;

/// Whose rays, and how many.
struct RaysChoice {
  std::string camera;
  SceneChoice scene;
  std::string view;
  std::string size;
  int image = 0;
};
/// Adds the argument CAMERA, --scene with what belongs to it, --view, --size and --image. `choice` must outlive the
/// parsing.
void addRaysOptions(CLI::App& command, RaysChoice& choice, const CommandContext& context);
PinholeCamera raysReference(const RaysChoice& choice);
RayMap raysOf(const RaysChoice& choice, const PinholeCamera& reference, const CommandContext& context);
/// Throws InputError where --image is given, of a camera with one image.
void refuseImageNumber(const RaysChoice& choice);

void addCameraRays(CLI::App& camera, const CommandContext& context);

/// Prints what a ray map consists of.
void printRayMapInfo(const std::string& file, bool json, const CommandContext& context);

}  // namespace ocelli
