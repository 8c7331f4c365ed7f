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

/// The ray of a pixel: from the eye to the sample that it holds, and how it would go on to the far end of the scene.
struct SampledRay {
  std::vector<glm::vec3> toSample;  ///< empty where the pixel holds no sample, or has no ray of its own
  std::vector<glm::vec3> beyond;
};

/// `at` is a pixel of one of the images; nothing where there is no such image.
SampledRay sampledRay(const BuiltCamera& camera, const std::vector<RayFunction>& rays, const Box& bounds,
                      const PickedPixel& at);

/// Rays that hold samples.
struct RayGrid {
  std::vector<SampledRay> straight;
  std::vector<SampledRay> bent;  ///< before their sample, or behind it
};

/// From a grid over each of the images. Where it meets few bent ones, they are looked for kBentSearch times as densely
/// along its rows.
RayGrid rayGrid(const BuiltCamera& camera, const std::vector<RayFunction>& rays, const Box& bounds, int columns,
                int rows);
inline constexpr int kBentSearch = 8;
inline constexpr size_t kFewBent = 48;

struct SceneLines {
  std::vector<ColoredLine> lines;
  size_t straightRays = 0;  ///< that are drawn
  size_t bentRays = 0;
};

/// Widths are in pixels times `lineScale`.
SceneLines sceneLines(const ViewerState& state, const BuiltCamera& camera, const RayGrid& rays, const Box& bounds,
                      float lineScale);

}  // namespace ocelli
