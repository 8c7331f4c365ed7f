#include "study/task/walker.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "oc_core/base/conventions.h"

namespace ocelli {
namespace {

constexpr double kFarthestPointer = 1e6;  // pixels; beyond it no mouse moves

}  // namespace

void Walker::turn(double degrees) {
  turnedDegrees_ += std::abs(degrees);
  pose_.headingRadians = std::remainder(pose_.headingRadians + radiansFromDegrees(degrees), 2 * kPi);
}

void Walker::handle(const InputEvent& event) {
  if (const auto* key = std::get_if<KeyEvent>(&event)) {
    held_.handle(*key);
  } else if (const auto* button = std::get_if<PointerButtonEvent>(&event)) {
    pans_ = button->button == PointerButton::kRight ? button->pressed : pans_;
  } else if (const auto* move = std::get_if<PointerMoveEvent>(&event)) {
    if (!(std::abs(move->x) <= kFarthestPointer)) {
      return;
    }
    if (pans_ && mouseX_) {
      turn((move->x - *mouseX_) * controls_.mouseDegreesPerPixel);
    }
    mouseX_ = move->x;
  }
}

void Walker::advance() {
  const auto way = [](bool positive, bool negative) { return (positive ? 1.0 : 0.0) - (negative ? 1.0 : 0.0); };
  const double turning = way(held_.any(controls_.turnRight) || held_.plain(Key::kRight),
                             held_.any(controls_.turnLeft) || held_.plain(Key::kLeft));
  const glm::dvec2 going(way(held_.any(controls_.right), held_.any(controls_.left)),
                         way(held_.any(controls_.forward) || held_.plain(Key::kUp),
                             held_.any(controls_.backward) || held_.plain(Key::kDown)));
  if (turning != 0) {
    turn(turning * controls_.turnDegreesPerSecond / static_cast<double>(kTicksPerSecond));
  }
  if (going == glm::dvec2(0)) {
    touches_ = false;
    return;
  }
  const double sine = std::sin(pose_.headingRadians);
  const double cosine = std::cos(pose_.headingRadians);
  const glm::dvec2 right(cosine, sine);
  const glm::dvec2 forward(sine, -cosine);
  const double stride = controls_.walkMetersPerSecond / static_cast<double>(kTicksPerSecond);
  const glm::dvec2 from(pose_.x, pose_.z);
  const FloorPlan::Step step = plan_.walk(from, glm::normalize(going.x * right + going.y * forward) * stride);
  collisions_ += step.touched && !touches_ ? 1 : 0;
  touches_ = step.touched;
  pathMeters_ += glm::length(step.place - from);
  pose_.x = step.place.x;
  pose_.z = step.place.y;
}

}  // namespace ocelli
