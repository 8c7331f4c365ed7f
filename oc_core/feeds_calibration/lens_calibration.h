// The lens of a camera from views of a board (Zhang 2000), by OpenCV, in the model of feed_lens.h.
#pragma once

#include <string>
#include <vector>

#include "oc_core/feeds/feed_lens.h"
#include "oc_core/feeds_calibration/corner_views.h"

namespace ocelli {

inline constexpr size_t kMinLensViews = 5;
/// More views add time, and hardly accuracy; a video is thinned to those that differ most.
inline constexpr size_t kMaxLensViews = 60;

struct LensCalibration {
  FeedLens lens;
  int width = 0;
  int height = 0;
  double rmsPixels = 0;               ///< of the corners that were used
  double focalSpread = 0;             ///< standard deviation of the focal length, of which it is this share
  size_t views = 0;                   ///< used
  size_t viewsLeftOut = 0;            ///< their errors are far above those of the others
  double coveredShare = 0;            ///< of the cells of a grid of 8 by 6 over the image, those with a corner
  double maxTiltDegrees = 0;          ///< between any two views of the board
  std::vector<std::string> warnings;  ///< each says what to do
};

/// The views that differ from those before them by at least 3 % of the image's width, at most kMaxLensViews.
std::vector<BoardView> differentViews(const std::vector<BoardView>& views, int width);

/// Throws InputError, naming `where`, for fewer than kMinLensViews, for views all from one angle, and where what comes
/// out is no lens.
LensCalibration calibrateLens(const std::vector<BoardView>& views, int width, int height, const std::string& where);

}  // namespace ocelli
