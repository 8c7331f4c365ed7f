// Which subject each cell of a feed's mask shows, where bodies overlap in its image. The nearer ones are before the
// others: a cell that a body fills with likelihood s is left to those behind it with 1 - s. Colours tell apart what
// outlines do not, and neighbours are alike (after Mittal and Davis, M2Tracker, 2003).
#pragma once

#include <span>
#include <vector>

#include "oc_core/feeds/body_view.h"
#include "oc_core/feeds/feed_blobs.h"
#include "oc_core/feeds/subject_colors.h"

namespace ocelli {

/// A subject as a feed should see it.
struct ExpectedBody {
  size_t subject = 0;  ///< its index
  BodyView view;
  const SubjectColors* colors = nullptr;
};

/// What a feed sees of one expected body. Cells of its mask, row 0 at the top; but those that were seen, each is
/// weighted with how likely the body fills it.
struct BodySight {
  double inImage = 0;  ///< cells of the body in the image
  double open = 0;     ///< of these, what nobody nearer hides
  double feetInImage = 0;
  double feetOpen = 0;
  double headInImage = 0;
  double headOpen = 0;
  double besideExpected = 0;  ///< metres: the mean of what is open of trunk and head, beside the axis
  double seen = 0;            ///< cells that show it
  double seenAlone = 0;       ///< of these, those that can show no other body
  double besideSeen = 0;      ///< metres: the mean of those of trunk and head
  double trunkSeen = 0;       ///< their number
  int lowest = -1;            ///< rows between which it is seen; less than 0: none
  int highest = -1;
};

/// A cell that can only show one body: its colour is one of that body's.
struct SureCell {
  uint16_t body = 0;  ///< the index of the expected body
  uint8_t part = 0;   ///< of SubjectColors
  uint16_t bin = 0;
};

struct SubjectCells {
  static constexpr uint16_t kNobody = 0;

  Image<uint16_t> who;            ///< of each cell of the blobs' cores: the index of the subject, plus 1
  std::vector<BodySight> sights;  ///< of each expected body
  std::vector<SureCell> sure;
};

/// `bodies` are in the order of their distance, the nearest first.
SubjectCells tellCells(const FeedBlobs& blobs, std::span<const ExpectedBody> bodies);

}  // namespace ocelli
