// What the window is tested with: it draws quickly, without a scene, and remembers what it was asked for.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "oc_core/explore_window/explore_window_model.h"

namespace ocelli::test {

/// What a model was asked for; it outlives the model.
struct ModelRecord {
  std::vector<std::string> calls;  ///< "choose 1", "pick 320 200", ...
  WindowMotion motion;             ///< of the last frame
  glm::vec2 turned{0};             ///< all of it
  double seconds = 0;
  int frames = 0;
  WindowShape shape;
};

/// Three cameras, of which the second has options; one bend, two cells, a portal.
std::unique_ptr<ExploreWindowModel> makeRecordingModel(ModelRecord& record);

}  // namespace ocelli::test
