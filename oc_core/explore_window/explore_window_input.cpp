// What the window of `ocelli explore` does with keys, the pointer and a gamepad.
#include <algorithm>

#include "oc_core/explore_window/explore_window.h"

namespace ocelli {
namespace {

/// Who walks has understood the hint.
constexpr double kHintUnderstood = 9;

}  // namespace

void ExploreWindow::handle(const InputEvent& event) {
  needsDrawing_ = true;
  needsAnother_ = true;
  if (const auto* key = std::get_if<KeyEvent>(&event)) {
    handleKey(*key);
    return;
  }
  if (std::holds_alternative<CloseEvent>(event)) {
    wishes_.close = true;
    return;
  }
  if (const auto* resize = std::get_if<ResizeEvent>(&event)) {
    window_ = *resize;
  }
  // A captured mouse points at nothing.
  if (!state_.captured || std::holds_alternative<ResizeEvent>(event)) {
    gui_.handle(event);
  }
  const bool isUsed = handlePointer(event);
  if (const auto* drop = std::get_if<DropEvent>(&event); drop != nullptr && !isUsed && !drop->files.empty()) {
    work_.tell([file = drop->files.front()](ExploreWindowModel& model) {
      model.openCamera(file);
      return "the camera of " + file;
    });
  }
}

void ExploreWindow::handleKey(const KeyEvent& event) {
  if (gui_.wantsText()) {
    gui_.handle(event);
    return;
  }
  shift_ = event.modifiers.shift;
  const ExploreWindowLayout places = layout();
  const auto active = std::ranges::find_if(places.panes, [&](const ExploreWindowLayout::Pane& pane) {
    return state_.active == explorePanes()[pane.kind].name;
  });
  if (active != places.panes.end() && panes_[active->kind]->handleKey(frameOf(*active), event)) {
    return;
  }
  const bool isPlain = !event.modifiers.control && !event.modifiers.alt;
  held_[static_cast<size_t>(event.key)] = event.pressed && isPlain;
  const bool walks =
      std::ranges::any_of(exploreHeldKeys(), [&](const ExploreHeldKey& row) { return row.key == event.key; });
  if (walks && event.pressed) {
    state_.hintSeconds = std::max(state_.hintSeconds, kHintUnderstood);
  }
  if (const ExploreKeyAction* action = exploreActionOf(event)) {
    press(*action);
  }
}

void ExploreWindow::press(const ExploreKeyAction& action) {
  ExploreKeyTarget target = keyTarget();
  action.act(target, action.argument);
  needsDrawing_ = true;
  needsAnother_ = true;
}

bool ExploreWindow::handlePointer(const InputEvent& event) {
  if (const auto* move = std::get_if<PointerMoveEvent>(&event)) {
    pointer_ = {static_cast<float>(move->x), static_cast<float>(move->y)};
  }
  const auto* button = std::get_if<PointerButtonEvent>(&event);
  const ExploreWindowLayout places = layout();
  const auto paneOf = [&](size_t kind) {
    const auto found = std::ranges::find(places.panes, kind, &ExploreWindowLayout::Pane::kind);
    return found == places.panes.end() ? nullptr : &*found;
  };
  const ExploreWindowLayout::Pane* pane = nullptr;
  if (state_.captured) {
    pane = &places.panes.front();
  } else if (isPressed_) {
    pane = paneOf(pressedPane_);
  } else if (!gui_.wantsPointer() && !state_.help) {
    pane = places.paneAt(pointer_);
  }
  if (button != nullptr) {
    isPressed_ = button->pressed && pane != nullptr;
    if (isPressed_) {
      pressedPane_ = pane->kind;
      state_.active = explorePanes()[pane->kind].name;
    }
  }
  return pane != nullptr && panes_[pane->kind]->handlePointer(frameOf(*pane), event, pointer_);
}

void ExploreWindow::handleGamepad(const std::optional<GamepadState>& state) {
  const ExploreGamepad::Reading reading = gamepad_.read(state);
  padMotion_ = reading.motion;
  for (const ExploreKeyAction* action : reading.pressed) {
    press(*action);
  }
  if (reading.isUsed) {
    state_.hintSeconds = std::max(state_.hintSeconds, kHintUnderstood);
  }
}

void ExploreWindow::loseFocus() {
  held_ = {};
  shift_ = false;
  padMotion_ = {};
  state_.captured = false;
  isPressed_ = false;
  for (const std::unique_ptr<ExplorePane>& pane : panes_) {
    pane->loseFocus();
  }
  needsDrawing_ = true;
}

}  // namespace ocelli
