#include "display_sim/viewer/lens_pane.h"

namespace ocelli {

bool LensPane::draw(const ViewerState& state, const LensStatus& status, const glm::ivec2& size) {
  const ReconstructionPane::Place place = picturePlace(state, size);
  const Key key{status.picture, size, place.size};
  if (key == drawn_) {
    return false;
  }
  drawn_ = key;
  shown_.draw(status.picture ? &status.picture->image : nullptr, place, size);
  return true;
}

}  // namespace ocelli
