// The scene and what stands for it, drawn from the same viewpoint and compared sample by sample on the GPU: the missing
// samples of oc_core/ocri/coverage.h.
#pragma once

#include "display_sim/viewer/pane_target.h"
#include "display_sim/viewer/scene_draw.h"
#include "oc_core/ocri/coverage.h"

namespace ocelli {

class FrameComparisonDraw {
 public:
  explicit FrameComparisonDraw(GlContext& context);

  /// Hold a GlScope, here and below.
  MissingSamples draw(const GlMesh& truth, const GlMesh& frame, const Box& bounds, const PinholeCamera& camera,
                      const glm::vec3& background, MeshDraw& meshes);

  /// What was drawn last: the scene, what stands for it, and that with its missing samples in false colours.
  const PaneTarget& truth() const { return truth_; }
  const PaneTarget& frame() const { return frame_; }
  const PaneTarget& marked() const { return marked_; }

 private:
  void markMissing(const PinholeCamera& camera);
  MissingSamples shade(const glm::ivec2& size);

  GlContext* context_;
  PaneTarget truth_;
  PaneTarget frame_;
  PaneTarget marked_;
  GlObject missingProgram_;
  GlObject marksProgram_;
  GlObject vertexArray_;
  GlObject states_;
  GlObject statesFramebuffer_;
  glm::ivec2 statesSize_{0};
};

}  // namespace ocelli
