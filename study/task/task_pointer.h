// The pointer of a trial: the mouse moves it, and so do Shift and the arrows.
#pragma once

#include <glm/vec2.hpp>

#include "study/task/held_keys.h"
#include "study/task/pixel_rect.h"
#include "study/task/task.h"

namespace ocelli {

class TaskPointer {
 public:
  /// Begins in the middle of `area`, which it cannot leave. `controls` must outlive it.
  TaskPointer(const PixelRect& area, const Controls& controls);

  void handle(const InputEvent& event);
  void advance();

  const glm::dvec2& place() const { return place_; }
  /// Whether the event is a click: the left button, or the key for it.
  bool isClick(const InputEvent& event) const;

 private:
  void moveTo(const glm::dvec2& place);

  PixelRect area_;
  const Controls& controls_;
  glm::dvec2 place_;
  HeldKeys held_;
};

}  // namespace ocelli
