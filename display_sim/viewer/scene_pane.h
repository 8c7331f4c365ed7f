// The scene from outside, with the reference camera, its rays, the view cell and the user's eye drawn into it.
#pragma once

#include "display_sim/viewer/pane_target.h"
#include "display_sim/viewer/scene_draw.h"
#include "display_sim/viewer/scene_lines.h"
#include "display_sim/viewer/viewer_data.h"

namespace ocelli {

class ScenePane {
 public:
  explicit ScenePane(GlContext& context) : target_(context), lines_(context) {}

  /// `lineScale`: pixels for a line of width 1. Returns whether it drew: not where nothing has
  /// changed since the last call. Hold a GlScope.
  bool draw(const ViewerState& state, const ViewerData& data, const std::optional<PickedPixel>& picked,
            const glm::ivec2& size, float lineScale, MeshDraw& meshes);

  const PaneTarget& target() const { return target_; }
  /// What was drawn last.
  const SceneLines& shownLines() const { return shown_; }

 private:
  PaneTarget target_;
  LineDraw lines_;
  RayGrid rays_;
  SceneLines shown_;
  /// What the rays are of, and what the image was drawn for.
  struct RayKey {
    uint64_t version = 0;
    int columns = 0;
    int rows = 0;
    bool operator==(const RayKey&) const = default;
  };
  struct Key {
    SceneShown shown;
    View eye;
    std::optional<PickedPixel> picked;
    uint64_t version = 0;
    glm::ivec2 size{0};
    float lineScale = 0;
    bool operator==(const Key&) const = default;
  };
  std::optional<RayKey> raysOf_;
  std::optional<Key> drawn_;
};

}  // namespace ocelli
