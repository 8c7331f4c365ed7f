#include "oc_core/feeds_measure/error_pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace ocelli {
namespace {

constexpr size_t kMaxPictures = 3;      ///< of each kind of error
constexpr double kPicturesApart = 1.5;  ///< seconds
constexpr int kFrameMargin = 4;         ///< pixels
constexpr int kFrameWidth = 4;          ///< half of it light, half of it dark, so that it is seen on any ground
constexpr int kDash = 8;
const Rgb8 kFrameLight(255, 222, 60);
const Rgb8 kFrameDark(0, 0, 0);

void drawFrameAround(Image<Rgb8>& image, int shift, const WalkerArea& area, bool isBroken) {
  for (int k = 0; k < kFrameWidth; ++k) {
    const Rgb8 color = k < kFrameWidth / 2 ? kFrameLight : kFrameDark;
    const int out = kFrameMargin + k;
    const auto set = [&](int x, int y, int along) {
      const int half = image.width() / 2;
      if (x >= 0 && x < half && y >= 0 && y < image.height() && !(isBroken && along / kDash % 2 != 0)) {
        image(shift + x, y) = color;
      }
    };
    for (int x = area.left - out; x < area.right + out; ++x) {
      set(x, area.top - out, x - area.left + out);
      set(x, area.bottom - 1 + out, x - area.left + out);
    }
    for (int y = area.top - out; y < area.bottom + out; ++y) {
      set(area.left - out, y, y - area.top + out);
      set(area.right - 1 + out, y, y - area.top + out);
    }
  }
}

}  // namespace

Image<Rgb8> markedPair(const Image<Rgb8>& composed, const WalkerArea& shown, const Image<Rgb8>& rendered,
                       const WalkerArea& wanted) {
  Image<Rgb8> both(composed.width() + rendered.width(), composed.height());
  for (int y = 0; y < composed.height(); ++y) {
    for (int x = 0; x < composed.width(); ++x) {
      both(x, y) = composed(x, y);
      both(composed.width() + x, y) = rendered(x, y);
    }
  }
  const auto mark = [&](int shift, const WalkerArea& here, const WalkerArea& there) {
    if (!here.isEmpty() || !there.isEmpty()) {
      drawFrameAround(both, shift, here.isEmpty() ? there : here, here.isEmpty());
    }
  };
  mark(0, shown, wanted);
  mark(composed.width(), wanted, shown);
  return both;
}

bool ErrorPictures::wants(WalkerFate fate, double seconds) const {
  if (fate == WalkerFate::kRight) {
    return false;
  }
  size_t count = 0;
  for (const ErrorPicture& picture : list_) {
    if (picture.fate == fate) {
      ++count;
      if (std::abs(picture.seconds - seconds) < kPicturesApart) {
        return false;
      }
    }
  }
  return count < kMaxPictures;
}

void ErrorPictures::add(WalkerFate fate, size_t walker, double seconds, const Image<Rgb8>& picture) {
  const std::string file = fmt::format("{}-{}-{:.2f}s.png", nameOf(fate), walker + 1, seconds);
  writePng(folder_ / file, picture);
  list_.push_back({file, fate, walker, seconds, picture.width(), picture.height()});
}

}  // namespace ocelli
