// Keys and the pointer, in scripts that are played to a window.
#include <string_view>
#include <utility>

#include "oc_core/base/json_fields.h"
#include "oc_core/explore/explore_steps.h"

namespace ocelli {
namespace {

constexpr double kMaxWindowPoint = 32768;  // screen coordinates
constexpr double kMaxWheelSteps = 100;
constexpr size_t kMaxKeyText = 64;
constexpr int kDragMoves = 6;

/// "H", "Shift+T", "Ctrl+Q".
KeyEvent keyFromText(std::string_view text, JsonFields& fields) {
  KeyEvent event;
  const std::pair<std::string_view, bool Modifiers::*> names[] = {
      {"Shift+", &Modifiers::shift}, {"Ctrl+", &Modifiers::control}, {"Alt+", &Modifiers::alt}};
  for (const auto& [name, modifier] : names) {
    if (text.starts_with(name)) {
      event.modifiers.*modifier = true;
      text.remove_prefix(name.size());
    }
  }
  const std::optional<Key> key = keyFromName(text);
  if (!key) {
    fields.fail("key", "must be the name of a key, such as \"H\", \"Tab\", \"Escape\" or \"Shift+T\"");
  }
  event.key = *key;
  return event;
}

ExploreStep readKey(JsonFields& fields) {
  const KeyEvent pressed = keyFromText(fields.shortText("key", kMaxKeyText), fields);
  return [=](ExploreSession& session) {
    for (const bool isPressed : {true, false}) {
      session.give(KeyEvent{pressed.key, isPressed, pressed.modifiers});
      session.showFrame({});
    }
  };
}

void movePointer(ExploreSession& session, const glm::dvec2& to) {
  session.give(PointerMoveEvent{to.x, to.y});
  session.showFrame({});
}

void pressPointer(ExploreSession& session, PointerButton button, bool isPressed) {
  session.give(PointerButtonEvent{button, isPressed, {}});
  session.showFrame({});
}

glm::dvec2 windowPoint(JsonFields& fields, const char* name) {
  const std::vector<double> point = fields.numbers(name, 2, 0, kMaxWindowPoint);
  return {point[0], point[1]};
}

ExploreStep readClick(JsonFields& fields) {
  const glm::dvec2 at = windowPoint(fields, "click");
  return [=](ExploreSession& session) {
    movePointer(session, at);
    pressPointer(session, PointerButton::kLeft, true);
    pressPointer(session, PointerButton::kLeft, false);
  };
}

ExploreStep readDrag(JsonFields& fields) {
  JsonFields inner = fields.inner("drag");
  const glm::dvec2 from = windowPoint(inner, "from");
  const glm::dvec2 to = windowPoint(inner, "to");
  inner.rejectUnknown();
  return [=](ExploreSession& session) {
    movePointer(session, from);
    pressPointer(session, PointerButton::kLeft, true);
    for (int i = 1; i <= kDragMoves; ++i) {
      movePointer(session, from + (to - from) * (static_cast<double>(i) / kDragMoves));
    }
    pressPointer(session, PointerButton::kLeft, false);
  };
}

ExploreStep readScroll(JsonFields& fields) {
  JsonFields inner = fields.inner("scroll");
  const glm::dvec2 at = windowPoint(inner, "at");
  const double up = inner.number("up", -kMaxWheelSteps, kMaxWheelSteps);
  inner.rejectUnknown();
  return [=](ExploreSession& session) {
    movePointer(session, at);
    session.give(ScrollEvent{0, up});
    session.showFrame({});
  };
}

}  // namespace

std::vector<ExploreStepKind> exploreEventSteps() {
  return {
      {"key", "a key of the window that is pressed, such as H, Tab or Shift+T", readKey},
      {"click", "a point of the window that is clicked", readClick},
      {"drag", "a drag from a point of the window to another", readDrag},
      {"scroll", "a turn of the wheel over a point of the window, in steps", readScroll},
  };
}

}  // namespace ocelli
