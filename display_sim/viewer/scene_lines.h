// What is drawn into the scene pane besides the scene: the reference camera's frustum, the rays of the chosen camera,
// the view cell and the user's eye.
#pragma once

#include <optional>

#include "display_sim/viewer/background_work.h"
#include "display_sim/viewer/colored_line.h"

namespace ocelli {

/// A pixel of one of the reference images.
struct PickedPixel {
  int image = 0;
  glm::ivec2 pixel{0};
  bool operator==(const PickedPixel&) const = default;
};

struct SceneLines {
  std::vector<ColoredLine> lines;
  size_t straightRays = 0;  ///< that were drawn
  size_t bentRays = 0;
};

/// Rays end at the sample that they hold; those without one at the far end of `bounds`. `rays` may be null: not known
/// yet. Widths are in pixels times `lineScale`.
SceneLines sceneLines(const ViewerState& state, const BuiltCamera& camera, const std::vector<RayFunction>* rays,
                      const Box& bounds, const std::optional<PickedPixel>& picked, float lineScale);

}  // namespace ocelli
