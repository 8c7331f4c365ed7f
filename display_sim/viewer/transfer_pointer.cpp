#include "display_sim/viewer/transfer_pointer.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace ocelli {
namespace {

/// The nearest point within reach; of those at the same place the last, which is drawn over the others.
std::optional<size_t> pointAt(const TransferEditor& editor, const TransferFrame& frame, const glm::dvec2& at) {
  std::optional<size_t> nearest;
  double least = kPointReach * frame.lengthScale;
  for (size_t i = 0; i < editor.points().size(); ++i) {
    const TransferPoint& point = editor.points()[i];
    const double distance = glm::distance(frame.placeOf(point.value, point.opacity), at);
    if (distance <= least) {
      nearest = i;
      least = distance;
    }
  }
  return nearest;
}

}  // namespace

TransferFrame transferFrame(const ViewerState& state, const WindowRect& image, float lengthScale) {
  constexpr double kLeft = 54;   // for opacities
  constexpr double kBelow = 40;  // for colours and values
  constexpr double kAbove = 14;
  constexpr double kRight = 28;  // for half of a value
  const auto scale = static_cast<double>(lengthScale);
  TransferFrame frame;
  frame.corner = glm::dvec2(image.x, image.y) + scale * glm::dvec2(kLeft, kAbove);
  const glm::dvec2 room(image.width, image.height);
  frame.size = glm::max(room - scale * glm::dvec2(kLeft + kRight, kBelow + kAbove), glm::dvec2(1));
  frame.axis = state.volume.axis;
  frame.lengthScale = scale;
  return frame;
}

const char* TransferPointer::press(ViewerState& state, const TransferFrame& frame, const glm::dvec2& at) {
  held_.reset();
  if (!state.volume.transfer) {
    return "";
  }
  TransferEditor& editor = *state.volume.transfer;
  const bool isSecond = click_ && state.seconds - click_->seconds <= kDoubleClickSeconds &&
                        glm::distance(at, click_->at) <= kDoubleClickReach * frame.lengthScale;
  click_ = isSecond ? std::nullopt : std::optional(Click{at, state.seconds});
  std::optional<size_t> point = pointAt(editor, frame, at);
  editor.choose(point);
  if (!point && isSecond) {
    if (!editor.addPoint(frame.valueAt(at), frame.opacityAt(at))) {
      return kTooManyPoints;
    }
    point = editor.chosen();
  }
  held_ = Held{point, point ? frame.placeOf(editor.points()[*point].value, editor.points()[*point].opacity) - at : at};
  return "";
}

void TransferPointer::move(ViewerState& state, const TransferFrame& frame, const glm::dvec2& at) {
  if (!held_ || !state.volume.transfer) {
    return;
  }
  if (!held_->point) {
    state.volume.axis = pannedAxis(state.volume.axis, state.volume.values, (held_->from.x - at.x) / frame.size.x);
    held_->from = at;
    return;
  }
  TransferEditor& editor = *state.volume.transfer;
  if (editor.chosen() != held_->point) {  // something else has happened to it meanwhile
    held_.reset();
    return;
  }
  const glm::dvec2 place = at + held_->from;
  const TransferPoint& point = editor.points()[*held_->point];
  if (glm::distance(place, frame.placeOf(point.value, point.opacity)) > 0.25 * frame.lengthScale) {
    editor.movePoint(*held_->point, frame.valueAt(place), frame.opacityAt(place));
  }
}

void TransferPointer::release(ViewerState& state) {
  held_.reset();
  if (state.volume.transfer) {
    state.volume.transfer->endStep();
  }
}

void TransferPointer::scroll(ViewerState& state, const TransferFrame& frame, const glm::dvec2& at, double up) {
  constexpr double kZoomPerStep = 1.25;
  state.volume.axis = zoomedAxis(state.volume.axis, state.volume.values, frame.valueAt(at), std::pow(kZoomPerStep, up));
}

const std::vector<PointerBinding>& transferPointerBindings() {
  static const std::vector<PointerBinding> bindings{
      {"Double click", "add a point"},
      {"Drag a point", "move it; beside: move the values"},
      {"Wheel", "less, more of the values"},
  };
  return bindings;
}

}  // namespace ocelli
