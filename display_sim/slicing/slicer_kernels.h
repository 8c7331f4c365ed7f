// The inner loops of the fast slicer, compiled for several instruction sets; the CPU's best one is taken when the
// program runs. All give the same bits: nothing is fused, and what is used rounds as IEEE 754 says.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "display_sim/dither/slice_options.h"
#include "display_sim/frames/sweep_geometry.h"
#include "display_sim/slicing/triangle_strips.h"

namespace ocelli {

/// Numbers of a sweep and its dither, as the loops need them.
struct SliceKernelSetup {
  SliceKernelSetup(const DisplayProfile& profile, const SliceOptions& options);

  float stepsPerRadian;
  float sectors;
  int32_t sectorCount;
  int32_t slicesPerHalfTurn;
  float radiansPerStep;
  float columnsPerRadius;
  float axisOffset;  ///< from the axis to the left side of the column that holds it, or begins at it
  float columnsOutwards;
  int32_t lastColumn;
  int32_t axisColumn;
  float rowsPerUnit;
  float rowOfCenter;
  float rows;
  int32_t lastRow;
  int32_t paddedColumns;
  int32_t fullLevel;
  bool occupancy;             ///< full light wherever there is any
  bool ordered;               ///< with the thresholds of dither.h; otherwise with those of `mask`
  std::vector<int32_t> mask;  ///< in kLightSteps, laid out as blueNoiseMask(); none: the middle everywhere
  bool oneBit;
  bool antialiased;
  bool ownSecondHalf;
  int32_t noSlice;  ///< stands for the slice of a sample that lights nothing
};

/// Where a point lies in the sweep, in 1/65536: sectors, columns from the axis, rows. `special` is kSpecial for points
/// outside of the display or next to the axis, else 0.
struct SweepPoint {
  int32_t sector;
  int32_t column;
  int32_t row;
  int32_t special;
};
inline constexpr int32_t kSweepUnit = 1 << 16;
inline constexpr int32_t kSpecial = 1 << 30;

/// Points with their light, as SliceMesh stores them; no light means white. Arrays can be read SliceMesh::kPadding
/// elements beyond their end.
struct SliceSamples {
  const float* x = nullptr;
  const float* y = nullptr;
  const float* z = nullptr;
  const float* red = nullptr;
  const float* green = nullptr;
  const float* blue = nullptr;
  size_t count = 0;
};

/// What samples light (each at most four voxels): slices, positions (packed_voxel_bins.h) and levels. Where levels have
/// one bit, `position` holds the whole voxel and `levels` nothing.
struct LitSamples {
  /// Room for what `samples` samples light.
  explicit LitSamples(size_t samples);
  size_t count = 0;
  std::vector<uint32_t> slice;
  std::vector<uint32_t> position;
  std::vector<uint32_t> levels;
};

/// The sectors of points, first to last; in [0, 2N), or in [-N, N) where fewer lie between. On the axis there is no
/// sector.
struct SectorReach {
  int first = 0;
  int last = 0;
  bool onAxis = false;
};

/// Finds the voxels that samples light. Fills `points`, too, where it is not null; it has room for `samples.count`
/// rounded up to SliceMesh::kPadding.
SectorReach lightSamples(const SliceKernelSetup& setup, const SliceSamples& samples, SweepPoint* points,
                         LitSamples& lit);

/// Samples that are written, with SliceMesh::kPadding elements of room more than `capacity`.
struct SampleRoom {
  explicit SampleRoom(size_t capacity);
  SliceSamples samples(bool white) const;

  size_t capacity;
  size_t count = 0;
  std::vector<float> x;
  std::vector<float> y;
  std::vector<float> z;
  std::vector<float> red;
  std::vector<float> green;
  std::vector<float> blue;
};

/// Appends the samples of as many triangles as the room holds; returns how many triangles these are. `mesh` holds
/// the vertices.
size_t sampleTriangles(const SliceSamples& mesh, const TriangleStrips& strips, const SampledTriangle* triangles,
                       size_t count, SampleRoom& room);

/// Writes these bytes of the bit planes of a slice (volume.h), and makes their levels 0 again. `levels` has a word for
/// each voxel, 8 bits a channel.
void writePlanes(uint32_t* levels, std::span<const uint32_t> bytes, int bitsPerChannel, uint8_t* planes,
                 size_t planeBytes);

}  // namespace ocelli
