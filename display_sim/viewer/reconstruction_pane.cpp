#include "display_sim/viewer/reconstruction_pane.h"

#include <algorithm>
#include <cmath>

#include "display_sim/viewer/viewer_colors.h"
#include "oc_core/gl/gl_api.h"

namespace ocelli {

std::vector<ReconstructionPane::Place> placesBeside(const glm::ivec2& pane, double aspect, int count) {
  const int gap = count > 1 && pane.x > 16 ? 2 : 0;
  const int room = std::max((pane.x - gap * (count - 1)) / count, 1);
  const int width = std::clamp(static_cast<int>(std::lround(pane.y * aspect)), 1, room);
  const int height = std::clamp(static_cast<int>(std::lround(width / aspect)), 1, std::max(pane.y, 1));
  std::vector<ReconstructionPane::Place> places;
  places.reserve(static_cast<size_t>(count));
  const int left = (pane.x - count * width - (count - 1) * gap) / 2;
  for (int i = 0; i < count; ++i) {
    places.push_back({{left + i * (width + gap), (pane.y - height) / 2}, {width, height}});
  }
  return places;
}

std::optional<MissingSamples> ReconstructionPane::missing(const ViewerState& state, const ViewerData& data) const {
  const bool fits = missingVersion_ == data.version && missingView_ == state.reconstruction.view;
  return fits ? missing_ : std::nullopt;
}

void ReconstructionPane::show(const PaneTarget& image, const Place& place) {
  const GladGLContext& gl = context_->gl();
  gl.BlitNamedFramebuffer(image.framebuffer().id(), target_.framebuffer().id(), 0, 0, image.width(), image.height(),
                          place.corner.x, place.corner.y, place.corner.x + place.size.x, place.corner.y + place.size.y,
                          GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

bool ReconstructionPane::draw(const ViewerState& state, const ViewerData& data, const glm::ivec2& size,
                              MeshDraw& meshes) {
  using Content = ReconstructionShown::Content;
  const Content content = state.reconstruction.content;
  const View& view = state.reconstruction.view;
  const Key key{view, content, content == Content::kBlink && blinkShowsTruth(state), data.version, size};
  const auto compare = [&](FrameComparisonDraw& comparison, int width, int height) {
    return comparison.draw(*data.sceneMesh, *data.cameraMesh, data.scene->bounds, {view, width, height},
                           rgb(kSpaceColor), meshes);
  };
  if (key == drawn_) {
    if (wantsToMeasure()) {
      measurable_ = false;  // where it fails, it would fail again
      missing_ = compare(measurement_, data.camera->reference.width(), data.camera->reference.height());
      measurable_ = true;
    }
    return false;
  }
  drawn_ = key;
  places_.clear();
  measurable_ = data.camera != nullptr;
  if (missingVersion_ != data.version || !(missingView_ == view)) {
    missing_.reset();
    missingVersion_ = data.version;
    missingView_ = view;
  }
  if (!measurable_) {
    target_.begin(size.x, size.y, rgb(kPaneColor));
    return true;
  }
  const PinholeCamera& reference = data.camera->reference;
  const double aspect = static_cast<double>(reference.width()) / reference.height();
  places_ = placesBeside(size, aspect, content == Content::kSideBySide ? 2 : 1);
  compare(comparison_, places_[0].size.x, places_[0].size.y);
  target_.begin(size.x, size.y, rgb(kPaneColor));
  switch (content) {
    case Content::kMarked:
      show(comparison_.marked(), places_[0]);
      break;
    case Content::kPlain:
      show(comparison_.frame(), places_[0]);
      break;
    case Content::kTruth:
      show(comparison_.truth(), places_[0]);
      break;
    case Content::kSideBySide:
      show(comparison_.marked(), places_[0]);
      show(comparison_.truth(), places_[1]);
      break;
    case Content::kBlink:
      show(blinkShowsTruth(state) ? comparison_.truth() : comparison_.frame(), places_[0]);
      break;
  }
  return true;
}

}  // namespace ocelli
