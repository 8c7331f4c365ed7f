// One square pixel by samples that lie on slanted rows, 32 x 32 at most: which of them a triangle covers is a mask, a
// word for each row (the A-buffer, Carpenter 1984). Triangles are taken from near to far, so that what is covered is
// hidden, and the work ends where all is covered; only where the depths of two triangles overlap are their samples
// compared one by one. The image is that of PixelSamples with the same samples, but for samples within rounding of an
// edge; it takes a fraction of the time where triangles are small.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "oc_core/antialiasing/block_triangles.h"
#include "oc_core/antialiasing/sample_positions.h"

namespace ocelli {

/// Keeps its memory from pixel to pixel.
class PixelMasks {
 public:
  static constexpr int kMaxRows = 32;

  /// Whether the samples of a pattern can be masks.
  static bool take(const SamplePattern& pattern) { return pattern.hasSlantedRows() && pattern.rows() <= kMaxRows; }

  /// The mean linear colour. Reorders `seen`. Of two at the same depth, the one that stands first in the mesh
  /// wins.
  glm::vec3 mean(std::span<PixelTriangle> seen, BlockTriangles& triangles, const ImageBox& square,
                 const SamplePattern& pattern, const Mesh& mesh, const glm::vec3& background);

 private:
  static constexpr int kLanes = 4;  ///< rows at a time

  using Rows = std::array<uint32_t, kMaxRows>;

  struct Shown {  // not cleared: of its samples the rows from the first to the last are set
    const AntialiasTriangle* triangle;
    float farthest;
    int firstRow;
    int lastRow;
    Rows samples;  ///< bit i of a row: its sample i; rows beyond the first and the last are not set
  };

  void start(const ImageBox& square, const SamplePattern& pattern);
  /// Which samples the triangle covers. False where it covers none.
  bool cover(const AntialiasTriangle& triangle, Shown& shown) const;
  /// Adds the samples that `shown` has before what is covered.
  void merge(Shown& shown, const Rows* taken);
  /// Draws triangles that are sorted by depth. False where all that follows is hidden.
  bool draw(std::span<const PixelTriangle> sorted, BlockTriangles& triangles, const Mesh& mesh);
  /// Shares out the samples that both cover. `taken` gets those that `shown` takes from `other`.
  void compare(Shown& shown, Shown& other, Rows& taken) const;
  glm::vec3 weighted(const Shown& shown, const Mesh& mesh) const;
  glm::vec2 pointOf(int row, int sample) const;

  int n_ = 1;
  ImageBox square_;
  float side_ = 1;
  std::array<float, kMaxRows + kLanes> offset_{};  ///< where in its stratum a row's samples lie
  Rows covered_{};
  int fullRows_ = 0;  ///< rows that are covered
  glm::vec3 sum_{0};
  size_t openCount_ = 0;
  std::vector<Shown> open_;  ///< grows; in front those whose depths may overlap with what follows
};

}  // namespace ocelli
