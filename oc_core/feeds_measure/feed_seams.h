// Seams: how much a composed image jumps where two frusta meet, more than the graph camera's own rendering does there.
//
// A seam pair is two neighbouring pixels, beside or below each other, that different frusta show. Its jump is the
// largest difference of its three colours, in levels of 255; its excess is its jump in the composed image less that in
// the rendering, at least 0. A seam is visible where the excess is over kSeamLevels. Noise and the video's losses have
// an excess, too: the same measure of pairs kSeamInside pixels beside each seam pair, within one frustum, says how
// much.
#pragma once

#include <vector>

#include "oc_core/feeds/feed_map.h"
#include "oc_core/image/png_file.h"

namespace ocelli {

inline constexpr double kSeamLevels = 24;  ///< noise of 2 levels in both pixels hardly ever comes to 12
inline constexpr int kSeamInside = 6;      ///< pixels

struct FeedSeams {
  size_t pairs = 0;         ///< seam pairs
  size_t visible = 0;       ///< of these
  double levels = 0;        ///< mean excess of the seam pairs
  double insideLevels = 0;  ///< mean excess of pairs beside them

  double visibleShare() const { return pairs > 0 ? static_cast<double>(visible) / static_cast<double>(pairs) : 0; }
};

class SeamMeter {
 public:
  explicit SeamMeter(const FeedMap& map);

  /// Both images have the size of the map.
  FeedSeams measure(const Image<Rgb8>& composed, const Image<Rgb8>& rendered) const;

 private:
  struct Pair {
    size_t a;
    size_t b;
  };
  std::vector<Pair> seams_;
  std::vector<Pair> inside_;
};

/// The mean over frames of one composed image.
FeedSeams meanSeams(const std::vector<FeedSeams>& frames);

}  // namespace ocelli
