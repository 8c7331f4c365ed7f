// Where a reference image lies in its pane: zoomed and moved by hand.
#pragma once

#include <glm/vec2.hpp>
#include <optional>

#include "display_sim/viewer/viewer_state.h"

namespace ocelli {

struct ImagePlacement {
  glm::vec2 firstPixel{0};  ///< of the image, fractional, at the top left corner of the pane
  float pixelStep = 1;      ///< image pixels for each pixel of the pane

  glm::vec2 imageFromPane(const glm::vec2& at) const { return firstPixel + at * pixelStep; }
  glm::vec2 paneFromImage(const glm::vec2& at) const { return (at - firstPixel) / pixelStep; }
};

/// At a zoom of 1 the whole image fits; its part at `shown.center` lies in the middle of the pane.
ImagePlacement placeImage(const ReferenceShown& shown, const glm::ivec2& imageSize, const glm::ivec2& paneSize);

/// The pixel at a place of the pane; nothing beside the image.
std::optional<glm::ivec2> pixelAt(const ImagePlacement& placement, const glm::ivec2& imageSize, const glm::vec2& at);

/// Zooms so that what lies at a place of the pane stays there.
void zoomAt(ReferenceShown& shown, const glm::ivec2& imageSize, const glm::ivec2& paneSize, const glm::vec2& at,
            double factor);
/// Moves the image along with a pointer, pixels of the pane.
void dragImage(ReferenceShown& shown, const glm::ivec2& imageSize, const glm::ivec2& paneSize, const glm::vec2& by);

}  // namespace ocelli
