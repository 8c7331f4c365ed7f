#include "oc_core/remote/client/quick_image.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
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
constexpr float kOneSample = 0.5f;    ///< up to 1 + this many samples a pixel count as one
constexpr float kHalfSamples = 1.8f;  ///< from so many samples a pixel on, the geometric mean of both axes,
constexpr float kFewSamples = 1.2f;   ///< ... and so many along either, those of half the size do
constexpr float kSameDepth = 0.05f;   ///< a gap of a pixel between such depths is closed
constexpr float kLastByteStep = 65535;

using Four = float __attribute__((vector_size(16)));
using FourIntegers = int32_t __attribute__((vector_size(16)));

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

}  // namespace

/// One view of one image.
class QuickLookup {
 public:
  using Color = QuickImage::Color;

  QuickLookup(const QuickImage& image, const PinholeCamera& view) : image_(image), bytes_(byteTable().data()) {
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
  }

  struct Taps {
    int across = 1;
    int down = 1;
    size_t level = 0;
  };

  /// How many samples the pixels of each block stand for, of a row of blocks that begins at row y. `inverse` is 1/z of
  /// the pixels of that row, or null at infinity.
  void findTaps(int y, int width, const float* inverse, std::vector<Taps>& taps) const {
    taps.clear();
    for (int x = 0; x < width; x += kBlock) {
      taps.push_back(tapsAt(static_cast<float>(x) + kBlock / 2.0f, static_cast<float>(y) + kBlock / 2.0f,
                            inverse != nullptr ? inverse[x] : 0));
    }
  }

  /// A row of the view. `known` gets 0 where the image knows nothing.
  void drawRow(int y, int width, const std::vector<Taps>& tapsOfBlock, const float* inverse, Rgb8* colors,
               uint8_t* known) const {
    for (int x0 = 0; x0 < width; x0 += kBlock) {
      const int count = std::min(kBlock, width - x0);
      const auto x = static_cast<float>(x0);
      Four depth{0, 0, 0, 0};
      if (inverse != nullptr) {
        std::memcpy(&depth, inverse + x0, static_cast<size_t>(count) * sizeof(float));
        if (depth[0] == 0 && depth[1] == 0 && depth[2] == 0 && depth[3] == 0) {
          std::fill_n(colors + x0, count, Rgb8(0));
          std::fill_n(known + x0, count,
                      static_cast<uint8_t>(!holdsAt(x + kBlock / 2.0f, static_cast<float>(y) + 0.5f)));
          continue;
        }
      }
      const Taps& taps = tapsOfBlock[static_cast<size_t>(x0 / kBlock)];
      std::array<Color, kBlock> sums{};
      for (int j = 0; j < taps.down; ++j) {
        for (int i = 0; i < taps.across; ++i) {
          const float u = x + (static_cast<float>(i) + 0.5f) / static_cast<float>(taps.across);
          const float v = static_cast<float>(y) + (static_cast<float>(j) + 0.5f) / static_cast<float>(taps.down);
          const Places places = placesOf(Four{u, u + 1, u + 2, u + 3}, v, depth);
          addColors(image_.levels_[taps.level], places, sums);
        }
      }
      const float scale = 1 / static_cast<float>(taps.across * taps.down);
      for (int k = 0; k < count; ++k) {
        const Color color = sums[static_cast<size_t>(k)] * scale;
        const FourIntegers step = __builtin_convertvector(color * kLastByteStep, FourIntegers);
        colors[x0 + k] = {bytes_[step[0]], bytes_[step[1]], bytes_[step[2]]};
        if (known != nullptr) {
          known[x0 + k] = 1;
          if (depth[k] == 0) {
            // No surface: nothing is seen, or something stands there and was hidden by what has moved.
            colors[x0 + k] = Rgb8(0);
            known[x0 + k] = color[3] < 0.5f;
          }
        }
      }
    }
  }

