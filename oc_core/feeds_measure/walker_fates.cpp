#include "oc_core/feeds_measure/walker_fates.h"

#include <algorithm>
#include <numeric>

namespace ocelli {
namespace {

constexpr double kMinSeen = 60;       ///< output pixels: less of a walker is not looked for
constexpr double kMinShare = 0.35;    ///< of the pixels that should show a walker
constexpr double kDoubleShare = 0.2;  ///< of these, elsewhere

}  // namespace

const char* nameOf(WalkerFate fate) {
  switch (fate) {
    case WalkerFate::kRight:
      return "right";
    case WalkerFate::kBetween:
      return "between";
    case WalkerFate::kDoubled:
      return "doubled";
    case WalkerFate::kMisplaced:
      return "misplaced";
    case WalkerFate::kMissing:
      return "missing";
    case WalkerFate::kHidden:
      return "hidden";
    case WalkerFate::kGhost:
      return "ghost";
  }
  return "";
}

const char* meaningOf(WalkerFate fate) {
  switch (fate) {
    case WalkerFate::kRight:
      return "Seen where the graph camera sees it and nowhere else, or rightly not seen.";
    case WalkerFate::kBetween:
      return "Crosses a near face, so that it fades, and is seen.";
    case WalkerFate::kDoubled:
      return "Seen where it should be, and elsewhere too.";
    case WalkerFate::kMisplaced:
      return "Seen elsewhere alone.";
    case WalkerFate::kMissing:
      return "Not seen, though the camera of its frustum sees it.";
    case WalkerFate::kHidden:
      return "Not seen, as somebody stands before it in the feed that should show it.";
    case WalkerFate::kGhost:
      return "Seen, though the graph camera does not see it.";
  }
  return "";
}

double WalkerArea::all() const {
  return std::accumulate(pixels.begin(), pixels.end(), 0.0);
}

void WalkerArea::add(size_t frustum, int x, int y) {
  ++pixels[frustum];
  if (isEmpty()) {
    left = x;
    top = y;
    right = x + 1;
    bottom = y + 1;
    return;
  }
  left = std::min(left, x);
  top = std::min(top, y);
  right = std::max(right, x + 1);
  bottom = std::max(bottom, y + 1);
}

WalkerAreas emptyAreas(size_t walkers, size_t frusta) {
  WalkerArea none;
  none.pixels.assign(frusta, 0);
  return WalkerAreas(walkers, none);
}

WalkerFate fateOf(const WalkerArea& wanted, const WalkerArea& shown, const WalkerArea& seen, bool fades) {
  const double allWanted = wanted.all();
  const double allShown = shown.all();
  if (allWanted < kMinSeen) {
    // What is hardly seen may be hardly shown.
    return allShown >= 2 * kMinSeen + allWanted ? WalkerFate::kGhost : WalkerFate::kRight;
  }
  if (fades) {
    return allShown >= kMinShare * allWanted ? WalkerFate::kBetween : WalkerFate::kMissing;
  }
  const auto home =
      static_cast<size_t>(std::max_element(wanted.pixels.begin(), wanted.pixels.end()) - wanted.pixels.begin());
  double elsewhere = 0;
  for (size_t i = 0; i < wanted.pixels.size(); ++i) {
    if (i != home) {
      elsewhere += std::max(0.0, shown.pixels[i] - wanted.pixels[i]);
    }
  }
  const bool isElsewhere = elsewhere >= std::max(kMinSeen, kDoubleShare * wanted.pixels[home]);
  if (shown.pixels[home] >= kMinShare * wanted.pixels[home]) {
    return isElsewhere ? WalkerFate::kDoubled : WalkerFate::kRight;
  }
  if (isElsewhere) {
    return WalkerFate::kMisplaced;
  }
  return seen.pixels[home] < kMinShare * wanted.pixels[home] ? WalkerFate::kHidden : WalkerFate::kMissing;
}

}  // namespace ocelli
