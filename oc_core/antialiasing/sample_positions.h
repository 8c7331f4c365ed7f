// Where in a pixel its samples lie.
//
// Samples of a pixel form n x n strata, one sample in each, so that a renderer knows from the box around a triangle
// which it may cover. How they lie in their strata is a row of samplePlacements(). The positions of multisampling are
// those that Direct3D prescribes, and most hardware has.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <string>
#include <vector>

namespace ocelli {

/// A row: how samples lie in their strata.
struct SamplePlacement {
  const char* name;
  const char* description;
  /// The sample of column i and row k of n x n, in strata: both coordinates in [0, 1). `pattern` counts patterns.
  glm::dvec2 (*inStratum)(int i, int k, int n, uint32_t pattern);
  bool varies;                  ///< from pixel to pixel
  bool hasSlantedRows = false;  ///< SamplePattern::hasSlantedRows()
};

std::span<const SamplePlacement> samplePlacements();
/// None where there is no such name.
const SamplePlacement* findSamplePlacement(const std::string& name);

/// The samples of every pixel of an image.
class SamplePattern {
 public:
  static constexpr int kMaxSide = 64;  ///< of n: 4,096 samples a pixel

  /// n x n samples; n from 1 to kMaxSide.
  SamplePattern(int n, const SamplePlacement& placement);
  /// Those of multisampling. Only where multisamplePositions() has so many.
  static SamplePattern multisample(int samples);

  /// Columns and rows of strata a pixel. Multisampling has one row, all of whose samples lie anywhere in the pixel.
  int columns() const { return columns_; }
  int rows() const { return rows_; }
  int size() const { return columns_ * rows_; }
  /// Whether the sample of column i lies in the strip [i, i + 1) / columns of its pixel.
  bool isStratified() const { return stratified_; }
  /// Where samples lie in their strata: from the least to the greatest coordinate.
  float leastInStratum() const { return least_; }
  float greatestInStratum() const { return greatest_; }

  /// Whether the samples of row k of n lie on the line from (0, k / n) to (1, (k + 1) / n), each at the same place in
  /// its stratum: the same in every pixel.
  bool hasSlantedRows() const { return slanted_; }
  /// That place, in strata.
  float offsetOfRow(int row) const {
    return patterns_[0].u[static_cast<size_t>(row * columns_)] * static_cast<float>(columns_);
  }

  /// In the pixel, row by row, each coordinate in [0, 1).
  std::span<const float> u(int pixelX, int pixelY) const { return patternAt(pixelX, pixelY).u; }
  std::span<const float> v(int pixelX, int pixelY) const { return patternAt(pixelX, pixelY).v; }

 private:
  struct Offsets {
    std::vector<float> u;
    std::vector<float> v;
  };

  SamplePattern() = default;
  const Offsets& patternAt(int pixelX, int pixelY) const;

  int columns_ = 1;
  int rows_ = 1;
  bool stratified_ = true;
  bool slanted_ = false;
  float least_ = 0;
  float greatest_ = 1;
  std::vector<Offsets> patterns_;  ///< 1, or a power of 2 that pixels choose among
};

/// Positions from a pixel's middle in 1/16 pixel, to the right and down; none where multisampling has not so many
/// samples. Direct3D 11.3 functional specification, 19.2.4.1.
std::span<const glm::ivec2> multisamplePositions(int samples);

}  // namespace ocelli
