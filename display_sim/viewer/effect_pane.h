// The picture of an effect, as it comes from the CPU.
#pragma once

#include "display_sim/viewer/effect_work.h"
#include "display_sim/viewer/shown_picture.h"

namespace ocelli {

class EffectPane {
 public:
  explicit EffectPane(GlContext& context) : shown_(context) {}

  /// Returns whether it drew: not where nothing has changed since the last call. Hold a GlScope.
  bool draw(const ViewerState& state, const EffectStatus& status, const glm::ivec2& size);

  const PaneTarget& target() const { return shown_.target(); }

 private:
  ShownPicture shown_;
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
