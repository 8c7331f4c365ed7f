// The closest fragment of each pixel, and the scan conversion that fills it.
//
// Fill rule: vertices are snapped to 1/256 pixel, edge functions are exact integers, and a pixel centre on an edge
// belongs to the triangle for which that edge is a top or a left one. Triangles that share an edge thus neither overlap
// nor leave a gap. 1/z is interpolated linearly over the image. The closest fragment wins, the lower triangle index on
// a tie, so the result does not depend on the order of drawing; each thread draws into a buffer of its own and the
// buffers are merged.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <utility>
#include <vector>

#include "oc_core/render/fragment_image.h"

namespace ocelli {

/// A projected vertex. b1 and b2 are its barycentric weights on the scene triangle that is being drawn.
struct RasterVertex {
  float u = 0;
  float v = 0;
  float inverseZ = 0;  ///< 1/z; 0 marks a vertex without an image
  float b1 = 0;
  float b2 = 0;
};

/// Snaps a pixel coordinate to the grid of 1/256 pixel on which triangles are filled.
inline constexpr int kSubPixelBits = 8;
/// To the nearest, ties to even, as std::llrint does, but inlined: the last bit of the sum stands for 1.
inline int64_t snapToSubPixel(float pixels) {
  constexpr double kIntegerBits = 6755399441055744.0;  // 1.5 * 2^52
  return std::bit_cast<int64_t>(static_cast<double>(pixels) * (1 << kSubPixelBits) + kIntegerBits) -
         std::bit_cast<int64_t>(kIntegerBits);
}

/// Twice the signed area of the triangle on that grid: negative where its vertices run counter-clockwise as seen, which
/// is its front; 0 where it fills nothing.
inline int64_t snappedArea(const RasterVertex& a, const RasterVertex& b, const RasterVertex& c) {
  const int64_t ax = snapToSubPixel(a.u);
  const int64_t ay = snapToSubPixel(a.v);
  return (snapToSubPixel(b.u) - ax) * (snapToSubPixel(c.v) - ay) -
         (snapToSubPixel(b.v) - ay) * (snapToSubPixel(c.u) - ax);
}

/// A sample as buffers keep it. Keys order samples: bits of z (positive, so ordered as integers), then the triangle.
struct KeyedSample {
  static constexpr uint64_t kEmpty = ~uint64_t{0};

  uint64_t key = kEmpty;
  float b1 = 0;
  float b2 = 0;

  static uint64_t keyOf(float z, uint32_t triangle) {
    return static_cast<uint64_t>(std::bit_cast<uint32_t>(z)) << 32 | triangle;
  }
  Fragment fragment() const {
    if (key == kEmpty) {
      return {};
    }
    return {std::bit_cast<float>(static_cast<uint32_t>(key >> 32)), static_cast<uint32_t>(key), b1, b2};
  }
};

/// From so many pixels on, the covered part of a row is worked out instead of found.
inline constexpr int64_t kWideRow = 24;

/// Pixels [x0, x1) x [y0, y1) of an image.
struct PixelBounds {
  int x0 = 0;
  int y0 = 0;
  int x1 = 0;
  int y1 = 0;
};

/// What the vertices of a triangle weigh at a pixel.
class PixelWeights {
 public:
  /// `shares` are those of the vertices in the image; where the triangle is `turned`, b and c are its third and second.
  PixelWeights(const RasterVertex& a, const RasterVertex& b, const RasterVertex& c, const glm::vec3& shares,
               bool turned)
      : a_(a),
        b_(b),
        c_(c),
        i_(shares.x * a.inverseZ, shares.y * b.inverseZ, shares.z * c.inverseZ),
        z_(1 / (i_.x + i_.y + i_.z)),
        turned_(turned) {}

  float z() const { return z_; }
  /// b1 and b2.
  glm::vec2 operator()() const { return {mixed(a_.b1, b_.b1, c_.b1), mixed(a_.b2, b_.b2, c_.b2)}; }
  /// What is linear over the triangle, given at its three vertices.
  float of(float first, float second, float third) const {
    return turned_ ? mixed(first, third, second) : mixed(first, second, third);
  }

 private:
  float mixed(float atA, float atB, float atC) const { return (i_.x * atA + i_.y * atB + i_.z * atC) * z_; }

  const RasterVertex& a_;
  const RasterVertex& b_;
  const RasterVertex& c_;
  glm::vec3 i_;
  float z_;
  bool turned_;
};

/// Pixels whose centres lie within a box, the last ones included.
struct CentreBox {
  int64_t x0, x1, y0, y1;

  /// Of the box around three points in sub-pixels, and within `rect`: empty for many a small triangle.
  CentreBox(const PixelBounds& rect, const std::pair<int64_t, int64_t>& x, const std::pair<int64_t, int64_t>& y)
      : x0(std::max<int64_t>(first(x.first), rect.x0)),
        x1(std::min<int64_t>(last(x.second), rect.x1 - 1)),
        y0(std::max<int64_t>(first(y.first), rect.y0)),
        y1(std::min<int64_t>(last(y.second), rect.y1 - 1)) {}

  bool empty() const { return x0 > x1 || y0 > y1; }
  /// Where it is not empty.
  int64_t count() const { return (x1 - x0 + 1) * (y1 - y0 + 1); }

