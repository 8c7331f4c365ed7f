// Events of a window in the pixels of its screen.
#pragma once

#include "oc_core/base/input_event.h"

namespace ocelli {

/// Positions in pixels; `pixelsPerUnit` as in ResizeEvent.
inline InputEvent inPixels(const InputEvent& event, double pixelsPerUnit) {
  if (const auto* move = std::get_if<PointerMoveEvent>(&event)) {
    return PointerMoveEvent{move->x * pixelsPerUnit, move->y * pixelsPerUnit};
  }
  return event;
}

}  // namespace ocelli
