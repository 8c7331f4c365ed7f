#include "oc_core/sea/warp_map.h"

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <limits>
#include <span>
#include <vector>

#include "oc_core/sea/near_atan.h"

namespace ocelli {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
/// A cell is drawn by its corners where its middle lies within so many pixels of where they say.
constexpr float kMostBend = 0.125f;
constexpr int kFinest = 2;  ///< pixels that share a ray where cells are refined

/// What a ray of the target meets.
struct Meeting {
  glm::vec2 place{kNaN, kNaN};  ///< in the reference
  float distance = 0;           ///< from the target
};

/// What SeaProjection does, for many pixels: by tables, and by angles that are near enough.
class WarpProjection {
 public:
  explicit WarpProjection(const SeaProjection& projection) : projection_(projection) {
    if (projection.kind == SeaProjectionKind::kPanorama) {
      // Pixels of warps stand at halves of pixels.
      for (int i = 0; i <= 2 * projection.width; ++i) {
        const glm::vec3 level =
            projection.direction({0.5f * static_cast<float>(i), 0.5f * static_cast<float>(projection.height)});
        longitudes_.emplace_back(level.x, level.z);
      }
      for (int i = 0; i <= 2 * projection.height; ++i) {
        const glm::vec3 ahead =
            projection.direction({0.5f * static_cast<float>(projection.width), 0.5f * static_cast<float>(i)});
        latitudes_.emplace_back(-ahead.z, ahead.y);
      }
    }
  }

  glm::vec3 direction(const glm::vec2& pixel) const {
    if (longitudes_.empty()) {
      return projection_.direction(pixel);
    }
    const glm::vec2& longitude = longitudes_[static_cast<size_t>(2 * pixel.x)];
    const glm::vec2& latitude = latitudes_[static_cast<size_t>(2 * pixel.y)];
    return {longitude.x * latitude.x, latitude.y, longitude.y * latitude.x};
  }

  /// NaN where it is not seen.
  glm::vec2 pixel(const glm::vec3& direction) const {
    if (longitudes_.empty()) {
      const auto found = projection_.pixel(direction);
      return found && !isOutside(*found) ? *found : glm::vec2(kNaN);
    }
    constexpr float kPerTurn = 0.15915494f;
    const float longitude = nearAtan2(direction.x, -direction.z);
    const float level = std::sqrt(direction.x * direction.x + direction.z * direction.z);
    const float latitude = nearAtan2(direction.y, level);
    return {(longitude * kPerTurn + 0.5f) * static_cast<float>(projection_.width),
            (0.5f - 2 * latitude * kPerTurn) * static_cast<float>(projection_.height)};
  }

 private:
  bool isOutside(const glm::vec2& place) const {
    return place.x < 0 || place.y < 0 || place.x > static_cast<float>(projection_.width) ||
           place.y > static_cast<float>(projection_.height);
  }

  const SeaProjection& projection_;
  std::vector<glm::vec2> longitudes_;  ///< of a panorama: x and z of level directions
  std::vector<glm::vec2> latitudes_;   ///< how long their level part is, and their y
};

class WarpRays {
 public:
  WarpRays(const SeaProxy& proxy, const SeaProjection& projection, const SeaPose& target, const SeaPose& reference)
      : proxy_(proxy),
        projection_(projection),
        eye_(target.position),
        worldFromTarget_(glm::mat3_cast(target.worldFromCamera)),
        referenceEye_(reference.position),
        referenceFromWorld_(glm::mat3_cast(glm::inverse(reference.worldFromCamera))) {}

  glm::vec3 direction(const glm::vec2& pixel) const { return worldFromTarget_ * projection_.direction(pixel); }

  /// Where the reference has a point, whether it sees it or not; NaN beyond its borders.
  glm::vec2 placeOf(const glm::vec3& point) const {
    return projection_.pixel(referenceFromWorld_ * (point - referenceEye_));
  }

