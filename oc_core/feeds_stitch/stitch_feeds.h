// What OpenCV's panorama stitcher makes of the same frames (Brown and Lowe 2007, "Automatic panoramic image stitching
// using invariant features"): it finds features, takes the cameras for ones that turn about one point, and blends.
#pragma once

#include <cstdint>
#include <vector>

#include "oc_core/image/png_file.h"

namespace ocelli {

struct StitchedFeeds {
  std::vector<size_t> feeds;  ///< those that it joined, by index; empty where it made no picture
  Image<Rgb8> image;
  Image<uint8_t> labels;  ///< what `labels` of the feeds become, cut as the image is
  Image<uint8_t> owner;   ///< of each pixel: 1 + the index of the feed that it is from; 0 where nothing is
  double seconds = 0;     ///< that the image took
};

/// `frames` have one entry a feed, `labels` images of the same sizes with a number for each pixel. Seams are those that
/// lie half way between the feeds' middles, so that labels can be cut as the image is. No picture is made where the
/// estimated focal length is over kMaxStitchFocal widths of a feed, which no lens has: its panorama would not fit into
/// memory.
StitchedFeeds stitchFeeds(const std::vector<Image<Rgb8>>& frames, const std::vector<Image<uint8_t>>& labels);

inline constexpr double kMaxStitchFocal = 10;

}  // namespace ocelli
