#include "oc_core/feeds/feed_compose.h"

#include "oc_core/base/parallel.h"

namespace ocelli {
namespace {

constexpr int kOne = 1 << FeedPlace::kFractionBits;
constexpr int kRedShare = 128;  ///< of 256

using Sum = glm::ivec3;

/// In 1/65536, so that no rounding adds up.
Sum sampleOf(const Image<Rgb8>& image, const FeedPlace& place) {
  const int x = place.x >> FeedPlace::kFractionBits;
  const int y = place.y >> FeedPlace::kFractionBits;
  const int fx = place.x & (kOne - 1);
  const int fy = place.y & (kOne - 1);
  const int right = x + 1 < image.width() ? 1 : 0;
  const size_t down = y + 1 < image.height() ? static_cast<size_t>(image.width()) : 0;
  const Rgb8* p = image.data() + image.index(x, y);
  const Sum above = Sum(p[0]) * (kOne - fx) + Sum(p[right]) * fx;
  const Sum below = Sum(p[down]) * (kOne - fx) + Sum(p[down + static_cast<size_t>(right)]) * fx;
  return above * (kOne - fy) + below * fy;
}

Sum mixed(const Sum& a, const Sum& b, int share) {
  // 255 is all of b. Sums stay below 2^24, shares below 2^8.
  return a + (b - a) / 255 * share;
}

FeedMark markAt(const FeedPicture& picture, const FeedPlace& place) {
  constexpr int kShift = FeedPlace::kFractionBits;
  const int x = ((place.x + kOne / 2) >> kShift) / FeedBlobs::kMaskScale;
  const int y = ((place.y + kOne / 2) >> kShift) / FeedBlobs::kMaskScale;
  return picture.marks->contains(x, y) ? (*picture.marks)(x, y) : FeedMark{};
}

Rgb8 hatchAt(int x, int y) {
  return (x + y) % 16 < 8 ? Rgb8(40) : Rgb8(64);
}

/// What the last frustum of a ray shows there.
Sum shownBy(const FeedPicture& picture, const FeedPlace& place, ErasedLook look) {
  const Sum live = sampleOf(*picture.frame, place);
  if (picture.marks == nullptr || picture.background == nullptr) {
    return live;
  }
  const FeedMark mark = markAt(picture, place);
  if (mark.erased == 0) {
    return live;
  }
  Sum still = sampleOf(*picture.background, place);
  if (look == ErasedLook::kRed) {
    still += (Sum(255 << 16, 0, 0) - still) / 256 * kRedShare;
  }
  return mixed(live, still, mark.erased);
}

Rgb8 pixelAt(std::span<const FeedPlace> places, std::span<const FeedPicture> pictures, ErasedLook look, int x, int y) {
  const FeedPicture& last = pictures[places.front().frustum];
  const bool isShown = last.frame != nullptr && places.front().isInFeed();
  Sum sum = isShown ? shownBy(last, places.front(), look) : Sum(hatchAt(x, y)) * (kOne * kOne);
  for (const FeedPlace& place : places.subspan(1)) {
    const FeedPicture& picture = pictures[place.frustum];
    if (picture.frame == nullptr || picture.marks == nullptr || !place.isInFeed()) {
      continue;
    }
    if (const FeedMark mark = markAt(picture, place); mark.shown > 0) {
      sum = mixed(sum, sampleOf(*picture.frame, place), mark.shown);
    }
  }
  return Rgb8((sum + Sum(kOne * kOne / 2)) / (kOne * kOne));
}

}  // namespace

void composeFeeds(const FeedMap& map, std::span<const FeedPicture> pictures, ErasedLook erased, Image<Rgb8>& image) {
  if (image.width() != map.width() || image.height() != map.height()) {
    image = Image<Rgb8>(map.width(), map.height());
  }
  parallelFor(static_cast<size_t>(map.height()), 16, [&](size_t begin, size_t end) {
    for (size_t row = begin; row < end; ++row) {
      for (int x = 0; x < map.width(); ++x) {
        const int y = static_cast<int>(row);
        const size_t pixel = image.index(x, y);
        image[pixel] = pixelAt(map.placesAt(pixel), pictures, erased, x, y);
      }
    }
  });
}

}  // namespace ocelli
