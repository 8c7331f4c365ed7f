#include "oc_core/feeds/place_telling.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "oc_core/feeds/subject_body.h"

namespace ocelli {
namespace {

constexpr double kMinSeenCells = 24;  ///< of a mask: fewer tell nothing
constexpr double kMinSupport = 0.35;  ///< share of a body's open cells that are seen, so that it is there
constexpr double kMinEndOpen = 0.7;   ///< of feet or of a head, so that it is theirs what is seen
// Deviations in metres of what one frame tells. Frames are alike, so they are larger than those of single ones.
constexpr double kBesideDeviation = 0.12;
constexpr double kHiddenDeviation = 0.4;  ///< more where all of it is hidden
constexpr double kEndDeviation = 0.35;    ///< of feet and heads
constexpr double kHeightDeviation = 0.07;
constexpr double kFootAhead = 0.12;  ///< metres from the foremost point of the feet to the middle of the body
constexpr double kWellKnown = 0.17;  ///< metres: the deviation of a place that tells heights
constexpr double kMinAway = 0.1;     ///< metres in the plan: who stands under a camera has no line of sight there
constexpr double kMinHeight = 1.2;
constexpr double kMaxHeight = 2.1;

class PlaceTeller {
 public:
  PlaceTeller(const FeedSetup& setup, size_t feed, const ExpectedBody& body, const BodySight& sight,
              SubjectMotion& motion)
      : setup_(setup),
        feedIndex_(feed),
        feed_(setup.feeds[feed]),
        scale_(maskScaleOf(feed_.width)),
        body_(body),
        sight_(sight),
        motion_(motion),
        line_(motion.place() - planOf(feed_.pose.eye)) {}

  bool hasLine() const { return glm::length(line_) >= kMinAway; }

  void tellMiddle() {
    if (sight_.trunkSeen < kMinSeenCells / 2) {
      return;
    }
    const glm::dvec2 across(-along().y, along().x);
    const double toTheRight = glm::dot(across, planOf(feed_.pose.right())) > 0 ? 1 : -1;
    const double hidden = 1 - std::min(1.0, sight_.open / std::max(sight_.inImage, 1.0));
    motion_.tell(across, glm::dot(across, motion_.place()) + toTheRight * (sight_.besideSeen - sight_.besideExpected),
                 kBesideDeviation + kHiddenDeviation * hidden);
  }

  void tellFeet() {
    if (sight_.lowest >= 0 && body_.view.hasFeet() && sight_.feetOpen >= kMinEndOpen * sight_.feetInImage) {
      tellEnd(sight_.lowest, 1, 0, kFootAhead, kEndDeviation);
    }
  }

  /// How high it seems to be.
  std::optional<double> tellHead(double height) {
    if (sight_.highest < 0 || !body_.view.hasHead() || !isOverHeads(setup_, feedIndex_) ||
        sight_.headOpen < kMinEndOpen * sight_.headInImage) {
      return std::nullopt;
    }
    const double over = feed_.pose.eye.y - setup_.floorHeight - height;
    tellEnd(sight_.highest, 0, height, 0, kEndDeviation + kHeightDeviation / std::max(over, 0.1) * glm::length(line_));
    const auto ray = feedRayOf(feed_, pixelAt(sight_.highest));
    if (!ray || motion_.deviationAlong(along()) > kWellKnown) {
      return std::nullopt;
    }
    const double flat = std::max(glm::length(planOf(*ray)), 1e-6);
    const double seen = feed_.pose.eye.y + ray->y * glm::length(line_) / flat - setup_.floorHeight;
    return seen > kMinHeight && seen < kMaxHeight ? std::optional(seen) : std::nullopt;
  }

 private:
  glm::dvec2 along() const { return glm::normalize(line_); }
  glm::dvec2 pixelAt(int row, int edge = 0) const { return glm::dvec2(body_.view.row(row).axis, row + edge) * scale_; }

  /// By the row of an end of the body, so high above the floor. A row more or less is another place.
  void tellEnd(int row, int edge, double height, double ahead, double deviation) {
    const auto told = placeBelow(setup_, feedIndex_, pixelAt(row, edge), height);
    const auto next = placeBelow(setup_, feedIndex_, pixelAt(row, edge) + glm::dvec2(0, scale_), height);
    if (told && next) {
      const double step = std::abs(glm::dot(along(), planOf(told->place - next->place)));
      motion_.tell(along(), glm::dot(along(), planOf(told->place)) + ahead, deviation + step);
    }
  }

  const FeedSetup& setup_;
  size_t feedIndex_;
  const Feed& feed_;
  double scale_;
  const ExpectedBody& body_;
  const BodySight& sight_;
  SubjectMotion& motion_;
  glm::dvec2 line_;  ///< of sight, in the plan, as long as the subject is far off
};

}  // namespace

bool isSeen(const BodySight& sight) {
  return sight.seen >= kMinSeenCells && sight.seen >= kMinSupport * sight.open;
}

std::optional<double> tellPlace(const FeedSetup& setup, size_t feed, const ExpectedBody& body, const BodySight& sight,
                                double height, SubjectMotion& motion) {
  PlaceTeller teller(setup, feed, body, sight, motion);
  if (!isSeen(sight) || !teller.hasLine()) {
    return std::nullopt;
  }
  teller.tellMiddle();
  teller.tellFeet();
  return teller.tellHead(height);
}

}  // namespace ocelli
