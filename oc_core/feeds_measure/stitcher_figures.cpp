#include "oc_core/feeds_measure/stitcher_figures.h"

#include <algorithm>

#include "oc_core/base/check.h"
#ifdef OCELLI_WITH_STITCHER
#include "oc_core/feeds_stitch/stitch_feeds.h"
#endif

namespace ocelli {

#ifdef OCELLI_WITH_STITCHER
namespace {

constexpr size_t kMinStitchedPixels = 60;  ///< of a feed's part: less of a walker is not looked for

/// Pixels of each walker by feed, in an image of walkers and one of owners.
std::vector<std::vector<size_t>> walkerPixels(const StitchedFeeds& stitched, size_t walkers, size_t feeds) {
  std::vector<std::vector<size_t>> pixels(walkers, std::vector<size_t>(feeds, 0));
  for (size_t i = 0; i < stitched.labels.size(); ++i) {
    const size_t walker = stitched.labels[i];
    const size_t owner = stitched.owner[i];
    if (walker > 0 && owner > 0 && walker <= walkers && owner <= feeds) {
      ++pixels[walker - 1][owner - 1];
    }
  }
  return pixels;
}

size_t pixelsOf(const WalkerMask& mask, size_t walker) {
  size_t count = 0;
  for (size_t i = 0; i < mask.size(); ++i) {
    count += mask[i] == walker + 1;
  }
  return count;
}

}  // namespace

bool hasStitcher() {
  return true;
}

void addStitchedFrame(const std::vector<Image<Rgb8>>& frames, const std::vector<WalkerMask>& masks, size_t walkers,
                      StitcherFigures& figures) {
  const StitchedFeeds stitched = stitchFeeds(frames, masks);
  ++figures.frames;
  figures.seconds += stitched.seconds;
  if (stitched.feeds.empty()) {
    return;
  }
  ++figures.pictures;
  figures.picturesOfAll += stitched.feeds.size() == frames.size();
  const auto pixels = walkerPixels(stitched, walkers, frames.size());
  for (size_t w = 0; w < walkers; ++w) {
    const bool isInAny = std::any_of(masks.begin(), masks.end(),
                                     [&](const WalkerMask& mask) { return pixelsOf(mask, w) >= kMinStitchedPixels; });
    if (!isInAny) {
      continue;
    }
    const auto parts =
        std::count_if(pixels[w].begin(), pixels[w].end(), [](size_t count) { return count >= kMinStitchedPixels; });
    ++(parts == 0 ? figures.notSeen : parts == 1 ? figures.seenOnce : figures.seenTwice);
  }
}
#else
bool hasStitcher() {
  return false;
}

void addStitchedFrame(const std::vector<Image<Rgb8>>& /*frames*/, const std::vector<WalkerMask>& /*masks*/,
                      size_t /*walkers*/, StitcherFigures& /*figures*/) {
  OC_CHECK(false, "callers ask hasStitcher() first");
}
#endif

}  // namespace ocelli
