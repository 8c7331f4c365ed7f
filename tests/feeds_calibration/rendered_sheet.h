// Sheets on planes as a camera with a lens sees them, drawn slowly and plainly: a ray through each of 3 by 3 places of
// a pixel, to the first sheet that it meets; then blur, noise and 256 levels.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "oc_core/base/random_numbers.h"
#include "oc_core/feeds/feed_setup.h"
#include "oc_core/feeds_calibration/calibration_board.h"
#include "oc_core/image/png_file.h"

namespace ocelli::test {

/// A sheet of cells, black or white, with a white margin around them.
struct RenderedSheet {
  glm::dvec3 corner{0};  ///< top left, metres in the world
  glm::dvec3 right{1, 0, 0};
  glm::dvec3 down{0, -1, 0};
  double cellMetres = 0;
  int across = 0;
  int below = 0;
  std::vector<bool> black;
  double marginMetres = 0;
};

/// All lengths of `squares` must be multiples of `cellMillimetres`.
RenderedSheet sheetOf(const std::vector<BlackSquare>& squares, double cellMillimetres);

struct PictureNoise {
  double blurPixels = 0.6;  ///< standard deviation
  double noiseLevels = 2;   ///< of 255
};

class SheetCamera {
 public:
  SheetCamera(const FeedLens& lens, int width, int height);
  Image<Rgb8> picture(const FeedPose& pose, const std::vector<RenderedSheet>& sheets, const PictureNoise& noise,
                      RandomNumbers& random) const;

 private:
  FeedLens lens_;
  int width_;
  int height_;
  std::vector<glm::dvec2> directions_;  ///< of the places of all pixels
};

}  // namespace ocelli::test
