#include "oc_core/feeds/feed_compose.h"

#include <cstdint>
#include <vector>

#include "oc_core/base/parallel.h"

namespace ocelli {
namespace {

constexpr int kOne = 1 << FeedPlace::kFractionBits;
constexpr int kRedShare = 128;  ///< of 256

using Sum = glm::ivec3;

/// A sum with red and blue side by side, so that one multiplication is two, and in two registers.
struct PackedSum {
  uint64_t redAndBlue = 0;
  uint64_t green = 0;

  void add(const Rgb8& p, uint32_t weight) {
    redAndBlue += (static_cast<uint64_t>(p.b) << 32 | p.r) * weight;
    green += static_cast<uint64_t>(p.g) * weight;
  }
  Sum unpacked() const {
    return {static_cast<int>(redAndBlue & 0xffffffffu), static_cast<int>(green), static_cast<int>(redAndBlue >> 32)};
  }
};

/// In 1/65536, so that no rounding adds up.
PackedSum sampleOf(const Image<Rgb8>& image, const FeedPlace& place) {
  const int x = place.x >> FeedPlace::kFractionBits;
  const int y = place.y >> FeedPlace::kFractionBits;
  const auto fx = static_cast<uint32_t>(place.x & (kOne - 1));
  const auto fy = static_cast<uint32_t>(place.y & (kOne - 1));
  const Rgb8* const above = image.data() + image.index(x, y);
  const Rgb8* const below = above + (y + 1 < image.height() ? static_cast<size_t>(image.width()) : 0);
  const size_t right = x + 1 < image.width() ? 1 : 0;
  PackedSum sum;
  sum.add(above[0], (kOne - fx) * (kOne - fy));
  sum.add(above[right], fx * (kOne - fy));
  sum.add(below[0], (kOne - fx) * fy);
  sum.add(below[right], fx * fy);
  return sum;
}

Sum mixed(const Sum& a, const Sum& b, int share) {
  // 255 is all of b. Sums stay below 2^24, shares below 2^8.
  return a + (b - a) / 255 * share;
}

/// A factor of light for sums.
class LightScale {
 public:
  explicit LightScale(const glm::dvec3& light)
      : scale_(glm::round(glm::clamp(light, 0.0, kMaxLight) * static_cast<double>(1 << kBits))) {}

  Sum of(const PackedSum& sum) const {
    if (scale_ == glm::uvec3(1u << kBits)) {
      return sum.unpacked();
    }
    // Levels in 1/256 times the factor fit into 32 bits.
    const glm::uvec3 lit = (glm::uvec3(sum.unpacked()) >> kFraction) * scale_ >> (kBits - kFraction);
    return {glm::min(lit, glm::uvec3(255u << (2 * kFraction)))};
  }

 private:
  static constexpr unsigned kBits = 12;
  static constexpr unsigned kFraction = FeedPlace::kFractionBits;
  static constexpr double kMaxLight = 4;

  glm::uvec3 scale_;
};

/// A picture with what is the same for all of its pixels.
struct LitPicture {
  const FeedPicture& picture;
  LightScale frameLight{picture.frameLight};
  LightScale backgroundLight{picture.backgroundLight};

  Sum live(const FeedPlace& place) const { return frameLight.of(sampleOf(*picture.frame, place)); }
  Sum still(const FeedPlace& place) const { return backgroundLight.of(sampleOf(*picture.background, place)); }
};

Rgb8 hatchAt(int x, int y) {
  return (x + y) % 16 < 8 ? Rgb8(40) : Rgb8(64);
}

/// What the last frustum of a ray shows there.
Sum shownBy(const LitPicture& lit, const FeedPlace& place, ErasedLook look) {
  const Sum live = lit.live(place);
  if (lit.picture.marks == nullptr || lit.picture.background == nullptr) {
    return live;
  }
  const FeedMark mark = lit.picture.marks->at(place);
  if (mark.erased == 0) {
    return live;
  }
  Sum still = lit.still(place);
  if (look == ErasedLook::kRed) {
    still += (Sum(255 << 16, 0, 0) - still) / 256 * kRedShare;
  }
  return mixed(live, still, mark.erased);
}

Rgb8 pixelAt(std::span<const FeedPlace> places, std::span<const LitPicture> pictures, ErasedLook look, int x, int y) {
  const LitPicture& last = pictures[places.front().frustum];
  const bool isShown = last.picture.frame != nullptr && places.front().isInFeed();
  Sum sum = isShown ? shownBy(last, places.front(), look) : Sum(hatchAt(x, y)) * (kOne * kOne);
  for (const FeedPlace& place : places.subspan(1)) {
    const LitPicture& lit = pictures[place.frustum];
    if (lit.picture.frame == nullptr || lit.picture.marks == nullptr || !place.isInFeed()) {
      continue;
    }
    if (const FeedMark mark = lit.picture.marks->at(place); mark.shown > 0) {
      sum = mixed(sum, lit.live(place), mark.shown);
    }
  }
  return Rgb8((sum + Sum(kOne * kOne / 2)) / (kOne * kOne));
}

}  // namespace

void composeFeeds(const FeedMap& map, std::span<const FeedPicture> pictures, ErasedLook erased, Image<Rgb8>& image) {
  if (image.width() != map.width() || image.height() != map.height()) {
    image = Image<Rgb8>(map.width(), map.height());
  }
  const std::vector<LitPicture> lit(pictures.begin(), pictures.end());
  parallelFor(static_cast<size_t>(map.height()), 16, [&](size_t begin, size_t end) {
    for (size_t row = begin; row < end; ++row) {
      for (int x = 0; x < map.width(); ++x) {
        const int y = static_cast<int>(row);
        const size_t pixel = image.index(x, y);
        image[pixel] = pixelAt(map.placesAt(pixel), lit, erased, x, y);
      }
    }
  });
}

}  // namespace ocelli
