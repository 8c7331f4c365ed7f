// A reference image: its samples' colours, depths or displacements.
#pragma once

#include <string>

#include "display_sim/viewer/image_placement.h"
#include "display_sim/viewer/pane_target.h"
#include "display_sim/viewer/viewer_data.h"

namespace ocelli {

/// What the brightness of a pane stands for.
struct ReferenceScale {
  float nearest = 0;  ///< least and greatest depth of the samples
  float farthest = 0;
  float longestDisplacement = 0;  ///< pixels
};

ReferenceScale scaleOf(const ReferenceImage& image);

class ReferencePane {
 public:
  explicit ReferencePane(GlContext& context);

  /// Returns whether it drew: not where nothing has
  /// changed since the last call. Hold a GlScope.
  bool draw(const ViewerState& state, const ViewerData& data, const std::optional<glm::ivec2>& picked,
            const glm::ivec2& size);

  const PaneTarget& target() const { return target_; }
  const ReferenceScale& scale() const { return scale_; }

 private:
  void upload(const ReferenceImage& image);

  GlContext* context_;
  PaneTarget target_;
  GlObject program_;
  GlObject vertexArray_;
  GlObject colors_;
  GlObject depths_;
  GlObject displacements_;
  uint64_t uploadedVersion_ = 0;
  int uploadedImage_ = -1;
  ReferenceScale scale_;
  /// What the image was drawn for.
  struct Key {
    ReferenceShown shown;
    uint64_t version = 0;
    std::optional<glm::ivec2> picked;
    glm::ivec2 size{0};
    bool operator==(const Key&) const = default;
  };
  std::optional<Key> drawn_;
};

/// The image that the state asks for; null where there is none.
const ReferenceImage* shownImage(const ViewerState& state, const ViewerData& data);

}  // namespace ocelli
