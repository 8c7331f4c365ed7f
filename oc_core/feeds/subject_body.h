// What a body of a usual size looks like to a feed.
#pragma once

#include <limits>
#include <optional>

#include "oc_core/feeds/feed_graph.h"

namespace ocelli {

constexpr double kSubjectHeight = 1.75;  ///< metres, as a body is thought where only a part is seen
constexpr double kSubjectRadius = 0.3;
constexpr double kMinOverHeads = 0.4;  ///< metres: a camera so much above a usual head tells places by heads

struct FeedBox {
  glm::dvec2 lower{std::numeric_limits<double>::infinity()};  ///< feed pixels
  glm::dvec2 upper{-std::numeric_limits<double>::infinity()};
  double shoulders = -std::numeric_limits<double>::infinity();  ///< the row above which there is only a head
  double distance = 0;                                          ///< metres from the camera

  double area() const;
};

/// The box of a body at a place, as a feed sees it, cut to its image; nothing where it does not.
std::optional<FeedBox> bodyBox(const Feed& feed, const glm::dvec3& place);

struct PlaceTold {
  size_t feed = 0;
  glm::dvec3 place{0};
  double distance = 0;    ///< metres from the camera
  bool isByHead = false;  ///< or by feet, which is more exact
};

/// The place on the floor of what is seen at a pixel, so many metres above the floor; nothing where that is too far
/// off.
std::optional<PlaceTold> placeBelow(const FeedSetup& setup, size_t feed, const glm::dvec2& pixel, double height);

/// A place or a way as seen from above: x and z.
inline glm::dvec2 planOf(const glm::dvec3& p) {
  return {p.x, p.z};
}

/// Whether the camera stands so far above heads that these tell places.
bool isOverHeads(const FeedSetup& setup, size_t feed);

}  // namespace ocelli
