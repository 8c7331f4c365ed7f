// How a feed sees a body at a place: which cells of its mask the body is likely to fill. The outline is that of
// somebody who stands or walks in any direction, from head to feet.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "oc_core/feeds/feed_setup.h"

namespace ocelli {

/// The outline of a body at one height: how likely it fills points beside its axis.
struct BodyOutline {
  float share = 0;  ///< how likely it fills its middle
  float sure = 0;   ///< metres beside the axis within which it is as likely,
  float none = 0;   ///< and beyond which it is not

  float shareAt(float beside) const {
    return share * std::clamp((none - std::abs(beside)) / (none - sure), 0.0f, 1.0f);
  }
};

/// `height` is a share of the body's, 0 at the floor and 1 at the top of the head.
BodyOutline bodyOutline(float height);

constexpr float kBodyReach = 0.45f;  ///< metres beside the axis, beyond which no body is

class BodyView {
 public:
  /// One row of the mask.
  struct Row {
    float axis = 0;           ///< the middle of the body, in cells
    float metresPerCell = 0;  ///< at the distance of the body
    float height = 0;         ///< of the row, as a share of the body's height
    BodyOutline outline;
  };

  /// `height` is that of the body in metres, `mask` the size of the mask and `scale` that of its cells in feed pixels.
  /// Nothing where the feed does not see it.
  static std::optional<BodyView> of(const Feed& feed, const glm::dvec3& place, double height, const glm::ivec2& mask,
                                    int scale);

  double distance() const { return distance_; }  ///< metres from the camera
  /// Rows of the mask: from the first to before the last.
  int firstRow() const { return first_; }
  int lastRow() const { return first_ + static_cast<int>(rows_.size()); }
  const Row& row(int y) const { return rows_[static_cast<size_t>(y - first_)]; }
  /// Columns that a body may fill in a row: from the first to before the last, in the mask.
  glm::ivec2 columns(int y) const;
  /// Metres beside the axis.
  static float beside(const Row& row, int x) { return (static_cast<float>(x) + 0.5f - row.axis) * row.metresPerCell; }
  /// Whether the rows of the feet, or of the head, are in the mask.
  bool hasFeet() const { return hasFeet_; }
  bool hasHead() const { return hasHead_; }

 private:
  double distance_ = 0;
  int width_ = 0;
  int first_ = 0;
  std::vector<Row> rows_;
  bool hasFeet_ = false;
  bool hasHead_ = false;
};

}  // namespace ocelli
