#include "study/task/estimate_entry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "oc_core/base/conventions.h"
#include "study/trial/estimated_value.h"

namespace ocelli {
namespace {

constexpr double kScaleSteps = 200;     ///< of an arrow, from end to end
constexpr double kDialStep = 1;         ///< degrees
constexpr double kStepsPerSecond = 60;  ///< of an arrow that is held
constexpr int64_t kHoldTicks = kTicksPerSecond * 3 / 10;
/// A click nearer to the middle of a dial tells no direction, share of its radius.
constexpr double kDialMiddle = 0.1;

struct Arrow {
  Key key;
  double way;
};
constexpr std::array kArrows{Arrow{Key::kRight, 1}, Arrow{Key::kUp, 1}, Arrow{Key::kLeft, -1}, Arrow{Key::kDown, -1}};

double rounded(const TrialLayout::Scale& scale, double value) {
  constexpr double kParts = 100;
  return std::clamp(std::round(value * kParts) / kParts, std::max(scale.least, 1 / kParts), scale.most);
}

double roundedDegrees(double degrees) {
  constexpr double kParts = 10;
  return withinTurn(std::round(degrees * kParts) / kParts);
}

}  // namespace

std::optional<double> EstimateEntry::value() const {
  if (const auto* scale = std::get_if<TrialLayout::Scale>(&on_)) {
    return scale->mark ? std::optional(rounded(*scale, *scale->mark)) : std::nullopt;
  }
  const auto& dial = std::get<TrialLayout::Dial>(on_);
  return dial.degrees ? std::optional(roundedDegrees(*dial.degrees)) : std::nullopt;
}

void EstimateEntry::addTo(TrialLayout& layout) const {
  const std::optional<double> mark = value();
  if (const auto* scale = std::get_if<TrialLayout::Scale>(&on_)) {
    layout.scale = *scale;
    layout.scale->mark = mark;
  } else {
    layout.dial = std::get<TrialLayout::Dial>(on_);
    layout.dial->degrees = mark;
  }
  if (mark) {
    layout.choices.push_back({button_, "Confirm", Key::kEnter});
  }
}

void EstimateEntry::setAt(const glm::dvec2& point) {
  if (auto* scale = std::get_if<TrialLayout::Scale>(&on_)) {
    const double share = std::clamp((point.x - scale->place.left) / scale->place.width, 0.0, 1.0);
    scale->mark = scale->least + share * (scale->most - scale->least);
    return;
  }
  auto& dial = std::get<TrialLayout::Dial>(on_);
  const glm::dvec2 from = point - dial.place.center();
  if (glm::length(from) >= kDialMiddle * dial.place.width / 2) {
    dial.degrees = withinTurn(degreesFromRadians(std::atan2(from.x, -from.y)));
  }
}

void EstimateEntry::moveBy(double steps) {
  if (auto* scale = std::get_if<TrialLayout::Scale>(&on_)) {
    const double end = steps > 0 ? scale->least : scale->most;
    const double step = (scale->most - scale->least) / kScaleSteps;
    scale->mark = std::clamp(scale->mark.value_or(end) + steps * step, scale->least, scale->most);
    return;
  }
  auto& dial = std::get<TrialLayout::Dial>(on_);
  dial.degrees = dial.degrees ? withinTurn(*dial.degrees + steps * kDialStep) : 0;
}

bool EstimateEntry::handle(const InputEvent& event, const TaskPointer& pointer) {
  if (const auto* key = std::get_if<KeyEvent>(&event)) {
    const bool isRepeat = key->pressed && held_.any(key->key);
    if (key->pressed && !isRepeat && !key->modifiers.shift) {
      for (const Arrow& arrow : kArrows) {
        if (arrow.key == key->key) {
          moveBy(arrow.way);
          heldTicks_ = 0;
        }
      }
    }
    const bool confirms = key->key == Key::kEnter && key->pressed && !isRepeat && value().has_value();
    const bool clicks = pointer.isClick(event) && !isRepeat;
    if (!isRepeat) {
      held_.handle(*key);
    }
    if (confirms || !clicks) {
      return confirms;
    }
  }
  if (pointer.isClick(event)) {
    if (value() && button_.contains(pointer.place())) {
      return true;
    }
    const PixelRect& place = std::visit([](const auto& on) -> const PixelRect& { return on.place; }, on_);
    if (place.contains(pointer.place())) {
      setAt(pointer.place());
      dragging_ = std::holds_alternative<PointerButtonEvent>(event);
    }
    return false;
  }
  if (const auto* button = std::get_if<PointerButtonEvent>(&event)) {
    dragging_ = dragging_ && button->button != PointerButton::kLeft;
  } else if (dragging_ && std::holds_alternative<PointerMoveEvent>(event)) {
    setAt(pointer.place());
  }
  return false;
}

void EstimateEntry::advance() {
  double way = 0;
  for (const Arrow& arrow : kArrows) {
    way += held_.plain(arrow.key) ? arrow.way : 0;
  }
  if (way == 0) {
    return;
  }
  if (++heldTicks_ > kHoldTicks) {
    moveBy(way * kStepsPerSecond / static_cast<double>(kTicksPerSecond));
  }
}

}  // namespace ocelli
