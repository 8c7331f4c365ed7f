#include "display_sim/viewer/effect_pane.h"

namespace ocelli {

bool EffectPane::draw(const ViewerState& state, const EffectStatus& status, const glm::ivec2& size) {
  const ReconstructionPane::Place place = picturePlace(state, size);
  const Key key{status.picture, state.effect.content, size, place.size};
  if (key == drawn_) {
    return false;
  }
  drawn_ = key;
  shown_.draw(status.picture ? status.picture->shown(state.effect.content) : nullptr, place, size);
  return true;
}

}  // namespace ocelli
