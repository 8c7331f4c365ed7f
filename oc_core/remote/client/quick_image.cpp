#include "oc_core/remote/client/quick_image.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/mat3x3.hpp>

#include "oc_core/base/check.h"
#include "oc_core/base/parallel.h"
#include "oc_core/image/color.h"
#include "oc_core/remote/client/image_cover.h"

namespace ocelli {
namespace {

constexpr int kTableSteps = 2048;  ///< of a magnification: within 1e-3 pixels of the map between its steps
constexpr int kBlock = 4;          ///< pixels that share how many samples each stands for
constexpr int kMaxTaps = 8;
constexpr float kOneSample = 0.5f;  ///< up to 1 + this many samples a pixel count as one
constexpr float kSameDepth = 0.05f;  ///< a gap of a pixel between such depths is closed

/// Bytes of linear values in 65,536 steps: at most one off where a step holds the end of a byte.
const std::array<uint8_t, 65536>& byteTable() {
  static const auto table = [] {
    std::array<uint8_t, 65536> bytes{};
    for (size_t i = 0; i < bytes.size(); ++i) {
      bytes[i] = srgbByteFromLinear((static_cast<float>(i) + 0.5f) / 65536);
    }
    return bytes;
  }();
  return table;
}

uint8_t byteOf(float linear) {
  return byteTable()[static_cast<size_t>(std::clamp(linear, 0.0f, 0.99999f) * 65536)];
}

}  // namespace

/// One view of one image.
class QuickLookup {
 public:
  using Color = QuickImage::Color;

  QuickLookup(const QuickImage& image, const PinholeCamera& view) : image_(image) {
    const PinholeCamera& pinhole = image.reference_;
    const glm::mat3 axes =
        glm::transpose(glm::mat3(pinhole.right(), pinhole.down(), pinhole.forward()));  // camera from world
    const glm::vec3 du = axes * view.right() / view.focalPixels();
    const glm::vec3 dv = axes * view.down() / view.focalPixels();
    const glm::vec3 corner = axes * view.forward() - du * view.centerPixels().x - dv * view.centerPixels().y;
    const auto inPinhole = [&](const glm::vec3& d) {
      return glm::vec3(d.x * pinhole.focalPixels() + d.z * pinhole.centerPixels().x,
                       d.y * pinhole.focalPixels() + d.z * pinhole.centerPixels().y, d.z);
    };
    alongU_ = inPinhole(du);
    alongV_ = inPinhole(dv);
    corner_ = inPinhole(corner);
    offset_ = inPinhole(axes * (view.eye() - pinhole.eye()));
    last_ = {static_cast<float>(image.width_) - 1, static_cast<float>(image.height_) - 1};
  }

  /// Where a point of the view at 1/z meets the image, its samples' middles at whole numbers; within its borders.
  glm::vec2 placeOf(float x, float y, float inverseZ) const {
    const glm::vec3 q = corner_ + alongU_ * x + alongV_ * y + offset_ * inverseZ;
    const float w = 1 / std::max(q.z, 1e-6f);
    glm::vec2 place(q.x * w, q.y * w);
    for (const QuickImage::Zone& zone : image_.zones_) {
      const glm::vec2 d(place.x - zone.centerX, place.y - zone.centerY);
      const float f = std::max(std::abs(d.x) * zone.inverseHalfX, std::abs(d.y) * zone.inverseHalfY);
      if (f < zone.outer) {
        const float m = magnification(zone, f);
        place = {zone.centerX + d.x * m, zone.centerY + d.y * m};
        break;
      }
    }
    return {std::clamp(place.x - 0.5f, 0.0f, last_.x), std::clamp(place.y - 0.5f, 0.0f, last_.y)};
  }

  Color colorAt(const glm::vec2& place) const {
    const int x = std::min(static_cast<int>(place.x), std::max(image_.width_ - 2, 0));
    const int y = std::min(static_cast<int>(place.y), std::max(image_.height_ - 2, 0));
    const float fx = place.x - static_cast<float>(x);
    const float fy = place.y - static_cast<float>(y);
    const QuickImage::Texel* upper = image_.texels_.data() + static_cast<size_t>(y) * static_cast<size_t>(image_.width_) +
                         static_cast<size_t>(x);
    const QuickImage::Texel* lower = upper + (image_.height_ > 1 ? image_.width_ : 0);
    const int next = image_.width_ > 1 ? 1 : 0;
    const Color above = upper[0].values + (upper[next].values - upper[0].values) * fx;
    const Color below = lower[0].values + (lower[next].values - lower[0].values) * fx;
    return above + (below - above) * fy;
  }

