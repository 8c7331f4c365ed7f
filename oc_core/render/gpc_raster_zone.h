// What filling triangles needs of one zone of a general pinhole camera (gpc_map.h): the image points of many vertices
// at once, in single precision; where the samples of a pixel lie in the pinhole's image, from tables of columns and
// rows; and how long the edges of triangles may be that are filled as if they were straight.
//
// The inverse of the profile is begun from a table and takes one Newton step. Its error is measured where the table is
// made, in every interval of it, and the table is as fine as it takes: at most kMaxErrorPixels. Zones for which no
// table is fine enough use the profile itself.
//
// r depends on one coordinate alone: beside the region on the column of a pixel, above and below on its row. So W + H
// values of the profile give the samples of all W x H pixels, exactly.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "oc_core/camera/gpc_camera.h"
#include "oc_core/render/visibility_buffer.h"

namespace ocelli {

/// Bounds how the image of a straight edge of the pinhole's image bends near a point. Where xx w^2 + yy h^2 + xy w h <=
/// 1 for the width w and the height h of an edge, and both its ends are in the same part of the image, it strays from a
/// straight one by GpcRasterZone::kChordPixels at most.
struct GpcBend {
  /// Of points without an image: no edge, not even one of no length, is known to be straight.
  static constexpr float kUnknown = std::numeric_limits<float>::infinity();

  float xx = kUnknown;
  float yy = kUnknown;
  float xy = 0;

  float operator()(float width, float height) const {
    return xx * (width * width) + yy * (height * height) + xy * (width * height);
  }
  /// The greater of either.
  friend GpcBend max(const GpcBend& a, const GpcBend& b) {
    return {std::max(a.xx, b.xx), std::max(a.yy, b.yy), std::max(a.xy, b.xy)};
  }
};

/// Vertices that are placed together, pixels. Unused entries hold anything.
struct GpcRun {
  static constexpr size_t kSize = 128;

  alignas(64) std::array<float, kSize> u{};  ///< in the pinhole's image
  alignas(64) std::array<float, kSize> v{};
  alignas(64) std::array<float, kSize> x{};  ///< in the camera's image
  alignas(64) std::array<float, kSize> y{};
  alignas(64) std::array<float, kSize> xx{};  ///< GpcBend
  alignas(64) std::array<float, kSize> yy{};
  alignas(64) std::array<float, kSize> xy{};
  alignas(64) std::array<uint32_t, kSize> part{};
};

class GpcRasterZone {
 public:
  /// What a part number says: kParts * zone + 0 in the inner rectangle, + 1 to 4 in a side of its transition: right,
  /// left, below, above.
  static constexpr uint32_t kParts = 8;
  static constexpr uint32_t kAround = ~uint32_t{0};  ///< in no zone
  static constexpr bool isInTransition(uint32_t part) { return part != kAround && part % kParts != 0; }
  static constexpr bool isBeside(uint32_t part) { return part % kParts <= 2; }

  /// Of image points of vertices; the grid of filling has 1/256.
  static constexpr double kMaxErrorPixels = 1.0 / 1024;
  /// How far the straight edge of a small triangle may lie beside its image.
  static constexpr double kChordPixels = 1.0 / 64;
  /// The longest second derivative of the image along a straight edge, for its whole length, that strays by less. Half
  /// way, and anywhere in a triangle, a chord is an eighth of that off; a quarter of the limit is left for the rounding
  /// of corners to 1/256 pixel and for kMaxErrorPixels.
  static constexpr float kMaxBend = static_cast<float>(8 * kChordPixels * 0.75);
  /// What boxes are grown by for rounding.
  static constexpr float kBoxSlack = 1.0f / 256;

  /// `zone` must outlive it.
  GpcRasterZone(const GpcZone& zone, uint32_t index, const glm::ivec2& size);

  const GpcZone& zone() const { return *zone_; }
  const PixelBounds& innerPixels() const { return innerPixels_; }
  const PixelBounds& outerPixels() const { return outerPixels_; }
  bool isInner(int x, int y) const { return isWithin(innerPixels_, x, y); }
  bool isOuter(int x, int y) const { return isWithin(outerPixels_, x, y); }
  /// The rectangles in the pinhole's image, grown by the slack.
  const ImageBox& innerBox() const { return innerBox_; }
  const ImageBox& outerBox() const { return outerBox_; }
  /// Edges longer than this, squared, may bend more than their ends tell.
  float longestSquared() const { return longestSquared_; }
  /// Whether the inverse of the profile comes from a table.
  bool isTabulated() const { return !nodes_.empty(); }

  /// Gives the points of a run that lie in the zone their position, part and bend; the bend of the others lets edges be
  /// no longer than to the zone.
  void place(GpcRun& run) const;
  /// Where the inner rectangle shows a point.
  glm::vec2 zoomed(float u, float v) const {
    return {(u - center_.x) * zoom_ + center_.x, (v - center_.y) * zoom_ + center_.y};
  }

  /// Around the images of all points in a box of the pinhole's image: never too small, and hardly too large.
  ImageBox imageBox(const ImageBox& pinhole) const;

  /// Where the sample of a pixel of the outer rectangle lies in the pinhole's image, and how far a step of a pixel
  /// leads there. Exact, but for double precision.
  struct Line {
    double r = 0;        ///< distance from the centre, half extents; at most 1 just for lines of the inner rectangle
    double offset = 0;   ///< of pixel centres from the region's
    double scale = 0;    ///< f(r) / r
    double spacing = 0;  ///< the greater of that and f'(r)
  };
  const Line& column(int x) const { return columns_[static_cast<size_t>(x - outerPixels_.x0)]; }
  const Line& row(int y) const { return rows_[static_cast<size_t>(y - outerPixels_.y0)]; }
  struct Range {
    int first = 0;
    int last = -1;  ///< included
  };
  /// The columns in [first, last] whose r is less than that of a row: in these the row's scale holds.
  Range columnsNearerThan(const Line& row, int first, int last) const;
  /// The rows in [first, last] whose r is not greater than that of a column.
  Range rowsNoFartherThan(const Line& column, int first, int last) const;

 private:
  static bool isWithin(const PixelBounds& rect, int x, int y) {
    return x >= rect.x0 && x < rect.x1 && y >= rect.y0 && y < rect.y1;
  }
  void tabulateInverse();
  bool tabulateInverse(size_t steps);
  void bend(GpcRun& run, const std::array<float, GpcRun::kSize>& f,
            const std::array<float, GpcRun::kSize>& magnification) const;
  std::vector<Line> lines(const Range& outer, const Range& inner, int axis) const;
  template <size_t kCount>
  void magnify(const std::array<float, kCount>& f, std::array<float, kCount>& magnification) const;

  /// The inverse less 1 over an interval of f: at its beginning, and its change.
  struct Node {
    float s = 0;
    float change = 0;
  };

  const GpcZone* zone_;
  uint32_t firstPart_;
  PixelBounds innerPixels_;
  PixelBounds outerPixels_;
  ImageBox innerBox_;
  ImageBox outerBox_;
  glm::vec2 center_;
  glm::vec2 perHalf_;
  float zoom_;
  float inner_;            ///< f at the inner edge
  float outer_;            ///< at the outer edge
  float c1_, c2_, c3_;     ///< of the profile
  float compression_ = 0;  ///< intervals are shorter near the inner edge, where a zoom's inverse bends most
  float steps_ = 0;
  float longestSquared_ = 0;
  std::vector<Node> nodes_;  ///< one for each interval
  std::vector<Line> columns_;
  std::vector<Line> rows_;
};

}  // namespace ocelli
