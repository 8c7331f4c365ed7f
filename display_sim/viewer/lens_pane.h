// The picture of a camera with lenses, as it comes from the CPU; lens_overlays.h draws the lenses over it.
#pragma once

#include "display_sim/viewer/lens_work.h"
#include "display_sim/viewer/shown_picture.h"

namespace ocelli {

class LensPane {
 public:
  explicit LensPane(GlContext& context) : shown_(context) {}

  /// Returns whether it drew: not where nothing has changed since the last call. Hold a GlScope.
  bool draw(const ViewerState& state, const LensStatus& status, const glm::ivec2& size);

  const PaneTarget& target() const { return shown_.target(); }

 private:
  ShownPicture shown_;
  /// What the image was drawn for.
  struct Key {
    std::shared_ptr<const LensPicture> picture;
    glm::ivec2 size{0};
    glm::ivec2 placed{0};
    bool operator==(const Key&) const = default;
  };
  std::optional<Key> drawn_;
};

}  // namespace ocelli
