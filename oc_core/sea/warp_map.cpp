#include "oc_core/sea/warp_map.h"

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <limits>
#include <span>
#include <vector>

#include "oc_core/sea/direction_table.h"
#include "oc_core/sea/near_atan.h"

namespace ocelli {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
/// A cell is drawn by its corners where its middle lies within so many pixels of where they say.
constexpr float kMaxBend = 0.125f;
constexpr int kFinest = 2;  ///< pixels that share a ray where cells are refined

/// What a ray of the target meets.
struct Meeting {
  glm::vec2 place{kNaN, kNaN};  ///< in the reference
  float distance = 0;           ///< from the target
};

/// What SeaProjection::pixel() does, by angles that are near enough.
class WarpPlaces {
 public:
  explicit WarpPlaces(const SeaProjection& projection) : projection_(projection) {}

  /// NaN where it is not seen.
  glm::vec2 operator()(const glm::vec3& direction) const {
    if (!projection_.wraps()) {
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

  SeaProjection projection_;
};

/// Of what pixels of warps are: whole ones and halves.
DirectionTable halfPixelDirections(const SeaProjection& projection) {
  return {projection, {2 * projection.width + 1, 2 * projection.height + 1, 0, 0.5f}};
}

class WarpRays {
 public:
  WarpRays(const SeaProxy& proxy, const SeaCamera& target, const SeaCamera& reference)
      : proxy_(proxy),
        target_(halfPixelDirections(target.projection)),
        reference_(reference.projection),
        eye_(target.pose.position),
        worldFromTarget_(glm::mat3_cast(target.pose.worldFromCamera)),
        referenceEye_(reference.pose.position),
        referenceFromWorld_(glm::mat3_cast(glm::inverse(reference.pose.worldFromCamera))) {}

  glm::vec3 direction(const glm::vec2& pixel) const {
    return worldFromTarget_ * target_(static_cast<int>(2 * pixel.x), static_cast<int>(2 * pixel.y));
  }

  /// Where the reference has a point, whether it sees it or not; NaN beyond its borders.
  glm::vec2 placeOf(const glm::vec3& point) const { return reference_(referenceFromWorld_ * (point - referenceEye_)); }

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
  DirectionTable target_;
  WarpPlaces reference_;
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

/// A part of the target with what the rays at its corners, row by row, and in its middle meet.
struct WarpCell {
  glm::ivec2 low;                    ///< its first pixel
  glm::ivec2 high;                   ///< the pixel behind its last one
  std::array<glm::vec2, 4> corners;  ///< places in the reference
  glm::vec2 middle;

  glm::ivec2 size() const { return high - low; }
  /// Into quarters whose corners are whole pixels.
  bool canSplit() const { return size().x > kSmallest && size().y > kSmallest && (size().x | size().y) % 2 == 0; }

 private:
  static constexpr int kSmallest = 4;
};

/// Whether corners tell all of a cell; then they are made to lie on one side of a panorama's seam.
bool isSmooth(WarpCell& cell, const SeaProjection& target, const SeaProjection& reference) {
  // All columns meet at the poles of a panorama: corners there have no column.
  const bool touchesPole = target.wraps() && (cell.low.y == 0 || cell.high.y == target.height);
  if (!isSeen(cell.middle) || touchesPole) {
    return false;
  }
  glm::vec2 mean(0);
  float farthest = 0;
  for (glm::vec2& corner : cell.corners) {
    if (!isSeen(corner)) {
      return false;
    }
    corner = unwrapped(corner, cell.middle, reference);
    mean += corner * 0.25f;
    farthest = std::max(farthest, std::abs(corner.x - cell.middle.x));
  }
  const glm::vec2 bend = glm::abs(mean - cell.middle);
  // Around a pole of the reference corners lie in all directions of their middle, which may be where that is by chance.
  constexpr float kFarthest = 1.0f / 16;
  return std::max(bend.x, bend.y) <= kMaxBend &&
         (!reference.wraps() || farthest <= kFarthest * static_cast<float>(reference.width));
}

/// `strip` begins at row `top`.
void fillCell(WarpMap& strip, int top, const WarpCell& cell) {
  const glm::ivec2 size = cell.size();
  const glm::vec2 perPixel = 1.0f / glm::vec2(size);
  for (int y = 0; y < size.y; ++y) {
    const float down = (static_cast<float>(y) + 0.5f) * perPixel.y;
    const glm::vec2 from = glm::mix(cell.corners[0], cell.corners[2], down);
    const glm::vec2 step = (glm::mix(cell.corners[1], cell.corners[3], down) - from) * perPixel.x;
    float* to = &strip(cell.low.x, cell.low.y - top + y).x;
    for (int x = 0; x < size.x; ++x) {
      const float right = static_cast<float>(x) + 0.5f;
      to[2 * x] = from.x + step.x * right;
      to[2 * x + 1] = from.y + step.y * right;
    }
  }
}

/// Makes warp maps strip by strip: a row of cells, each of which is split where the proxy bends or ends within it.
class WarpStrips {
 public:
  WarpStrips(const SeaProxy& proxy, const SeaCamera& target, const SeaCamera& reference, int cell)
      : target_(target.projection), reference_(reference.projection), rays_(proxy, target, reference), cell_(cell) {
    columns_ = (target_.width + cell - 1) / cell;
    follow(rowOfCorners(0), below_);
  }

  /// The rows from `top` on, which is a multiple of the cell; each row once, from the first one down.
  void draw(int top, WarpMap& strip) {
    std::fill(strip.begin(), strip.end(), glm::vec2(kNaN));
    cells_.clear();
    fine_.clear();
    addRow(top);
    while (!cells_.empty()) {
      split_.clear();
      for (WarpCell& cell : cells_) {
        if (isSmooth(cell, target_, reference_)) {
          fillCell(strip, top, cell);
        } else if (cell.canSplit()) {
          split_.push_back(cell);
        } else {
          fine_.push_back(cell);
        }
      }
      splitCells();
    }
    fillFine(strip, top);
  }

 private:
  int columnAt(int column) const { return std::min(column * cell_, target_.width); }

  std::vector<glm::vec2> rowOfCorners(int y) const {
    std::vector<glm::vec2> pixels;
    for (int column = 0; column <= columns_; ++column) {
      pixels.emplace_back(columnAt(column), y);
    }
    return pixels;
  }

  void follow(std::span<const glm::vec2> pixels, std::vector<Meeting>& meetings) {
    meetings.resize(pixels.size());
    rays_.follow(pixels, meetings);
  }

  void addRow(int top) {
    const int bottom = std::min(top + cell_, target_.height);
    above_.swap(below_);
    follow(rowOfCorners(bottom), below_);
    pixels_.clear();
    for (int column = 0; column < columns_; ++column) {
      pixels_.push_back(glm::vec2(columnAt(column) + columnAt(column + 1), top + bottom) * 0.5f);
    }
    follow(pixels_, meetings_);
    for (size_t column = 0; column < static_cast<size_t>(columns_); ++column) {
      const auto number = static_cast<int>(column);
      cells_.push_back(
          {{columnAt(number), top},
           {columnAt(number + 1), bottom},
           {above_[column].place, above_[column + 1].place, below_[column].place, below_[column + 1].place},
           meetings_[column].place});
    }
  }

  /// cells_ becomes the quarters of split_.
  void splitCells() {
    constexpr size_t kEach = 8;  ///< rays: the middles of the sides (above, left, right, below), and of the quarters
    pixels_.clear();
    for (const WarpCell& cell : split_) {
      const glm::vec2 low(cell.low);
      const glm::vec2 size(cell.size());
      for (const glm::vec2& at : {glm::vec2(0.5f, 0),
                                  {0, 0.5f},
                                  {1, 0.5f},
                                  {0.5f, 1},
                                  {0.25f, 0.25f},
                                  {0.75f, 0.25f},
                                  {0.25f, 0.75f},
                                  {0.75f, 0.75f}}) {
        pixels_.push_back(low + at * size);
      }
    }
    follow(pixels_, meetings_);
    cells_.clear();
    for (size_t i = 0; i < split_.size(); ++i) {
      const WarpCell& cell = split_[i];
      const auto at = [&](size_t ray) { return meetings_[kEach * i + ray].place; };
      const glm::ivec2 half = cell.size() / 2;
      const glm::ivec2 middle = cell.low + half;
      const auto& [first, second, third, fourth] = cell.corners;
      cells_.push_back({cell.low, middle, {first, at(0), at(1), cell.middle}, at(4)});
      cells_.push_back({{middle.x, cell.low.y}, {cell.high.x, middle.y}, {at(0), second, cell.middle, at(2)}, at(5)});
      cells_.push_back({{cell.low.x, middle.y}, {middle.x, cell.high.y}, {at(1), cell.middle, third, at(3)}, at(6)});
      cells_.push_back({middle, cell.high, {cell.middle, at(2), at(3), fourth}, at(7)});
    }
  }

  /// A ray for every few pixels, and what it meets is as far away for all of these.
  void fillFine(WarpMap& strip, int top) {
    corners_.clear();
    ends_.clear();
    pixels_.clear();
    for (const WarpCell& cell : fine_) {
      for (int y = cell.low.y; y < cell.high.y; y += kFinest) {
        for (int x = cell.low.x; x < cell.high.x; x += kFinest) {
          corners_.emplace_back(x, y);
          ends_.push_back(glm::min(glm::ivec2(x, y) + kFinest, cell.high));
          pixels_.push_back(glm::vec2(corners_.back() + ends_.back()) * 0.5f);
        }
      }
    }
    follow(pixels_, meetings_);
    for (size_t i = 0; i < pixels_.size(); ++i) {
      if (!isSeen(meetings_[i].place)) {
        continue;
      }
      for (int y = corners_[i].y; y < ends_[i].y; ++y) {
        for (int x = corners_[i].x; x < ends_[i].x; ++x) {
          const glm::vec2 pixel{static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f};
          strip(x, y - top) = rays_.placeOf(rays_.eye() + rays_.direction(pixel) * meetings_[i].distance);
        }
      }
    }
  }

  SeaProjection target_;
  SeaProjection reference_;
  WarpRays rays_;
  int cell_;
  int columns_ = 0;
  std::vector<Meeting> above_;  ///< at the corners of the row of cells
  std::vector<Meeting> below_;
  // What is kept from strip to strip, so that its memory is.
  std::vector<WarpCell> cells_;
  std::vector<WarpCell> split_;
  std::vector<WarpCell> fine_;
  std::vector<glm::ivec2> corners_;
  std::vector<glm::ivec2> ends_;
  std::vector<glm::vec2> pixels_;
  std::vector<Meeting> meetings_;
};

}  // namespace

void forEachWarpStrip(const SeaProxy& proxy, const SeaCamera& target, const SeaCamera& reference, int cell,
                      const std::function<void(int top, const WarpMap& strip)>& visit) {
  WarpStrips strips(proxy, target, reference, cell);
  const int height = target.projection.height;
  WarpMap strip(target.projection.width, std::min(cell, height));
  for (int top = 0; top < height; top += cell) {
    if (top + cell > height) {
      strip = WarpMap(target.projection.width, height - top);
    }
    strips.draw(top, strip);
    visit(top, strip);
  }
}

WarpMap makeWarpMap(const SeaProxy& proxy, const SeaCamera& target, const SeaCamera& reference, int cell) {
  WarpMap map(target.projection.width, target.projection.height);
  forEachWarpStrip(proxy, target, reference, cell, [&](int top, const WarpMap& strip) {
    std::copy(strip.begin(), strip.end(), map.begin() + static_cast<ptrdiff_t>(map.index(0, top)));
  });
  return map;
}

}  // namespace ocelli
