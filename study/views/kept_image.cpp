#include "study/views/kept_image.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>

#include "oc_core/base/parallel.h"
#include "oc_core/image/color.h"
#include "oc_core/render/identity_image.h"

namespace ocelli {
namespace {

constexpr size_t kRowsOfTask = 32;
constexpr uint32_t kMaxObject = 0xffff;

/// Linear light of bytes, and bytes of linear light: by tables, as screens ask for millions of pixels a second.
class Encoding {
 public:
  Encoding() {
    for (size_t i = 0; i < linear_.size(); ++i) {
      linear_[i] = linearFromSrgbByte(static_cast<uint8_t>(i));
    }
    for (size_t i = 0; i < bytes_.size(); ++i) {
      bytes_[i] = srgbByteFromLinear(static_cast<float>(i) / kLast);
    }
  }
  glm::vec3 linear(const Rgb8& pixel) const { return {linear_[pixel.x], linear_[pixel.y], linear_[pixel.z]}; }
  Rgb8 bytes(const glm::vec3& light) const { return {byte(light.x), byte(light.y), byte(light.z)}; }

 private:
  uint8_t byte(float light) const { return bytes_[static_cast<size_t>(light * kLast + 0.5f)]; }

  /// The darkest bytes are a 3,300th apart, so that each byte comes back.
  static constexpr float kLast = (1 << 14) - 1;

  std::array<float, 256> linear_{};
  std::array<uint8_t, 1 << 14> bytes_{};
};

/// Where a pixel of a larger or smaller image lies in the one that is kept, along one side.
struct Tap {
  int first = 0;  ///< pixel of the image; the next one has the rest of the weight
  float second = 0;
  int nearest = 0;
};

std::vector<Tap> tapsOf(int from, int to) {
  std::vector<Tap> taps(static_cast<size_t>(to));
  for (int i = 0; i < to; ++i) {
    const double at = (i + 0.5) * from / to;
    const double below = std::clamp(at - 0.5, 0.0, from - 1.0);
    const int first = std::min(static_cast<int>(below), std::max(0, from - 2));
    taps[static_cast<size_t>(i)] = {first, static_cast<float>(below - first), std::min(static_cast<int>(at), from - 1)};
  }
  return taps;
}

}  // namespace

KeptImage::KeptImage(const Image<Rgb8>& pixels, const Image<uint32_t>& objects)
    : size_(pixels.width(), pixels.height()) {
  OC_CHECK(objects.width() == size_.x && objects.height() == size_.y, "objects are those of the pixels");
  glm::ivec2 lower = size_;
  glm::ivec2 upper(-1);
  for (int y = 0; y < size_.y; ++y) {
    for (int x = 0; x < size_.x; ++x) {
      if (pixels(x, y) != Rgb8(0) || objects(x, y) != kNothing) {
        lower = glm::min(lower, glm::ivec2(x, y));
        upper = glm::max(upper, glm::ivec2(x, y));
      }
    }
  }
  if (upper.x < 0) {
    return;
  }
  corner_ = lower;
  pixels_ = Image<Rgb8>(upper.x - lower.x + 1, upper.y - lower.y + 1);
  objects_ = Image<uint16_t>(pixels_.width(), pixels_.height());
  for (int y = 0; y < pixels_.height(); ++y) {
    for (int x = 0; x < pixels_.width(); ++x) {
      pixels_(x, y) = pixels(lower.x + x, lower.y + y);
      const uint32_t object = objects(lower.x + x, lower.y + y);
      OC_CHECK(object == kNothing || object < kMaxObject, "two bytes hold an object");
      objects_(x, y) = object == kNothing ? 0 : static_cast<uint16_t>(object + 1);
    }
  }
}

size_t KeptImage::bytes() const {
  return sizeof(KeptImage) + pixels_.size() * (sizeof(Rgb8) + sizeof(uint16_t));
}

ShownImage KeptImage::at(const glm::ivec2& size) const {
  ShownImage shown;
  shown.pixels = Image<Rgb8>(size.x, size.y, Rgb8(0));
  shown.objects = Image<uint32_t>(size.x, size.y, kNothing);
  if (pixels_.empty()) {
    return shown;
  }
  const std::vector<Tap> columns = tapsOf(size_.x, size.x);
  const std::vector<Tap> rows = tapsOf(size_.y, size.y);
  static const Encoding kEncoding;
  const auto lightAt = [&](int x, int y) {
    return pixels_.contains(x - corner_.x, y - corner_.y) ? kEncoding.linear(pixels_(x - corner_.x, y - corner_.y))
                                                          : glm::vec3(0);
  };
  // Columns that nothing is kept of stay black.
  const auto isBefore = [&](const Tap& tap, int column) { return tap.first + 1 < column; };
  const auto begin = std::lower_bound(columns.begin(), columns.end(), corner_.x, isBefore) - columns.begin();
  const auto end =
      std::lower_bound(columns.begin(), columns.end(), corner_.x + pixels_.width() + 1, isBefore) - columns.begin();
  parallelFor(rows.size(), kRowsOfTask, [&](size_t firstRow, size_t lastRow) {
    for (size_t y = firstRow; y < lastRow; ++y) {
      const Tap& row = rows[y];
      if (row.first + 1 < corner_.y || row.first >= corner_.y + pixels_.height()) {
        continue;
      }
      for (auto x = static_cast<size_t>(begin); x < static_cast<size_t>(end); ++x) {
        const Tap& column = columns[x];
        const glm::vec3 upper =
            glm::mix(lightAt(column.first, row.first), lightAt(column.first + 1, row.first), column.second);
        const glm::vec3 lower =
            glm::mix(lightAt(column.first, row.first + 1), lightAt(column.first + 1, row.first + 1), column.second);
        const glm::ivec2 at(static_cast<int>(x), static_cast<int>(y));
        shown.pixels(at.x, at.y) = kEncoding.bytes(glm::mix(upper, lower, row.second));
        const glm::ivec2 nearest = glm::ivec2(column.nearest, row.nearest) - corner_;
        if (objects_.contains(nearest.x, nearest.y) && objects_(nearest.x, nearest.y) > 0) {
          shown.objects(at.x, at.y) = objects_(nearest.x, nearest.y) - 1u;
        }
      }
    }
  });
  return shown;
}

}  // namespace ocelli
