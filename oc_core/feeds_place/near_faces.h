// Near faces of feeds from the openings of the place that they watch: what the portal-based constructor does for scenes
// (sections 4.3.1.1 and 4.3.3), here with cameras that stand where they stand.
//
// A feed becomes the frustum beyond an opening that it looks through from the same side as its parent: the root, or a
// feed that is a frustum already. Openings are those of the walk map of the place; faces reach to the walls around.
//
// An opening that its parent sees from the side would be a sliver in its image. So faces are turned about their nearer
// jamb towards who looks at them, until they face the parent to kFaceTowards, and as far as the next wall, as long as
// they meet no other face, and as the feed fills them as well as before.
#pragma once

#include <string>
#include <vector>

#include "oc_core/feeds/feed_setup.h"
#include "oc_core/feeds_place/feed_place.h"

namespace ocelli {

/// Degrees between the normal of a face and the way to its parent's camera: from here on it is not turned any more.
inline constexpr double kFaceTowards = 45;

struct NearFaceOptions {
  double maxTurnDegrees = 45;  ///< 0 leaves openings as they are
};

struct FoundFace {
  std::string feed;
  std::string parent;
  size_t opening = 0;      ///< of WalkMap::portals
  double turnDegrees = 0;  ///< about its nearer jamb
  double coverage = 0;     ///< the share of its part of the image that the feed reaches
};

struct FeedWithoutFace {
  std::string feed;
  std::string why;  ///< a sentence, and what to do
};

struct NearFaces {
  std::vector<FoundFace> faces;
  std::vector<FeedWithoutFace> missing;
};

/// Sets the frusta of the setup: its root, which stays, and each feed that looks through an opening, parents first.
/// Throws InputError where the map of the place has no openings.
NearFaces findNearFaces(FeedSetup& setup, const FeedPlaceScene& place, const NearFaceOptions& options = {});

}  // namespace ocelli
