#include "oc_core/feeds/subject_body.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace ocelli {
namespace {

constexpr double kMaxTold = 60;       ///< metres: floor farther off says nothing of a place
constexpr double kHeadHeight = 0.28;  ///< metres from the top of a body on that only a head fills

}  // namespace

double FeedBox::area() const {
  return std::max(0.0, upper.x - lower.x) * std::max(0.0, upper.y - lower.y);
}

std::optional<FeedBox> bodyBox(const Feed& feed, const glm::dvec3& place) {
  const glm::dvec3 right = feed.pose.right();
  const glm::dvec3 side = glm::normalize(glm::dvec3(right.x, 0, right.z)) * kSubjectRadius;
  FeedBox box;
  for (const double height : {0.0, kSubjectHeight / 2, kSubjectHeight}) {
    for (const double sign : {-1.0, 1.0}) {
      if (const auto q = feedPixelOf(feed, place + side * sign + glm::dvec3(0, height, 0))) {
        box.lower = glm::min(box.lower, *q);
        box.upper = glm::max(box.upper, *q);
      }
    }
  }
  box.lower = glm::max(box.lower, glm::dvec2(0));
  box.upper = glm::min(box.upper, glm::dvec2(feed.width, feed.height));
  box.distance = glm::length(place - feed.pose.eye);
  if (const auto q = feedPixelOf(feed, place + glm::dvec3(0, kSubjectHeight - kHeadHeight, 0))) {
    box.shoulders = q->y;
  }
  return box.area() > 0 ? std::optional(box) : std::nullopt;
}

std::optional<PlaceTold> placeBelow(const FeedSetup& setup, size_t feedIndex, const glm::dvec2& pixel, double height) {
  const Feed& feed = setup.feeds[feedIndex];
  const auto ray = feedRayOf(feed, pixel);
  if (!ray || !(ray->y < 0)) {
    return std::nullopt;
  }
  const double along = (setup.floorHeight + height - feed.pose.eye.y) / ray->y;
  const glm::dvec3 seen = feed.pose.eye + *ray * along;
  const double distance = glm::length(seen - feed.pose.eye);
  if (!(along > 0) || distance > kMaxTold) {
    return std::nullopt;
  }
  return PlaceTold{feedIndex, {seen.x, setup.floorHeight, seen.z}, distance};
}

bool isOverHeads(const FeedSetup& setup, size_t feed) {
  return setup.feeds[feed].pose.eye.y > setup.floorHeight + kSubjectHeight + kMinOverHeads;
}

}  // namespace ocelli