 private:
  struct Places {
    Four x, y;  ///< pixels of the image
  };

  /// Where four points of a row of the view, at 1/z, meet the image.
  Places placesOf(const Four& u, float v, const Four& inverseZ) const {
    const glm::vec3 row = corner_ + alongV_ * v;
    const Four w = row.z + alongU_.z * u + offset_.z * inverseZ;
    const Four safe = w > kMinW ? w : Four{} + kMinW;
    Places places{(row.x + alongU_.x * u + offset_.x * inverseZ) / safe,
                  (row.y + alongU_.y * u + offset_.y * inverseZ) / safe};
    for (const QuickImage::Zone& zone : image_.zones_) {
      const Four dx = places.x - zone.centerX;
      const Four dy = places.y - zone.centerY;
      const Four fx = (dx < 0 ? -dx : dx) * zone.inverseHalfX;
      const Four fy = (dy < 0 ? -dy : dy) * zone.inverseHalfY;
      const Four f = fx > fy ? fx : fy;
      Four m{1, 1, 1, 1};
      for (int k = 0; k < kBlock; ++k) {
        if (f[k] < zone.outer) {
          m[k] = magnification(zone, f[k]);
        }
      }
      // Zones do not overlap: elsewhere the place stays as it is.
      places.x += dx * (m - 1);
      places.y += dy * (m - 1);
    }
    return places;
  }

  /// Whether the image has a sample in the direction of a point of the view.
  bool holdsAt(float u, float v) const {
    const Places places = placesOf(Four{} + u, v, Four{});
    const QuickImage::Level& level = image_.levels_[0];
    const int x =
        static_cast<int>(std::clamp(static_cast<float>(places.x[0]), 0.0f, static_cast<float>(level.width - 1)));
    const int y =
        static_cast<int>(std::clamp(static_cast<float>(places.y[0]), 0.0f, static_cast<float>(level.height - 1)));
    return level.texels[static_cast<size_t>(y) * static_cast<size_t>(level.width) + static_cast<size_t>(x)].values[3] >
           0;
  }

  /// Adds what lies between the four samples around each place, within the borders.
  static void addColors(const QuickImage::Level& level, const Places& places, std::array<Color, kBlock>& sums) {
    const auto within = [](const Four& at, float last) {
      const Four low = at > 0 ? at : Four{};
      return low < last ? low : Four{} + last;
    };
    const auto lowerOf = [](const Four& at, int last) {
      const FourIntegers lower = __builtin_convertvector(at, FourIntegers);
      return lower < last ? lower : FourIntegers{} + last;
    };
    const Four x = within(places.x * level.scale - 0.5f, static_cast<float>(level.width - 1));
    const Four y = within(places.y * level.scale - 0.5f, static_cast<float>(level.height - 1));
    const FourIntegers left = lowerOf(x, std::max(level.width - 2, 0));
    const FourIntegers top = lowerOf(y, std::max(level.height - 2, 0));
    const Four fx = x - __builtin_convertvector(left, Four);
    const Four fy = y - __builtin_convertvector(top, Four);
    const FourIntegers first = top * level.width + left;
    const int next = level.width > 1 ? 1 : 0;
    const int below = level.height > 1 ? level.width : 0;
    for (int k = 0; k < kBlock; ++k) {
      const QuickImage::Texel* upper = level.texels.data() + first[k];
      const QuickImage::Texel* lower = upper + below;
      const Color a = upper[0].values + (upper[next].values - upper[0].values) * fx[k];
      const Color b = lower[0].values + (lower[next].values - lower[0].values) * fx[k];
      sums[static_cast<size_t>(k)] += a + (b - a) * fy[k];
    }
  }

  static float magnification(const QuickImage::Zone& zone, float f) {
    if (f * zone.zoom <= 1) {
      return zone.zoom;
    }
    const float at = (f - 1 / zone.zoom) * zone.stepsPerF;
    const int i = std::min(static_cast<int>(at), kTableSteps);
    const float* step = zone.magnification.data() + i;
    return step[0] + (step[1] - step[0]) * (at - static_cast<float>(i));
  }

