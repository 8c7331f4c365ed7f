#include "display_sim/viewer/lens_pointer.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "display_sim/viewer/lens_choice.h"

namespace ocelli {
namespace {

/// Lenses are edited in pixels of the window, so that what is nearest there is so to the eye.
std::optional<LensHit> hitAt(const ViewerState& state, const LensPointer::Frame& frame, const glm::dvec2& at) {
  return lensHitAt(state.work.camera.gpc, frame.shareAt(at), kLensReach * frame.lengthScale, frame.size);
}

}  // namespace

bool LensPointer::press(ViewerState& state, const Frame& frame, const glm::dvec2& at) {
  drag_.reset();
  click_.reset();
  holdsLocked_ = false;
  const std::optional<LensHit> hit = hitAt(state, frame, at);
  if (!hit) {
    click_ = at;
    return false;
  }
  state.lenses.chosen = hit->lens;
  holdsLocked_ = isLocked(state, hit->lens);
  if (!holdsLocked_) {
    drag_.emplace(state.work.camera.gpc, *hit, frame.shareAt(at), frame.size);
    dragged_ = state.work.camera.gpc;
  }
  return true;
}

bool LensPointer::move(ViewerState& state, const Frame& frame, const glm::dvec2& at) {
  if (drag_ && !(dragged_ == state.work.camera.gpc)) {
    drag_.reset();
  }
  if (drag_) {
    dragged_ = drag_->layoutAt(frame.shareAt(at));
    if (!(dragged_ == state.work.camera.gpc)) {
      state.work.camera.gpc = dragged_;
      lensesChanged(state);
    }
    return true;
  }
  if (click_ && glm::length(at - *click_) > kClickReach * frame.lengthScale) {
    click_.reset();
  }
  return holdsLocked_ || click_;
}

const char* LensPointer::release(ViewerState& state, const Frame& frame) {
  const std::optional<glm::dvec2> click = click_;
  click_.reset();
  drag_.reset();
  holdsLocked_ = false;
  if (!click) {
    return "";
  }
  const glm::dvec2 at = frame.shareAt(*click);
  const bool isInPicture = at.x >= 0 && at.y >= 0 && at.x <= 1 && at.y <= 1;
  return !isInPicture || addLensAt(state, at) ? "" : "there is no room for a lens here";
}

bool LensPointer::scroll(ViewerState& state, const Frame& frame, const glm::dvec2& at, double up) {
  constexpr double kZoomPerStep = 1.15;
  const std::optional<LensHit> hit = hitAt(state, frame, at);
  if (!hit) {
    return false;
  }
  state.lenses.chosen = hit->lens;
  if (!isLocked(state, hit->lens)) {
    GpcLayout& layout = state.work.camera.gpc;
    zoomLens(layout, hit->lens, static_cast<double>(layout.regions[hit->lens].zoom) * std::pow(kZoomPerStep, up));
    lensesChanged(state);
  }
  return true;
}

}  // namespace ocelli