 private:
  static constexpr int64_t kOne = 1 << kSubPixelBits;
  static int64_t first(int64_t lowest) { return (lowest - kOne / 2 + kOne - 1) >> kSubPixelBits; }
  static int64_t last(int64_t highest) { return (highest - kOne / 2) >> kSubPixelBits; }
};

/// Calls `emit(pixel, z, weights)` for every pixel of `rect` that the triangle covers, of an image that is so wide;
/// `weights()` gives b1 and b2 there (PixelWeights).
template <class Emit>
void scanTriangle(int width, const PixelBounds& rect, const RasterVertex& a, const RasterVertex& b,
                  const RasterVertex& c, const Emit& emit);
/// For the whole image.
template <class Emit>
void scanTriangle(int width, int height, const RasterVertex& a, const RasterVertex& b, const RasterVertex& c,
                  const Emit& emit) {
  scanTriangle(width, PixelBounds{0, 0, width, height}, a, b, c, emit);
}

class VisibilityBuffer {
 public:
  /// Image coordinates of vertices must stay within this many pixels of the origin (28.8 fixed point, 64-bit products).
  static constexpr float kGuardBandPixels = 4e6f;

  VisibilityBuffer(int width, int height)
      : width_(width), height_(height), samples_(static_cast<size_t>(width) * static_cast<size_t>(height)) {}

  void draw(uint32_t triangle, const RasterVertex& a, const RasterVertex& b, const RasterVertex& c) {
    scanTriangle(width_, height_, a, b, c,
                 [&](size_t pixel, float z, const PixelWeights& weights) { offer(pixel, z, triangle, weights); });
  }
  /// A sample of a triangle at one pixel.
  void offer(size_t pixel, float z, uint32_t triangle, const PixelWeights& weights) {
    const uint64_t key = KeyedSample::keyOf(z, triangle);
    if (key < samples_[pixel].key) {
      const glm::vec2 w = weights();
      samples_[pixel] = {key, w.x, w.y};
    }
  }

  /// Keeps the closer of the two at each pixel in [begin, end).
  void mergePixels(const VisibilityBuffer& other, size_t begin, size_t end);
  Fragment fragment(size_t pixel) const { return samples_[pixel].fragment(); }

 private:
  int width_;
  int height_;
  std::vector<KeyedSample> samples_;
};

template <class Emit>
void scanTriangle(int width, const PixelBounds& rect, const RasterVertex& a, const RasterVertex& b0,
                  const RasterVertex& c0, const Emit& emit) {
  constexpr int64_t kOne = 1 << kSubPixelBits;
  const int64_t ax = snapToSubPixel(a.u);
  const int64_t ay = snapToSubPixel(a.v);
  int64_t bx = snapToSubPixel(b0.u);
  int64_t by = snapToSubPixel(b0.v);
  int64_t cx = snapToSubPixel(c0.u);
  int64_t cy = snapToSubPixel(c0.v);
  const CentreBox box(rect, std::minmax({ax, bx, cx}), std::minmax({ay, by, cy}));
  if (box.empty()) {
    return;
  }
  const int64_t x0 = box.x0;
  const int64_t x1 = box.x1;
  const int64_t y0 = box.y0;
  const int64_t y1 = box.y1;

  int64_t area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
  if (area == 0) {
    return;
  }
  const RasterVertex* b = &b0;
  const RasterVertex* c = &c0;
  const bool turned = area < 0;
  if (turned) {  // both sides of a surface are drawn: turn it around
    std::swap(bx, cx);
    std::swap(by, cy);
    std::swap(b, c);
    area = -area;
  }

  // Edge functions: positive inside. Edges that are neither top nor left give up their own points.
  struct Edge {
    int64_t stepX, stepY, row;
  };
  const auto edge = [&](int64_t px, int64_t py, int64_t qx, int64_t qy) {
    const int64_t dx = qx - px;
    const int64_t dy = qy - py;
    const bool topOrLeft = dy < 0 || (dy == 0 && dx > 0);
    const int64_t startX = x0 * kOne + kOne / 2;
    const int64_t startY = y0 * kOne + kOne / 2;
    return Edge{-dy * kOne, dx * kOne, dx * (startY - py) - dy * (startX - px) - (topOrLeft ? 0 : 1)};
  };
  Edge ea = edge(bx, by, cx, cy);
  Edge eb = edge(cx, cy, ax, ay);
  Edge ec = edge(ax, ay, bx, by);

  // Wide rows are entered and left where the edges are crossed: slivers cover few pixels of their boxes.
  const bool isWide = x1 - x0 >= kWideRow;
  const float perArea = 1.0f / static_cast<float>(area);
  for (int64_t y = y0; y <= y1; ++y) {
    int64_t first = 0;
    int64_t last = x1 - x0;
    for (const Edge* e : {&ea, &eb, &ec}) {
      if (isWide && e->stepX > 0) {
        first = std::max(first, (-e->row + e->stepX - 1) / e->stepX);
      } else if (isWide && e->stepX < 0) {
        last = e->row < 0 ? -1 : std::min(last, e->row / -e->stepX);
      }
    }
    first = std::min(first, x1 - x0 + 1);  // may be far beyond
    int64_t wa = ea.row + first * ea.stepX;
    int64_t wb = eb.row + first * eb.stepX;
    int64_t wc = ec.row + first * ec.stepX;
    for (int64_t x = x0 + first; x <= x0 + last; ++x) {
      if ((wa | wb | wc) >= 0) {
        const float sb = static_cast<float>(wb) * perArea;
        const float sc = static_cast<float>(wc) * perArea;
        const float sa = std::max(1 - sb - sc, 0.0f);
        const PixelWeights weights(a, *b, *c, {sa, sb, sc}, turned);
        emit(static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x), weights.z(), weights);
      }
      wa += ea.stepX;
      wb += eb.stepX;
      wc += ec.stepX;
    }
    ea.row += ea.stepY;
    eb.row += eb.stepY;
    ec.row += ec.stepY;
  }
}

}  // namespace ocelli
