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

/// Of set bits, without the CPU's instruction, which not all have; loops over it become vectors.
uint32_t bitsIn(uint32_t x) {
  x -= (x >> 1) & 0x55555555u;
  x = (x & 0x33333333u) + ((x >> 2) & 0x33333333u);
  x = (x + (x >> 4)) & 0x0f0f0f0fu;
  x += x >> 8;
  return (x + (x >> 16)) & 0x3fu;
}

/// The sum of the numbers of the set bits.
uint32_t columnsOf(uint32_t x) {
  return bitsIn(x & 0xaaaaaaaau) + 2 * bitsIn(x & 0xccccccccu) + 4 * bitsIn(x & 0xf0f0f0f0u) +
         8 * bitsIn(x & 0xff00ff00u) + 16 * bitsIn(x & 0xffff0000u);
}

/// The least whole number that is not below a value, of values from 0 to 32.
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
  covered_.fill(0);
  fullRows_ = 0;
  sum_ = glm::vec3(0);
  openCount_ = 0;
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
  const auto n = static_cast<float>(n_);
  // Along row k from the first on, an edge crosses the row at sample p + k q - offset of the row. A triangle has one or
  // two edges that its samples lie beyond, and one or two before which they lie. Two triangles that share an edge have
  // the same p and q to the last bit.
  struct Crossing {
    float p;
    float q;
  };
  std::array<Crossing, 3> from = {{{-2, 0}, {-2, 0}, {-2, 0}}};
  std::array<Crossing, 3> to = {{{64, 0}, {64, 0}, {64, 0}}};
  const float stepPerB = side_ / n;
  const auto firstRow = static_cast<float>(shown.firstRow);
  size_t froms = 0;
  size_t tos = 0;
  uint32_t sides = ~0u;  // bit k: row k from the first on lies on the inner side of the edges that run along the rows
  for (size_t i = 0; i < 3; ++i) {
    const BlockPlane& edge = t.edges[i];
    const float step = edge.b * stepPerB;
    const float slope = edge.a * side_ + step;
    const float atLeft = edge.a * square_.lower.x + edge.b * square_.lower.y + edge.c + step * firstRow;
    if (slope == 0) {  // whole rows lie on one side
      for (int k = 0; k < rows; ++k) {
        sides &= ~(atLeft + step * static_cast<float>(k) >= 0 ? 0 : 1u << k);
      }
      continue;
    }
    const float scale = n / slope;
    const Crossing crossing{-atLeft * scale, -step * scale};
    (slope > 0 ? from[froms++] : to[tos++]) = crossing;
  }
  const float* offset = offset_.data() + shown.firstRow;
  uint32_t any = 0;
  for (int k = 0; k < rows; k += kLanes) {
    std::array<int, kLanes> first;
    std::array<int, kLanes> beyond;
    for (int lane = 0; lane < kLanes; ++lane) {
      const auto row = static_cast<float>(k + lane);
      const float shift = offset[k + lane];
      const float begin = std::max(from[0].p + from[0].q * row, from[1].p + from[1].q * row) - shift;
      const float end = std::min(to[0].p + to[0].q * row, to[1].p + to[1].q * row) - shift;
      first[static_cast<size_t>(lane)] = ceiling(std::min(std::max(begin, 0.0f), 32.0f));
      beyond[static_cast<size_t>(lane)] = ceiling(std::min(std::max(end, 0.0f), n));
    }
    for (int lane = 0; lane < kLanes && k + lane < rows; ++lane) {
      const auto i = static_cast<size_t>(lane);
      const uint32_t onInnerSide = 0 - (sides >> (k + lane) & 1);
      const uint32_t row =
          onInnerSide & kBelow[static_cast<size_t>(beyond[i])] & ~kBelow[static_cast<size_t>(first[i])];
      shown.samples[static_cast<size_t>(shown.firstRow + k + lane)] = row;
      any |= row;
    }
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
  if (const std::optional<glm::vec3> only = shown.triangle->onlyColor(mesh)) {
    return *only * samples;
  }
  // The sums of the samples' columns, of their shifts and of their rows.
  uint32_t columns = 0;
  float shifts = 0;
  float rows = 0;
  for (int row = shown.firstRow; row <= shown.lastRow; ++row) {
    const uint32_t set = shown.samples[static_cast<size_t>(row)];
    columns += columnsOf(set);
    const auto inRow = static_cast<float>(bitsIn(set));
    shifts += inRow * offset_[static_cast<size_t>(row)];
    rows += inRow * static_cast<float>(row);
  }
  const auto n = static_cast<float>(n_);
  const float u = (static_cast<float>(columns) + shifts) / n;
  const glm::vec2 sum = square_.lower * samples + side_ * glm::vec2(u, (rows + u) / n);
  // Colours are linear over a triangle but for its perspective within one pixel: their mean is that at the mean.
  return shown.triangle->colorAt(sum.x / samples, sum.y / samples, mesh) * samples;
}

