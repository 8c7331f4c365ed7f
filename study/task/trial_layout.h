// What one moment of a trial looks like: which cameras show the scene, and where on the screen. Whoever draws it, sees
// it (a simulated subject) or replays it takes it from here; nothing in it depends on how it is drawn.
#pragma once

#include <algorithm>
#include <array>
#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "oc_core/base/input_event.h"
#include "oc_core/camera/graph_camera.h"
#include "oc_core/camera/pinhole_camera.h"
#include "study/task/pixel_rect.h"
#include "study/task/study_scene.h"

namespace ocelli {

using StudyCamera = std::variant<PinholeCamera, GraphCamera>;

/// The screen that a trial is drawn for. Tasks lay everything out in its pixels.
struct TrialScreen {
  int width = 1920;
  int height = 1200;
  double refreshHertz = 60;  ///< frames a second: exposures are counted in them

  bool operator==(const TrialScreen&) const = default;
};

/// Pixels at the top of the screen that the prompt takes; views, maps and choices lie below them.
constexpr int promptHeight(const TrialScreen& screen) {
  return std::max(48, screen.height * 3 / 40);
}

struct TrialLayout {
  /// An image of the scene, as large as its place.
  struct View {
    PixelRect place;
    StudyCamera camera;
  };
  /// A path drawn as a map: corners in metres, x to the east, y to the south; the first is the start.
  struct PathMap {
    PixelRect place;
    std::vector<glm::dvec2> corners;
  };
  /// An answer to choose, by a click on its place, or by its key.
  struct Choice {
    PixelRect place;
    std::string label;
    Key key = Key::k1;
    bool chosen = false;
  };

  const StudyScene* scene = nullptr;       ///< of the views; lives as long as the trial
  std::vector<glm::vec3> objectOffsets{};  ///< of the objects of `scene`, from where they stand at first
  std::vector<View> views{};
  std::vector<PathMap> maps{};
  std::vector<Choice> choices{};
  std::string prompt{};                 ///< one line in the topmost promptHeight() pixels: what to do
  std::optional<int> targetObject{};    ///< an object of `scene` to show beside the prompt
  std::optional<glm::dvec2> pointer{};  ///< where the pointer is, where it matters
};

}  // namespace ocelli