  /// A row of the view; `inverse` is its depth, or null at infinity. `known` gets 0 where the image knows nothing.
  void drawRow(int y, int width, const float* inverse, Rgb8* colors, uint8_t* known) const {
    const float middle = static_cast<float>(y - y % kBlock) + kBlock / 2.0f;
    for (int x0 = 0; x0 < width; x0 += kBlock) {
      const int x1 = std::min(x0 + kBlock, width);
      const glm::ivec2 taps = tapsAt(static_cast<float>(x0) + kBlock / 2.0f, middle, inverse != nullptr ? inverse[x0] : 0);
      for (int x = x0; x < x1; ++x) {
        const float w = inverse != nullptr ? inverse[x] : 0;
        Color sum = colorAt(placeOf(static_cast<float>(x) + 0.5f / static_cast<float>(taps.x),
                                    static_cast<float>(y) + 0.5f / static_cast<float>(taps.y), w));
        if (taps.x * taps.y > 1) {
          for (int k = 1; k < taps.x * taps.y; ++k) {
            const float i = static_cast<float>(k % taps.x) + 0.5f;
            const float j = static_cast<float>(k / taps.x) + 0.5f;
            sum += colorAt(placeOf(static_cast<float>(x) + i / static_cast<float>(taps.x),
                                   static_cast<float>(y) + j / static_cast<float>(taps.y), w));
          }
          sum /= static_cast<float>(taps.x * taps.y);
        }
        colors[x] = {byteOf(sum[0]), byteOf(sum[1]), byteOf(sum[2])};
        if (known != nullptr && w == 0) {
          // No surface is there: nothing is seen, or something stands in that direction and was hidden by what has moved.
          colors[x] = Rgb8(0);
          known[x] = sum[3] < 0.5f;
        } else if (known != nullptr) {
          known[x] = 1;
        }
      }
    }
  }

 private:
  static float magnification(const QuickImage::Zone& zone, float f) {
    if (f * zone.zoom <= 1) {
      return zone.zoom;
    }
    const float at = (f - 1 / zone.zoom) / (zone.outer - 1 / zone.zoom) * kTableSteps;
    const int i = std::min(static_cast<int>(at), kTableSteps - 1);
    const float* step = zone.magnification.data() + i;
    return step[0] + (step[1] - step[0]) * (at - static_cast<float>(i));
  }

  glm::ivec2 tapsAt(float x, float y, float inverseZ) const {
    const glm::vec2 at = placeOf(x, y, inverseZ);
    const auto taps = [](const glm::vec2& step) {
      return std::clamp(static_cast<int>(std::ceil(std::sqrt(step.x * step.x + step.y * step.y) - kOneSample)), 1,
                        kMaxTaps);
    };
    return {taps(placeOf(x + 1, y, inverseZ) - at), taps(placeOf(x, y + 1, inverseZ) - at)};
  }

