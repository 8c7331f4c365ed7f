// Blobs of bodies at known places, as a feed sees them.
#pragma once

#include <vector>

#include "oc_core/feeds/feed_blobs.h"
#include "oc_core/feeds/feed_setup.h"

namespace ocelli::test {

inline constexpr Rgb8 kRed{190, 60, 50};
inline constexpr Rgb8 kBlue{50, 70, 180};

struct MadeBody {
  glm::dvec3 place{0};
  Rgb8 color{128};
  double height = 1.75;  ///< metres
};

/// Bodies of two boxes, a head on a trunk that goes down to the floor; the nearer ones hide the others. Each connected
/// region is a blob. What somebody is shown by has the body's colour.
FeedBlobs blobsOf(const Feed& feed, const std::vector<MadeBody>& bodies);
/// Of all feeds.
std::vector<FeedBlobs> allBlobs(const FeedSetup& setup, const std::vector<MadeBody>& bodies);

}  // namespace ocelli::test
