// Where on an area light samples lie: n rows of n, evenly in each row, and each row shifted by another share of their
// distance, so that edges along the light's sides, too, pass them one by one.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "oc_core/soft_shadows/light_frame.h"

namespace ocelli {

class LightGrid {
 public:
  static constexpr int kMaxSide = 32;

  /// `side` is a multiple of 8, up to kMaxSide.
  LightGrid(const LightFrame& frame, int side);

  int side() const { return side_; }
  /// Of row `row`: the place of its first sample, 0 to 1 of the distance between samples.
  float shift(int row) const { return shift_[static_cast<size_t>(row)]; }
  /// Samples on the light: all, but for the corners around a disc.
  int count() const { return count_; }
  bool isOnLight(int column, int row) const { return onLight_[index(column, row)] != 0; }
  /// In the frame of the light; z is 0.
  glm::vec3 point(int column, int row) const;

  /// From light coordinates on the light's plane to those of the grid: row j lies at y = j, and the samples of a row at
  /// column + shift(row) of x.
  glm::vec2 scale() const { return scale_; }
  glm::vec2 offset() const { return offset_; }

 private:
  size_t index(int column, int row) const { return static_cast<size_t>(column * side_ + row); }

  int side_;
  glm::vec2 scale_;
  glm::vec2 offset_;
  std::vector<float> shift_;
  std::vector<uint8_t> onLight_;
  int count_ = 0;
};

}  // namespace ocelli
