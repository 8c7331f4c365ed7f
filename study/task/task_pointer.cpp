#include "study/task/task_pointer.h"

#include <algorithm>

namespace ocelli {

TaskPointer::TaskPointer(const PixelRect& area, const Controls& controls)
    : area_(area), controls_(controls), place_(area.center()) {}

void TaskPointer::moveTo(const glm::dvec2& place) {
  // Written so that NaN changes nothing. The area ends before its right and bottom borders.
  const auto within = [](double x, double least, double most, double otherwise) {
    return x >= least ? std::min(x, most) : x < least ? least : otherwise;
  };
  place_.x = within(place.x, area_.left, area_.right() - 1, place_.x);
  place_.y = within(place.y, area_.top, area_.bottom() - 1, place_.y);
}

void TaskPointer::handle(const InputEvent& event) {
  if (const auto* key = std::get_if<KeyEvent>(&event)) {
    held_.handle(*key);
  } else if (const auto* move = std::get_if<PointerMoveEvent>(&event)) {
    moveTo({move->x, move->y});
  }
}

void TaskPointer::advance() {
  const auto way = [&](Key positive, Key negative) {
    return (held_.shifted(positive) ? 1.0 : 0.0) - (held_.shifted(negative) ? 1.0 : 0.0);
  };
  const glm::dvec2 going(way(Key::kRight, Key::kLeft), way(Key::kDown, Key::kUp));
  if (going != glm::dvec2(0)) {
    moveTo(place_ + going * (controls_.pointerPixelsPerSecond / static_cast<double>(kTicksPerSecond)));
  }
}

bool TaskPointer::isClick(const InputEvent& event) const {
  if (const auto* key = std::get_if<KeyEvent>(&event)) {
    return key->pressed && key->key == controls_.select && !held_.any(key->key);
  }
  const auto* button = std::get_if<PointerButtonEvent>(&event);
  return button != nullptr && button->pressed && button->button == PointerButton::kLeft;
}

}  // namespace ocelli
