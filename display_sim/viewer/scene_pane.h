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

  /// `lineScale`: pixels for a line of width 1. Hold a GlScope.
  void draw(const ViewerState& state, const ViewerData& data, const std::optional<PickedPixel>& picked,
            const glm::ivec2& size, float lineScale, MeshDraw& meshes);

  const PaneTarget& target() const { return target_; }
  /// What was drawn last.
  const SceneLines& shownLines() const { return shown_; }

 private:
  PaneTarget target_;
  LineDraw lines_;
  SceneLines shown_;
};

}  // namespace ocelli