  /// How many samples a pixel stands for.
  Taps tapsAt(float x, float y, float inverseZ) const {
    const Four depth = Four{} + inverseZ;
    const Places row = placesOf(Four{x, x + 1, x, x}, y, depth);
    const Places below = placesOf(Four{x, x, x, x}, y + 1, depth);
    const float across = std::hypot(row.x[1] - row.x[0], row.y[1] - row.y[0]);
    const float down = std::hypot(below.x[0] - row.x[0], below.y[0] - row.y[0]);
    Taps taps;
    float samples = 1;
    while (taps.level + 1 < image_.levels_.size() && std::min(across, down) >= kFewSamples * samples &&
           across * down >= kHalfSamples * kHalfSamples * samples * samples) {
      ++taps.level;
      samples *= 2;
    }
    const auto count = [samples](float step) {
      return static_cast<int>(std::clamp(std::ceil(step / samples - kOneSample), 1.0f, static_cast<float>(kMaxTaps)));
    };
    taps.across = count(across);
    taps.down = count(down);
    return taps;
  }

  static constexpr float kMinW = 1e-6f;

  const QuickImage& image_;
  const uint8_t* bytes_;
  glm::vec3 alongU_, alongV_, corner_, offset_;
};

namespace {

Four fourAt(const float* values) {
  Four four;
  std::memcpy(&four, values, sizeof four);
  return four;
}

/// `middle`, or where there is none between two like depths, their mean.
Four closed(const Four& middle, const Four& a, const Four& b) {
  const Four zero{};
  const Four greater = a > b ? a : b;
  const Four difference = a > b ? a - b : b - a;
  const Four lesser = greater - difference;
  const Four mean = lesser > zero ? (a + b) * 0.5f : zero;
  const Four close = difference <= kSameDepth * greater ? mean : zero;
  return middle > zero ? middle : close;
}

/// Gaps of one pixel between two like depths are seams between blocks.
Image<float> withoutSeams(const Image<float>& inverse) {
  const auto width = inverse.width();
  const auto pass = [&](const Image<float>& from, int marginX, int marginY, ptrdiff_t step) {
    Image<float> to = from;
    parallelFor(static_cast<size_t>(std::max(from.height() - 2 * marginY, 0)), 16, [&](size_t begin, size_t end) {
      for (size_t row = begin; row < end; ++row) {
        const float* const in = &from(0, static_cast<int>(row) + marginY);
        float* const out = &to(0, static_cast<int>(row) + marginY);
        for (int x = marginX; x + 4 + marginX <= width; x += 4) {
          const Four four = closed(fourAt(in + x), fourAt(in + x - step), fourAt(in + x + step));
          std::memcpy(out + x, &four, sizeof four);
        }
      }
    });
    return to;
  };
  return pass(pass(inverse, 1, 0, 1), 0, 1, width);
}

/// Pixels of a row that nothing is known of get the colour of the farther end of their run: of the second pixel there,
/// as the first may hold a part of the rim. How many there are.
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

QuickImage::Level QuickImage::halved(const Level& level) {
  Level half{(level.width + 1) / 2, (level.height + 1) / 2, level.scale / 2, {}};
  half.texels.resize(static_cast<size_t>(half.width) * static_cast<size_t>(half.height));
  const auto at = [&](int x, int y) -> const Color& {
    return level
        .texels[static_cast<size_t>(std::min(y, level.height - 1)) * static_cast<size_t>(level.width) +
                static_cast<size_t>(std::min(x, level.width - 1))]
        .values;
  };
  parallelFor(static_cast<size_t>(half.height), 16, [&](size_t begin, size_t end) {
    for (auto y = static_cast<int>(begin); y < static_cast<int>(end); ++y) {
      for (int x = 0; x < half.width; ++x) {
        half.texels[static_cast<size_t>(y) * static_cast<size_t>(half.width) + static_cast<size_t>(x)].values =
            (at(2 * x, 2 * y) + at(2 * x + 1, 2 * y) + at(2 * x, 2 * y + 1) + at(2 * x + 1, 2 * y + 1)) * 0.25f;
      }
    }
  });
  return half;
}

QuickImage::QuickImage(const ReferenceImage& image, bool hasDepth)
    : reference_(image.reference()), map_(image.layout, image.width(), image.height()) {
  OC_CHECK(!image.isPlaced() && image.pinholeSize.x == 0, "quick pictures are of images of a pinhole");
  levels_.push_back({image.width(), image.height(), 1, std::vector<Texel>(image.color.size())});
  std::vector<Texel>& texels = levels_.front().texels;
  parallelFor(texels.size(), 1 << 14, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const glm::vec3 c = glm::clamp(image.color[i], 0.0f, 1.0f);
      texels[i].values = Color{c.x, c.y, c.z, image.holds(i) ? 1.0f : 0.0f};
    }
  });
  while (levels_.size() < kLevels && std::min(levels_.back().width, levels_.back().height) > 1) {
    levels_.push_back(halved(levels_.back()));
  }
  for (const GpcZone& zone : map_.zones()) {
    Zone quick;
    quick.centerX = static_cast<float>(zone.center().x);
    quick.centerY = static_cast<float>(zone.center().y);
    quick.inverseHalfX = static_cast<float>(1 / zone.half().x);
    quick.inverseHalfY = static_cast<float>(1 / zone.half().y);
    quick.outer = static_cast<float>(zone.profile().outer());
    quick.zoom = static_cast<float>(zone.profile().zoom());
    const double first = 1 / zone.profile().zoom();
    quick.stepsPerF = static_cast<float>(kTableSteps / (zone.profile().outer() - first));
    for (int i = 0; i <= kTableSteps; ++i) {
      const double f = first + (zone.profile().outer() - first) * i / kTableSteps;
      quick.magnification.push_back(static_cast<float>(zone.magnification(f)));
    }
    quick.magnification.push_back(quick.magnification.back());
    zones_.push_back(std::move(quick));
  }
  if (hasDepth) {
    const DepthSpan span = depthSpanOf(image);
    blocks_.emplace(image, map_, blockTolerance(span.nearZ, span.farZ));
  }
}