  const QuickImage& image_;
  glm::vec3 alongU_, alongV_, corner_, offset_;
  glm::vec2 last_;
};

namespace {

/// Gaps of one pixel between two like depths are seams between blocks.
void closeSeams(Image<float>& inverse) {
  const auto between = [](float a, float b) {
    return a > 0 && b > 0 && std::abs(a - b) <= kSameDepth * std::max(a, b) ? (a + b) / 2 : 0;
  };
  parallelFor(static_cast<size_t>(inverse.height()), 16, [&](size_t begin, size_t end) {
    for (auto y = static_cast<int>(begin); y < static_cast<int>(end); ++y) {
      for (int x = 1; x + 1 < inverse.width(); ++x) {
        if (inverse(x, y) == 0) {
          inverse(x, y) = between(inverse(x - 1, y), inverse(x + 1, y));
        }
      }
    }
  });
  // Columns of their own threads: a row below must not change while it is read.
  constexpr size_t kColumns = 64;
  parallelFor(static_cast<size_t>(inverse.width()), kColumns, [&](size_t begin, size_t end) {
    for (int y = 1; y + 1 < inverse.height(); ++y) {
      for (auto x = static_cast<int>(begin); x < static_cast<int>(end); ++x) {
        if (inverse(x, y) == 0) {
          inverse(x, y) = between(inverse(x, y - 1), inverse(x, y + 1));
        }
      }
    }
  });
}

/// Pixels of a row that nothing is known of get the colour of the farther end of their run: of the second pixel there, as
/// the first may hold a part of the rim. How many there are.
size_t fillRow(int width, const float* inverse, const uint8_t* known, Rgb8* colors) {
  size_t holes = 0;
  for (int x = 0; x < width;) {
    if (known[x] != 0) {
      ++x;
      continue;
    }
    int end = x;
    while (end < width && known[end] == 0) {
      ++end;
    }
    const int left = x - 1;
    const bool hasLeft = left >= 0;
    const bool hasRight = end < width;
    if (hasLeft || hasRight) {
      const bool takesLeft = hasLeft && (!hasRight || inverse[left] <= inverse[end]);
      const int first = takesLeft ? left : end;
      const int second = first + (takesLeft ? -1 : 1);
      const bool hasSecond = second >= 0 && second < width && known[second] != 0 &&
                             std::abs(inverse[second] - inverse[first]) <= kSameDepth * inverse[first];
      std::fill(colors + x, colors + end, colors[hasSecond ? second : first]);
    }
    holes += static_cast<size_t>(end - x);
    x = end;
  }
  return holes;
}

}  // namespace

QuickImage::QuickImage(const ReferenceImage& image, bool hasDepth)
    : reference_(image.reference()),
      map_(image.layout, image.width(), image.height()),
      width_(image.width()),
      height_(image.height()),
      texels_(image.color.size()) {
  OC_CHECK(!image.isPlaced() && image.pinholeSize.x == 0, "quick pictures are of images of a pinhole");
  parallelFor(texels_.size(), 1 << 14, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const glm::vec3& c = image.color[i];
      texels_[i].values = Color{c.x, c.y, c.z, image.holds(i) ? 1.0f : 0.0f};
    }
  });
  for (const GpcZone& zone : map_.zones()) {
    Zone quick;
    quick.centerX = static_cast<float>(zone.center().x);
    quick.centerY = static_cast<float>(zone.center().y);
    quick.inverseHalfX = static_cast<float>(1 / zone.half().x);
    quick.inverseHalfY = static_cast<float>(1 / zone.half().y);
    quick.outer = static_cast<float>(zone.profile().outer());
    quick.zoom = static_cast<float>(zone.profile().zoom());
    const double first = 1 / zone.profile().zoom();
    for (int i = 0; i <= kTableSteps; ++i) {
      const double f = first + (zone.profile().outer() - first) * i / kTableSteps;
      quick.magnification.push_back(static_cast<float>(zone.magnification(f)));
    }
    zones_.push_back(std::move(quick));
  }
  if (hasDepth) {
    blocks_.emplace(image, map_, blockTolerance(ImageCover(image).nearZ));
  }
}

QuickFrame QuickImage::draw(const PinholeCamera& view) const {
  QuickFrame frame{Image<Rgb8>(view.width(), view.height())};
  const QuickLookup lookup(*this, view);
  frame.isWarped = view.eye() != reference_.eye() && blocks_;
  Image<float> inverse;
  if (frame.isWarped) {
    inverse = blocks_->inverseDepth(view);
    closeSeams(inverse);
  }
  std::vector<size_t> holes(static_cast<size_t>(view.height()));
  parallelFor(holes.size(), 8, [&](size_t begin, size_t end) {
    std::vector<uint8_t> known(static_cast<size_t>(view.width()));
    for (size_t row = begin; row < end; ++row) {
      const auto y = static_cast<int>(row);
      Rgb8* colors = &frame.color(0, y);
      if (!frame.isWarped) {
        lookup.drawRow(y, view.width(), nullptr, colors, nullptr);
        continue;
      }
      lookup.drawRow(y, view.width(), &inverse(0, y), colors, known.data());
      holes[row] = fillRow(view.width(), &inverse(0, y), known.data(), colors);
    }
  });
  size_t sum = 0;
  for (const size_t each : holes) {
    sum += each;
  }
  frame.holes = static_cast<double>(sum) / static_cast<double>(frame.color.size());
  return frame;
}

}  // namespace ocelli
