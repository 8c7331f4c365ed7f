#include "oc_core/antialiasing/pixel_masks.h"

#include <algorithm>
#include <bit>

namespace ocelli {
namespace {

/// Bit i of entry k is set where i < k.
constexpr std::array<uint32_t, PixelMasks::kMaxRows + 1> kBelow = [] {
  std::array<uint32_t, PixelMasks::kMaxRows + 1> below{};
  for (size_t i = 1; i < below.size(); ++i) {
    below[i] = below[i - 1] << 1 | 1;
  }
  return below;
}();

/// Of set bits, without the processor's instruction, which not all have; loops over it become vectors.
uint32_t bitsIn(uint32_t x) {
  x -= (x >> 1) & 0x55555555u;
  x = (x & 0x33333333u) + ((x >> 2) & 0x33333333u);
  x = (x + (x >> 4)) & 0x0f0f0f0fu;
  x += x >> 8;
  return (x + (x >> 16)) & 0x3fu;
}

/// The least whole number that is not below a value, of values from -1 to 33.
int ceiling(float value) {
  return 64 - static_cast<int>(64 - value);
}

}  // namespace

void PixelMasks::start(const ImageBox& square, const SamplePattern& pattern) {
  n_ = pattern.rows();
  square_ = square;
  side_ = square.upper.x - square.lower.x;
  for (int row = 0; row < n_; ++row) {
    offset_[static_cast<size_t>(row)] = pattern.offsetOfRow(row);
  }
  open_.clear();
}

bool PixelMasks::cover(const AntialiasTriangle& t, Shown& shown) const {
  constexpr float kSlack = 1e-3f;  // wider than rounding needs it
  const float rowsPerPixel = static_cast<float>(n_) / side_;
  const float top = (t.box.lower.y - square_.lower.y) * rowsPerPixel - kSlack;
  const float bottom = (t.box.upper.y - square_.lower.y) * rowsPerPixel + kSlack;
  if (!(bottom >= 0 && top < static_cast<float>(n_))) {
    return false;
  }
  shown.firstRow = static_cast<int>(std::max(top, 0.0f));
  shown.lastRow = static_cast<int>(std::min(bottom, static_cast<float>(n_ - 1)));
  const int rows = shown.lastRow - shown.firstRow + 1;
  std::array<int, kMaxRows> first;
  std::array<int, kMaxRows> beyond;
  std::fill_n(first.begin(), rows, 0);
  std::fill_n(beyond.begin(), rows, n_);
  const float* offset = offset_.data() + shown.firstRow;
  const auto n = static_cast<double>(n_);
  const auto side = static_cast<double>(side_);
  for (size_t i = 0; i < 3; ++i) {
    // Along row k the edge is at `slope` x + atLeft + k step, x in pixels from the left: 0 at sample (p + k q -
    // offset). Two triangles that share the edge have the same p and q to the last bit.
    const BlockPlane& edge = t.edges[i];
    const double step = static_cast<double>(edge.b) * side / n;
    const double slope = static_cast<double>(edge.a) * side + step;
    const double atLeft = static_cast<double>(edge.a) * static_cast<double>(square_.lower.x) +
                          static_cast<double>(edge.b) * static_cast<double>(square_.lower.y) +
                          static_cast<double>(edge.c) + step * shown.firstRow;
    if (slope == 0) {
      for (int k = 0; k < rows; ++k) {
        if (atLeft + step * k < static_cast<double>(t.inside[i])) {
          beyond[static_cast<size_t>(k)] = 0;
        }
      }
      continue;
    }
    const auto p = static_cast<float>(-atLeft / slope * n);
    const auto q = static_cast<float>(-step / slope * n);
    if (slope > 0) {
      for (int k = 0; k < rows; ++k) {
        const float at = std::clamp(p + q * static_cast<float>(k) - offset[k], -1.0f, 33.0f);
        first[static_cast<size_t>(k)] = std::max(first[static_cast<size_t>(k)], ceiling(at));
      }
    } else {
      for (int k = 0; k < rows; ++k) {
        const float at = std::clamp(p + q * static_cast<float>(k) - offset[k], -1.0f, 33.0f);
        beyond[static_cast<size_t>(k)] = std::min(beyond[static_cast<size_t>(k)], ceiling(at));
      }
    }
  }
  uint32_t any = 0;
  for (int k = 0; k < rows; ++k) {
    const auto i = static_cast<size_t>(k);
    const uint32_t row = kBelow[static_cast<size_t>(std::max(beyond[i], 0))] &
                         ~kBelow[static_cast<size_t>(std::min(first[i], kMaxRows))];
    shown.samples[static_cast<size_t>(shown.firstRow + k)] = row;
    any |= row;
  }
  return any != 0;
}

glm::vec2 PixelMasks::pointOf(int row, int sample) const {
  const auto n = static_cast<float>(n_);
  const float u = (static_cast<float>(sample) + offset_[static_cast<size_t>(row)]) / n;
  return square_.lower + side_ * glm::vec2(u, (static_cast<float>(row) + u) / n);
}

void PixelMasks::compare(Shown& shown, Shown& other, Rows& taken) const {
  for (int row = std::max(shown.firstRow, other.firstRow); row <= std::min(shown.lastRow, other.lastRow); ++row) {
    const auto r = static_cast<size_t>(row);
    for (uint32_t both = shown.samples[r] & other.samples[r]; both != 0; both &= both - 1) {
      const glm::vec2 at = pointOf(row, std::countr_zero(both));
      const float mine = shown.triangle->inverseZ.at(at.x, at.y);
      const float others = other.triangle->inverseZ.at(at.x, at.y);
      const uint32_t bit = both & -both;
      if (mine > others || (mine == others && shown.triangle->triangle < other.triangle->triangle)) {
        other.samples[r] ^= bit;
        taken[r] |= bit;
      }
    }
  }
}

glm::vec3 PixelMasks::weighted(const Shown& shown, const Mesh& mesh) const {
  uint32_t count = 0;
  for (int row = shown.firstRow; row <= shown.lastRow; ++row) {
    count += bitsIn(shown.samples[static_cast<size_t>(row)]);
  }
  if (count == 0) {
    return glm::vec3(0);
  }
  const auto samples = static_cast<float>(count);
  if (shown.triangle->isOneColor(mesh)) {
    return shown.triangle->colorAt(0, 0, mesh) * samples;
  }
  glm::vec2 sum(0);
  for (int row = shown.firstRow; row <= shown.lastRow; ++row) {
    for (uint32_t left = shown.samples[static_cast<size_t>(row)]; left != 0; left &= left - 1) {
      sum += pointOf(row, std::countr_zero(left));
    }
  }
  // Colours are linear over a triangle but for its perspective within one pixel: their mean is that at the mean.
  sum /= samples;
  return shown.triangle->colorAt(sum.x, sum.y, mesh) * samples;
}

glm::vec3 PixelMasks::mean(std::span<PixelTriangle> triangles, const ImageBox& square, const SamplePattern& pattern,
                           const Mesh& mesh, const glm::vec3& background) {
  start(square, pattern);
  std::sort(triangles.begin(), triangles.end(), [](const PixelTriangle& a, const PixelTriangle& b) {
    return a.nearest != b.nearest ? a.nearest > b.nearest : a.triangle < b.triangle;
  });
  Rows covered{};
  const uint32_t whole = kBelow[static_cast<size_t>(n_)];
  bool allCovered = false;
  glm::vec3 sum(0);
  for (const PixelTriangle& each : triangles) {
    // What lies before all that follows keeps its samples.
    for (size_t i = 0; i < open_.size();) {
      if (open_[i].farthest > each.nearest) {
        sum += weighted(open_[i], mesh);
        open_[i] = open_.back();
        open_.pop_back();
      } else {
        ++i;
      }
    }
    if (allCovered && open_.empty()) {
      break;
    }
    Shown shown;
    shown.triangle = each.triangle;
    shown.farthest = each.farthest;
    if (!cover(*each.triangle, shown)) {
      continue;
    }
    Rows taken;
    std::fill(taken.begin() + shown.firstRow, taken.begin() + shown.lastRow + 1, 0);
    for (Shown& other : open_) {
      compare(shown, other, taken);
    }
    uint32_t any = 0;
    for (int row = shown.firstRow; row <= shown.lastRow; ++row) {
      const auto r = static_cast<size_t>(row);
      const uint32_t before = covered[r];
      covered[r] = before | shown.samples[r];
      shown.samples[r] = (shown.samples[r] & ~before) | taken[r];
      any |= shown.samples[r];
    }
    if (any != 0) {
      open_.push_back(shown);
      allCovered = std::all_of(covered.begin(), covered.begin() + n_, [&](uint32_t row) { return row == whole; });
    }
  }
  for (const Shown& each : open_) {
    sum += weighted(each, mesh);
  }
  uint32_t hidden = 0;
  for (int row = 0; row < n_; ++row) {
    hidden += bitsIn(covered[static_cast<size_t>(row)]);
  }
  const auto all = static_cast<float>(n_ * n_);
  return (sum + background * (all - static_cast<float>(hidden))) / all;
}

}  // namespace ocelli