void PixelMasks::merge(Shown& shown, const Rows* taken) {
  const uint32_t whole = kBelow[static_cast<size_t>(n_)];
  for (int row = shown.firstRow; row <= shown.lastRow; ++row) {
    const auto r = static_cast<size_t>(row);
    const uint32_t before = covered_[r];
    const uint32_t after = before | shown.samples[r];
    covered_[r] = after;
    fullRows_ += after == whole && before != whole ? 1 : 0;
    shown.samples[r] = (shown.samples[r] & ~before) | (taken != nullptr ? (*taken)[r] : 0);
  }
}

bool PixelMasks::draw(std::span<const PixelTriangle> sorted, BlockTriangles& triangles, const Mesh& mesh) {
  constexpr size_t kAheadOfMasks = 6;
  for (size_t next = 0; next < sorted.size(); ++next) {
    const PixelTriangle& each = sorted[next];
    triangles.expect(sorted[std::min(next + kAheadOfMasks, sorted.size() - 1)].number);
    // What lies before all that follows keeps its samples.
    for (size_t i = 0; i < openCount_;) {
      if (open_[i].farthest > each.nearest) {
        sum_ += weighted(open_[i], mesh);
        open_[i] = open_[--openCount_];
      } else {
        ++i;
      }
    }
    if (fullRows_ == n_ && openCount_ == 0) {
      return false;
    }
    const AntialiasTriangle* triangle = triangles.prepared(each.number);
    if (openCount_ == open_.size()) {
      open_.emplace_back();
    }
    Shown& shown = open_[openCount_];
    if (triangle == nullptr || !cover(*triangle, shown)) {
      continue;
    }
    shown.triangle = triangle;
    shown.farthest = each.farthest;
    if (openCount_ == 0) {
      merge(shown, nullptr);
    } else {
      Rows taken;
      std::fill(taken.begin() + shown.firstRow, taken.begin() + shown.lastRow + 1, 0);
      for (size_t i = 0; i < openCount_; ++i) {
        compare(shown, open_[i], taken);
      }
      merge(shown, &taken);
    }
    ++openCount_;
  }
  return true;
}

glm::vec3 PixelMasks::mean(std::span<PixelTriangle> seen, BlockTriangles& triangles, const ImageBox& square,
                           const SamplePattern& pattern, const Mesh& mesh, const glm::vec3& background) {
  start(square, pattern);
  const auto isNearer = [](const PixelTriangle& a, const PixelTriangle& b) {
    return a.nearest != b.nearest ? a.nearest > b.nearest : a.number < b.number;
  };
  // The nearest first, some at a time: where they hide the rest, that need not be sorted.
  constexpr size_t kMinSorted = 48;
  for (auto from = seen.begin(); from != seen.end();) {
    const auto left = static_cast<size_t>(seen.end() - from);
    const size_t some = std::max(kMinSorted, left / 8);
    const auto to = some + kMinSorted < left ? from + static_cast<std::ptrdiff_t>(some) : seen.end();
    if (to != seen.end()) {
      std::nth_element(from, to, seen.end(), isNearer);
    }
    std::sort(from, to, isNearer);
    if (!draw({from, to}, triangles, mesh)) {
      break;
    }
    from = to;
  }
  for (size_t i = 0; i < openCount_; ++i) {
    sum_ += weighted(open_[i], mesh);
  }
  uint32_t hidden = 0;
  for (int row = 0; row < n_; ++row) {
    hidden += bitsIn(covered_[static_cast<size_t>(row)]);
  }
  const auto all = static_cast<float>(n_ * n_);
  return (sum_ + background * (all - static_cast<float>(hidden))) / all;
}

}  // namespace ocelli
