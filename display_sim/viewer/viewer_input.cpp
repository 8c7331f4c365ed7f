// What the viewer does with keys, the pointer and files that are dropped.
#include <imgui.h>

#include <cmath>

#include "display_sim/viewer/lens_keys.h"
#include "display_sim/viewer/transfer_choice.h"
#include "display_sim/viewer/transfer_keys.h"
#include "display_sim/viewer/viewer.h"
#include "oc_core/base/error.h"
#include "oc_core/base/json_fields.h"

namespace ocelli {
namespace {

constexpr double kTurnPerPaneHeight = kPi;  // a drag over the whole pane turns half around
constexpr double kZoomPerScroll = 1.15;

bool popupIsOpen() {
  return ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
}

}  // namespace

void Viewer::handle(const InputEvent& event) {
  if (const auto* key = std::get_if<KeyEvent>(&event)) {
    handleKey(*key);
    return;
  }
  gui_.handle(event);
  if (const auto* resize = std::get_if<ResizeEvent>(&event)) {
    window_ = *resize;
  } else if (const auto* button = std::get_if<PointerButtonEvent>(&event)) {
    handleButton(*button);
  } else if (const auto* move = std::get_if<PointerMoveEvent>(&event)) {
    handleMove({move->x, move->y});
  } else if (const auto* scroll = std::get_if<ScrollEvent>(&event)) {
    handleScroll(*scroll);
  } else if (const auto* drop = std::get_if<DropEvent>(&event)) {
    if (!drop->files.empty()) {
      attempt([&] { openDropped(drop->files.front()); });
    }
  } else if (std::holds_alternative<CloseEvent>(event)) {
    quit();
  }
}

void Viewer::handleKey(const KeyEvent& event) {
  const bool typing = gui_.wantsText() || popupIsOpen();
  if (typing || panelHasKeys_ || !event.pressed) {
    gui_.handle(event);
  }
  if (!event.pressed) {
    applyTransferKey(state_, event);
    return;
  }
  if (typing) {
    return;
  }
  if (event.key == Key::kEscape && (panelHasKeys_ || facts_.messageIsError)) {
    leavePanel();
    say("", false);
    return;
  }
  if (!panelHasKeys_) {
    for (const auto apply : {applyLensKey, applyTransferKey}) {
      const PaneKeyOutcome outcome = apply(state_, event);
      if (*outcome.note != '\0') {
        say(outcome.note, false);
      }
      if (outcome.used) {
        return;
      }
    }
  }
  const std::optional<ViewerAction> action = actionOf(event);
  if (action && (!panelHasKeys_ || *action == ViewerAction::kQuit)) {
    perform(*action);
  }
}

void Viewer::handleButton(const PointerButtonEvent& event) {
  const ViewerLayout where = layout();
  if (!event.pressed) {
    drag_.reset();
    transferPointer_.release(state_);
    if (const PaneLayout* lenses = where.find(Pane::kLenses); lenses == nullptr) {
      lensPointer_.cancel();
    } else if (const char* note = lensPointer_.release(state_, lensFrame(state_, lenses->image, lengthScale()));
               *note != '\0') {
      say(note, false);
    }
    return;
  }
  const PaneLayout* pane = gui_.wantsPointer() ? nullptr : where.paneAt(pointer_);
  if (pane == nullptr) {
    return;
  }
  leavePanel();
  state_.active = pane->pane;
  if (pane->pane == Pane::kLenses && event.button == PointerButton::kLeft && !event.modifiers.shift &&
      lensPointer_.press(state_, lensFrame(state_, pane->image, lengthScale()), pointer_)) {
    return;
  }
  if (pane->pane == Pane::kTransfer) {
    if (event.button == PointerButton::kLeft) {
      say(transferPointer_.press(state_, transferFrame(state_, pane->image, lengthScale()), pointer_), false);
    }
    return;
  }
  drag_ = Drag{pane->pane, event.button == PointerButton::kLeft && !event.modifiers.shift};
}

void Viewer::leavePanel() {
  leavesPanel_ = panelHasKeys_;
  panelHasKeys_ = false;
}

void Viewer::handleMove(const glm::vec2& to) {
  const glm::vec2 by = to - pointer_;
  pointer_ = to;
  const ViewerLayout where = layout();
  if (const PaneLayout* lenses = where.find(Pane::kLenses);
      lenses != nullptr && lensPointer_.move(state_, lensFrame(state_, lenses->image, lengthScale()), pointer_)) {
    return;
  }
  if (const PaneLayout* transfer = where.find(Pane::kTransfer); transfer != nullptr && transferPointer_.isHeld()) {
    transferPointer_.move(state_, transferFrame(state_, transfer->image, lengthScale()), pointer_);
    return;
  }
  const PaneLayout* pane = drag_ ? where.find(drag_->pane) : nullptr;
  if (pane == nullptr) {
    return;
  }
  const ReferenceImage* image = shownImage(state_, data_);
  if (drag_->pane == Pane::kReference) {
    if (image != nullptr) {
      dragImage(state_.reference, {image->width(), image->height()}, pixelsOf(pane->image),
                by * static_cast<float>(window_.pixelsPerUnit));
    }
    return;
  }
  // What is seen follows the pointer: the eye goes the other way.
  const glm::dvec2 share = glm::dvec2(by) / static_cast<double>(pane->image.height);
  if (drag_->turns) {
    orbitPane(state_, drag_->pane, -share.x * kTurnPerPaneHeight, share.y * kTurnPerPaneHeight);
  } else {
    panPane(state_, drag_->pane, -share.x, share.y);
  }
}

void Viewer::handleScroll(const ScrollEvent& event) {
  const ViewerLayout where = layout();
  const PaneLayout* pane = gui_.wantsPointer() ? nullptr : where.paneAt(pointer_);
  if (pane == nullptr) {
    return;
  }
  const double factor = std::pow(kZoomPerScroll, event.up);
  const ReferenceImage* image = shownImage(state_, data_);
  if (pane->pane == Pane::kReference && image != nullptr) {
    const glm::vec2 at =
        (pointer_ - glm::vec2(pane->image.x, pane->image.y)) * static_cast<float>(window_.pixelsPerUnit);
    zoomAt(state_.reference, {image->width(), image->height()}, pixelsOf(pane->image), at, factor);
    return;
  }
  if (pane->pane == Pane::kLenses &&
      LensPointer::scroll(state_, lensFrame(state_, pane->image, lengthScale()), pointer_, event.up)) {
    return;
  }
  if (pane->pane == Pane::kTransfer) {
    TransferPointer::scroll(state_, transferFrame(state_, pane->image, lengthScale()), pointer_, event.up);
    return;
  }
  zoomPane(state_, pane->pane, factor);
  if (pane->pane == Pane::kScene) {  // towards the pointer
    const WindowRect& area = pane->image;
    const glm::vec2 fromMiddle = pointer_ - glm::vec2(area.x + area.width / 2, area.y + area.height / 2);
    const glm::dvec2 share = glm::dvec2(fromMiddle) / static_cast<double>(area.height) * (factor - 1);
    panPane(state_, pane->pane, share.x, -share.y);
  }
}

void Viewer::openDropped(const std::string& file) {
  if (!file.ends_with(".json")) {
    open(file);
    return;
  }
  const nlohmann::json json = readJsonFile(file);
  if (json.contains("objects")) {
    state_.effect.on = true;
    state_.effect.rolesFile = file;
    ++state_.effect.rolesRead;
    say("roles of " + file, false);
  } else if (json.contains("points")) {
    ocelli::chooseTransfer(state_, loadedVolume_.get(), file);
    say("transfer function of " + file, false);
  } else if (json.contains("camera")) {
    chooseCamera(state_, file);
    say("camera of " + file, false);
  } else {
    chooseReference(state_, readView(file));
    say("reference view of " + file, false);
  }
}

}  // namespace ocelli
