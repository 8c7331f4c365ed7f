// Lines of text in pictures, by OpenCV's own strokes: what needs no font, and is fast enough for every frame.
#pragma once

#include <glm/vec2.hpp>
#include <string>

#include "oc_core/image/png_file.h"

namespace ocelli {

/// Printable ASCII, with "?" for each other letter, `height` pixels high, with a dark rim, from `left` (the lower left
/// corner) on.
void drawPictureText(Image<Rgb8>& image, const std::string& text, const glm::ivec2& left, int height,
                     const Rgb8& color);

/// How wide it is drawn, in pixels.
int pictureTextWidth(const std::string& text, int height);

}  // namespace ocelli