  /// One meeting a pixel.
  void follow(std::span<const glm::vec2> pixels, std::span<Meeting> meetings) {
    lines_.resize(pixels.size());
    shares_.resize(pixels.size());
    blocked_.resize(pixels.size());
    const float far = proxy_.far();
    for (size_t i = 0; i < pixels.size(); ++i) {
      lines_[i] = {eye_, eye_ + direction(pixels[i]) * far};
    }
    proxy_.rays().meet(lines_, shares_);
    for (size_t i = 0; i < pixels.size(); ++i) {
      const float share = std::isinf(shares_[i]) ? 1.0f : shares_[i];
      const glm::vec3 point = lines_[i].from + (lines_[i].to - lines_[i].from) * share;
      meetings[i] = {placeOf(point), share * far};
      lines_[i] = {referenceEye_, glm::mix(point, referenceEye_, kSightMargin)};
    }
    proxy_.blocked().find(lines_, blocked_);
    for (size_t i = 0; i < pixels.size(); ++i) {
      if (blocked_[i] != 0) {
        meetings[i].place = glm::vec2(kNaN);
      }
    }
  }

  const glm::vec3& eye() const { return eye_; }

 private:
  const SeaProxy& proxy_;
  WarpProjection projection_;
  glm::vec3 eye_;
  glm::mat3 worldFromTarget_;
  glm::vec3 referenceEye_;
  glm::mat3 referenceFromWorld_;
  std::vector<SightLine> lines_;
  std::vector<float> shares_;
  std::vector<uint8_t> blocked_;
};

/// The columns next to the seam of a panorama are far apart in pixels: what is meant is the nearer way round.
glm::vec2 unwrapped(const glm::vec2& place, const glm::vec2& near, const SeaProjection& projection) {
  if (!projection.wraps()) {
    return place;
  }
  const auto width = static_cast<float>(projection.width);
  return {place.x - width * std::round((place.x - near.x) / width), place.y};
}

/// The grid of rays over the target: at the corners of cells, and in their middles.
struct WarpGrid {
  WarpGrid(const SeaProjection& projection, int cellSize)
      : cell(cellSize),
        columns((projection.width + cellSize - 1) / cellSize),
        rows((projection.height + cellSize - 1) / cellSize),
        width(projection.width),
        height(projection.height) {
    for (int row = 0; row <= rows; ++row) {
      for (int column = 0; column <= columns; ++column) {
        pixels.emplace_back(std::min(column * cell, width), std::min(row * cell, height));
      }
    }
    firstMiddle = pixels.size();
    for (int row = 0; row < rows; ++row) {
      for (int column = 0; column < columns; ++column) {
        pixels.push_back((pixels[corner(column, row)] + pixels[corner(column + 1, row + 1)]) * 0.5f);
      }
    }
  }

  size_t corner(int column, int row) const {
    return static_cast<size_t>(row) * static_cast<size_t>(columns + 1) + static_cast<size_t>(column);
  }
  size_t middle(int column, int row) const {
    return firstMiddle + static_cast<size_t>(row) * static_cast<size_t>(columns) + static_cast<size_t>(column);
  }

