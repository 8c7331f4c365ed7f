#include "display_sim/viewer/image_placement.h"

#include <algorithm>
#include <glm/common.hpp>

namespace ocelli {
namespace {

void centerOn(ReferenceShown& shown, const glm::vec2& imagePoint, const glm::ivec2& imageSize) {
  shown.center = glm::clamp(imagePoint / glm::vec2(imageSize), glm::vec2(0), glm::vec2(1));
}

}  // namespace

ImagePlacement placeImage(const ReferenceShown& shown, const glm::ivec2& imageSize, const glm::ivec2& paneSize) {
  const glm::vec2 image(imageSize);
  const glm::vec2 pane(paneSize);
  const glm::vec2 steps = image / pane;
  const float step = std::max(steps.x, steps.y) / static_cast<float>(shown.zoom);
  return {shown.center * image - pane / 2.0f * step, step};
}

std::optional<glm::ivec2> pixelAt(const ImagePlacement& placement, const glm::ivec2& imageSize, const glm::vec2& at) {
  const glm::ivec2 pixel(glm::floor(placement.imageFromPane(at)));
  if (pixel.x < 0 || pixel.y < 0 || pixel.x >= imageSize.x || pixel.y >= imageSize.y) {
    return std::nullopt;
  }
  return pixel;
}

void zoomAt(ReferenceShown& shown, const glm::ivec2& imageSize, const glm::ivec2& paneSize, const glm::vec2& at,
            double factor) {
  const glm::vec2 kept = placeImage(shown, imageSize, paneSize).imageFromPane(at);
  shown.zoom = std::clamp(shown.zoom * factor, 1.0, kMaxReferenceZoom);
  const float step = placeImage(shown, imageSize, paneSize).pixelStep;
  centerOn(shown, kept + (glm::vec2(paneSize) / 2.0f - at) * step, imageSize);
}

void dragImage(ReferenceShown& shown, const glm::ivec2& imageSize, const glm::ivec2& paneSize, const glm::vec2& by) {
  const float step = placeImage(shown, imageSize, paneSize).pixelStep;
  centerOn(shown, shown.center * glm::vec2(imageSize) - by * step, imageSize);
}

}  // namespace ocelli
