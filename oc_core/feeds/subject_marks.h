// What becomes of the subjects in the picture of a frustum (section 4.3.3, Figure 4.26). Where it shows this frustum,
// those before its near face are erased, as its rays begin there. Where it shows a later one, behind the near face of
// that, those that stand between both are shown before it.
#pragma once

#include <span>

#include "oc_core/feeds/feed_map.h"
#include "oc_core/feeds/subject_places.h"

namespace ocelli {

/// Of a cell of a mask, 255 is all: how much background stands for it, and how much of it is shown where the picture
/// shows a later frustum.
struct FeedMark {
  uint8_t erased = 0;
  uint8_t shown = 0;

  bool operator==(const FeedMark&) const = default;
};

/// The marks of all cells of a mask. Empty where nothing is marked.
class FeedMarks {
 public:
  FeedMarks() = default;
  /// `scale` is the side of a cell in feed pixels.
  FeedMarks(int width, int height, int scale)
      : cells_(width, height), inverse_((1u << kInverseBits) / static_cast<uint32_t>(scale) + 1) {}

  Image<FeedMark>& cells() { return cells_; }
  const Image<FeedMark>& cells() const { return cells_; }
  /// Of the cell of a place that is in the feed.
  FeedMark at(const FeedPlace& place) const {
    constexpr int32_t kHalf = 1 << (FeedPlace::kFractionBits - 1);
    // Times the inverse is exact for pixels below 2^13, and much faster than a division.
    const auto x = static_cast<int>((static_cast<uint32_t>((place.x + kHalf) >> FeedPlace::kFractionBits) * inverse_) >>
                                    kInverseBits);
    const auto y = static_cast<int>((static_cast<uint32_t>((place.y + kHalf) >> FeedPlace::kFractionBits) * inverse_) >>
                                    kInverseBits);
    return cells_.contains(x, y) ? cells_(x, y) : FeedMark{};
  }

 private:
  static constexpr int kInverseBits = 18;

  Image<FeedMark> cells_;
  uint32_t inverse_ = 1;
};

/// The marks of the feed of a frustum. `who` says which subject each cell shows, index plus 1, and `places` where these
/// stand. What shows nobody who is known stands where its feet are.
FeedMarks markSubjects(const FeedGraph& graph, size_t frustum, const FeedBlobs& blobs, const Image<uint16_t>& who,
                       std::span<const glm::dvec3> places);
/// The same of a picture that is too old to be shown as live: everybody in it is erased.
FeedMarks eraseSubjects(const FeedBlobs& blobs);

}  // namespace ocelli
