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

/// The ray of a pixel, from the eye to the sample that it holds; to the far end of `bounds` where it holds none. Empty
/// where there is no such image.
std::vector<glm::vec3> sampledRay(const BuiltCamera& camera, const std::vector<RayFunction>& rays, const Box& bounds,
                                  const PickedPixel& at);

/// Rays that hold samples.
struct RayGrid {
  std::vector<std::vector<glm::vec3>> straight;
  std::vector<std::vector<glm::vec3>> bent;
};

/// Straight rays from a grid over each of the images. Bent ones, of which there are few, are looked for kBentSearch
/// times as densely along its rows.
RayGrid rayGrid(const BuiltCamera& camera, const std::vector<RayFunction>& rays, const Box& bounds, int columns,
                int rows);
inline constexpr int kBentSearch = 8;

struct SceneLines {
  std::vector<ColoredLine> lines;
  size_t straightRays = 0;  ///< that are drawn
  size_t bentRays = 0;
};

/// Widths are in pixels times `lineScale`.
SceneLines sceneLines(const ViewerState& state, const BuiltCamera& camera, const RayGrid& rays, const Box& bounds,
                      float lineScale);

}  // namespace ocelli
