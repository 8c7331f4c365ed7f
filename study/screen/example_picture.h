// The picture of a page that shows a trial: what the screen of the trial shows at its first moment, pixel by pixel, and
// where it shows each object. So a page shows what the block's own cameras show, and shows it alike in all conditions.
#pragma once

#include <vector>

#include "study/protocol/protocol.h"
#include "study/screen/scene_views.h"

namespace ocelli {

struct ExamplePicture {
  /// An object in a view: two where two views show it, or where one shows it twice.
  struct Mark {
    glm::dvec2 center{0};  ///< of its pixels
    double radius = 0;     ///< of the square around them, pixels
  };
  Image<Rgb8> pixels;  ///< all of the screen that the views fill together
  std::vector<Mark> marks;
};

/// Of a trial on a screen of that size. Hold a GlScope. Throws GlError.
ExamplePicture examplePicture(GlContext& context, const PageExample& example, const TrialScreen& screen);

/// With fewer pixels: each the mean of those in its place, in linear light. `width` and `height` are at most its own.
Image<Rgb8> shrunk(const Image<Rgb8>& image, int width, int height);

}  // namespace ocelli