QuickFrame QuickImage::draw(const PinholeCamera& view) const {
  QuickFrame frame{Image<Rgb8>(view.width(), view.height())};
  const QuickLookup lookup(*this, view);
  frame.isWarped = view.eye() != reference_.eye() && blocks_;
  Image<float> inverse;
  if (frame.isWarped) {
    inverse = withoutSeams(blocks_->inverseDepth(view));
  }
  const int width = view.width();
  std::vector<size_t> holes(static_cast<size_t>((view.height() + kBlock - 1) / kBlock));
  parallelFor(holes.size(), 2, [&](size_t begin, size_t end) {
    std::vector<uint8_t> known(static_cast<size_t>(width));
    std::vector<QuickLookup::Taps> taps;
    for (size_t band = begin; band < end; ++band) {
      const int first = static_cast<int>(band) * kBlock;
      lookup.findTaps(first, width, frame.isWarped ? &inverse(0, first) : nullptr, taps);
      for (int y = first; y < std::min(first + kBlock, view.height()); ++y) {
        Rgb8* colors = &frame.color(0, y);
        if (!frame.isWarped) {
          lookup.drawRow(y, width, taps, nullptr, colors, nullptr);
          continue;
        }
        lookup.drawRow(y, width, taps, &inverse(0, y), colors, known.data());
        holes[band] += fillRow(width, &inverse(0, y), known.data(), colors);
      }
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
