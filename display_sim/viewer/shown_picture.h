// A picture that comes from the CPU, in a pane.
#pragma once

#include "display_sim/viewer/pane_target.h"
#include "display_sim/viewer/reconstruction_pane.h"

namespace ocelli {

class ShownPicture {
 public:
  explicit ShownPicture(GlContext& context) : context_(&context), target_(context) {}

  /// Draws the pane: the picture at its place, scaled where it is of another size. Null: nothing. Hold a GlScope.
  void draw(const Image<Rgb8>* picture, const ReconstructionPane::Place& place, const glm::ivec2& paneSize);

  const PaneTarget& target() const { return target_; }

 private:
  void upload(const Image<Rgb8>& picture);

  GlContext* context_;
  PaneTarget target_;
  GlObject texture_;
  GlObject framebuffer_;
  glm::ivec2 textureSize_{0};
};

/// Where a picture of the user's eye lies in a pane: as the reconstruction does, so that all show the same.
ReconstructionPane::Place picturePlace(const ViewerState& state, const glm::ivec2& paneSize);

}  // namespace ocelli