  int cell;
  int columns;
  int rows;
  int width;
  int height;
  size_t firstMiddle = 0;
  std::vector<glm::vec2> pixels;
};

/// The places of a cell's corners, row by row, where these tell all of it.
struct CellCorners {
  std::array<glm::vec2, 4> places;
  bool areSmooth = false;
};

CellCorners cornersOf(const WarpGrid& grid, std::span<const Meeting> meetings, int column, int row,
                      const SeaProjection& projection) {
  CellCorners corners;
  const glm::vec2 middle = meetings[grid.middle(column, row)].place;
  // All columns meet at the poles of a panorama: corners there have no column.
  const bool touchesPole = projection.wraps() && (row == 0 || row + 1 == grid.rows);
  if (!isSeen(middle) || touchesPole) {
    return corners;
  }
  glm::vec2 mean(0);
  float farthest = 0;
  for (size_t i = 0; i < 4; ++i) {
    const size_t corner = grid.corner(column + static_cast<int>(i % 2), row + static_cast<int>(i / 2));
    if (!isSeen(meetings[corner].place)) {
      return corners;
    }
    corners.places[i] = unwrapped(meetings[corner].place, middle, projection);
    mean += corners.places[i] * 0.25f;
    farthest = std::max(farthest, std::abs(corners.places[i].x - middle.x));
  }
  const glm::vec2 bend = glm::abs(mean - middle);
  // Around a pole of the reference corners lie in all directions of their middle, which may be where that is by chance.
  constexpr float kFarthest = 1.0f / 16;
  corners.areSmooth =
      std::max(bend.x, bend.y) <= kMostBend && farthest <= kFarthest * static_cast<float>(projection.width);
  return corners;
}

void fillCell(WarpMap& map, const WarpGrid& grid, int column, int row, const CellCorners& corners) {
  const int left = column * grid.cell;
  const int top = row * grid.cell;
  const int width = std::min(grid.cell, grid.width - left);
  const int height = std::min(grid.cell, grid.height - top);
  const float perWidth = 1 / static_cast<float>(width);
  const float perHeight = 1 / static_cast<float>(height);
  for (int y = 0; y < height; ++y) {
    const float down = (static_cast<float>(y) + 0.5f) * perHeight;
    const glm::vec2 from = glm::mix(corners.places[0], corners.places[2], down);
    const glm::vec2 step = (glm::mix(corners.places[1], corners.places[3], down) - from) * perWidth;
    float* to = &map(left, top + y).x;
    for (int x = 0; x < width; ++x) {
      const float right = static_cast<float>(x) + 0.5f;
      to[2 * x] = from.x + step.x * right;
      to[2 * x + 1] = from.y + step.y * right;
    }
  }
}

/// Where the proxy bends or ends within a cell: a ray for every few pixels, and what it meets is as far away for all.
class FineCells {
 public:
  void add(const WarpGrid& grid, int column, int row) {
    const int right = std::min((column + 1) * grid.cell, grid.width);
    const int bottom = std::min((row + 1) * grid.cell, grid.height);
    for (int y = row * grid.cell; y < bottom; y += kFinest) {
      for (int x = column * grid.cell; x < right; x += kFinest) {
        const glm::ivec2 end{std::min(x + kFinest, right), std::min(y + kFinest, bottom)};
        corners_.emplace_back(x, y);
        ends_.push_back(end);
        pixels_.push_back((glm::vec2(x, y) + glm::vec2(end)) * 0.5f);
      }
    }
  }

  void fill(WarpMap& map, WarpRays& rays) {
    meetings_.resize(pixels_.size());
    rays.follow(pixels_, meetings_);
    for (size_t i = 0; i < pixels_.size(); ++i) {
      if (!isSeen(meetings_[i].place)) {
        continue;
      }
      for (int y = corners_[i].y; y < ends_[i].y; ++y) {
        for (int x = corners_[i].x; x < ends_[i].x; ++x) {
          const glm::vec2 pixel{static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f};
          map(x, y) = rays.placeOf(rays.eye() + rays.direction(pixel) * meetings_[i].distance);
        }
      }
    }
  }

 private:
  std::vector<glm::ivec2> corners_;
  std::vector<glm::ivec2> ends_;
  std::vector<glm::vec2> pixels_;
  std::vector<Meeting> meetings_;
};

}  // namespace

WarpMap makeWarpMap(const SeaProxy& proxy, const SeaProjection& projection, const SeaPose& target,
                    const SeaPose& reference, int cell) {
  WarpRays rays(proxy, projection, target, reference);
  const WarpGrid grid(projection, cell);
  std::vector<Meeting> meetings(grid.pixels.size());
  rays.follow(grid.pixels, meetings);
  WarpMap map(projection.width, projection.height, glm::vec2(kNaN));
  FineCells fine;
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      const CellCorners corners = cornersOf(grid, meetings, column, row, projection);
      if (corners.areSmooth) {
        fillCell(map, grid, column, row, corners);
      } else {
        fine.add(grid, column, row);
      }
    }
  }
  fine.fill(map, rays);
  return map;
}

}  // namespace ocelli
