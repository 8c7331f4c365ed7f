// The picture of an effect, as it comes from the CPU.
#pragma once

#include "display_sim/viewer/effect_work.h"
#include "display_sim/viewer/pane_target.h"
#include "display_sim/viewer/reconstruction_pane.h"

namespace ocelli {

/// Where the picture lies in a pane: as the reconstruction does, so that both show the same.
ReconstructionPane::Place effectPlace(const ViewerState& state, const glm::ivec2& paneSize);

class EffectPane {
 public:
  explicit EffectPane(GlContext& context) : context_(&context), target_(context) {}

  /// Returns whether it drew: not where nothing has changed since the last call. Hold a GlScope.
  bool draw(const ViewerState& state, const EffectStatus& status, const glm::ivec2& size);

  const PaneTarget& target() const { return target_; }

 private:
  void upload(const Image<Rgb8>& image);

  GlContext* context_;
  PaneTarget target_;
  GlObject texture_;
  GlObject framebuffer_;
  /// What the image was drawn for.
  struct Key {
    std::shared_ptr<const EffectPicture> picture;
    EffectShown::Content content = EffectShown::Content::kByWay;
    glm::ivec2 size{0};
    glm::ivec2 placed{0};
    bool operator==(const Key&) const = default;
  };
  std::optional<Key> drawn_;
};

}  // namespace ocelli
