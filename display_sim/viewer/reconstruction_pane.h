// What stands for the scene, seen by the user's eye, with what is missing in false colours, and beside the truth.
#pragma once

#include "display_sim/viewer/frame_comparison_draw.h"
#include "display_sim/viewer/viewer_data.h"

namespace ocelli {

class ReconstructionPane {
 public:
  explicit ReconstructionPane(GlContext& context)
      : context_(&context), target_(context), comparison_(context), measurement_(context) {}

  /// Where nothing has changed since the last call it draws nothing, but measures what is missing if that is not known
  /// yet: so not while the eye moves. Returns whether it drew. Hold a GlScope.
  bool draw(const ViewerState& state, const ViewerData& data, const glm::ivec2& size, MeshDraw& meshes);

  const PaneTarget& target() const { return target_; }
  /// Of the user's eye, at the size of the reference image, whatever that of the pane: what `ocelli evaluate` counts.
  /// Nothing where it is not known: not yet, or the pane is hidden and something has changed since.
  std::optional<MissingSamples> missing(const ViewerState& state, const ViewerData& data) const;
  bool wantsToMeasure() const { return drawn_ && measurable_ && !missing_; }
  /// Where the images lie in the pane, pixels from its top left corner; the first holds the reconstruction.
  struct Place {
    glm::ivec2 corner{0};
    glm::ivec2 size{0};
  };
  const std::vector<Place>& places() const { return places_; }

 private:
  void show(const PaneTarget& image, const Place& place);

  GlContext* context_;
  PaneTarget target_;
  FrameComparisonDraw comparison_;
  FrameComparisonDraw measurement_;
  bool measurable_ = false;
  std::optional<MissingSamples> missing_;
  View missingView_;
  uint64_t missingVersion_ = 0;
  std::vector<Place> places_;
  /// What the image was drawn for.
  struct Key {
    View view;
    ReconstructionShown::Content content = ReconstructionShown::Content::kMarked;
    bool blinks = false;
    uint64_t version = 0;
    glm::ivec2 size{0};
    bool operator==(const Key&) const = default;
  };
  std::optional<Key> drawn_;
};

/// `count` images of this aspect ratio (width to height) beside each other in a pane, as large as possible.
std::vector<ReconstructionPane::Place> placesBeside(const glm::ivec2& pane, double aspect, int count);

}  // namespace ocelli
