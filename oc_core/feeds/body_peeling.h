// Bodies one by one from what a feed sees in front of its background, the nearest first. A blob may be several
// subjects, of which one hides others: the nearest has the lowest pixel, and what its body does not fill is somebody
// else.
//
// Who has feet in the image is placed by them; whose feet are hidden or out of the image, by the head, where the camera
// is above heads: heights differ by a tenth, so this is less exact.
#pragma once

#include <vector>

#include "oc_core/feeds/feed_blobs.h"
#include "oc_core/feeds/feed_setup.h"

namespace ocelli {

struct PeeledBody {
  glm::dvec3 place{0};    ///< on the floor
  double distance = 0;    ///< metres from the camera
  bool isByHead = false;  ///< or by its feet
};

/// The bodies that a feed sees, but those of whom `known` has the cells, 0 where nobody is known; it may be empty.
std::vector<PeeledBody> peelBodies(const FeedSetup& setup, size_t feed, const FeedBlobs& blobs,
                                   const Image<uint16_t>& known = {});

}  // namespace ocelli
