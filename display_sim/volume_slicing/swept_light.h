// The light that a voxel of the display gives for the part of a volume that it covers.
//
// The display emits and absorbs nothing, so what an eye sees along a line is the sum of what the voxels give there. A
// volume of the colour c and the extinction e (transfer_function.h) emits c e for each length. The screen sweeps a cell
// of the width a, the height b and, at the distance r from the axis, the thickness
//
//     d(r) = 2 r tan(step / 2),      a b d the cell's volume,
//
// and the voxel gives
//
//     light = C (1 - exp(-E d(r))),      E the mean of e in the cell, C the mean of c, weighed with e.
//
// This is the opacity of the cell's thickness, in its colour: where the cell is thin it is C E d, the light that the
// matter in it emits, and it never exceeds C. As cells become thinner and denser towards the axis, each gives less in
// the same measure: a medium that is the same everywhere looks as bright near the axis as far from it.
//
// A surface at a value has no thickness to emit: the voxels that hold it give its colour, and their neighbours the
// smooth step (3 - 2 s) s^2 of s = 1 - |m - value| / (2 h), with the mean m of a cell and the half spread h of its
// values (swept_code.h). Over cells one behind the other, 2 h apart in value, that sums to one voxel's light. Like the
// surfaces of meshes, it is brighter near the axis.
//
// As both depend on a voxel's code and its column alone, they are tables, made anew when the transfer function moves;
// what is kept for each voxel of the display is not.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "display_sim/frames/sweep_geometry.h"
#include "display_sim/volume_slicing/swept_code.h"
#include "oc_core/volume/scalar_volume.h"
#include "oc_core/volume/transfer_function.h"

namespace ocelli {

/// By code: the colour, in 1/256, in three fields of 21 bits, and between the first two fields the logarithm of the
/// extinction: kSweptLogSteps to the octave, counted from 2^-kSweptLogOctaves; 0 where there is no light.
using SweptEntry = uint64_t;
inline constexpr int kSweptFieldBits = 21;
inline constexpr uint64_t kSweptOneEach = 1 | uint64_t{1} << kSweptFieldBits | uint64_t{1} << (2 * kSweptFieldBits);
inline constexpr int kSweptColorBits = 8;  ///< the ninth is that of full light
inline constexpr uint64_t kSweptColorMask = kSweptOneEach * 0x1ff;
inline constexpr int kSweptLogShift = kSweptColorBits + 1;
inline constexpr int kSweptLogMask = 0xfff;
inline constexpr int kSweptLogSteps = 64;
inline constexpr int kSweptLogOctaves = 32;
/// The opacity of a thickness, in 2^-kSweptOpacityBits: the product of colour and opacity is the light, in 2^-20.
inline constexpr int kSweptOpacityBits = 12;
inline constexpr int kSweptLightBits = kSweptColorBits + kSweptOpacityBits;
static_assert(kSweptLightBits + 1 == kSweptFieldBits, "full light and a rest fit into a field");

/// What a column does to its voxels.
struct SweptColumn {
  const uint16_t* opacity;  ///< by the logarithm of the extinction
  int shift;                ///< opacities of this column are multiplied by 2^shift, to keep their digits
};

struct SweptLightOptions {
  /// What the extinction is multiplied by: the light of what is thin.
  double gain = 1;
  /// Values outside of this range give no light.
  std::optional<ValueRange> shown = std::nullopt;
};

class SweptLight {
 public:
  /// For a display's sweep and volumes whose values have this range. `sceneLengthOfUnit` is that of the VolumeScene.
  SweptLight(const TransferFunction& transfer, const ValueRange& range, double sceneLengthOfUnit,
             const SweepGeometry& sweep, const SweptLightOptions& options = {});
  /// The surface at a value.
  static SweptLight ofSurface(double value, const glm::dvec3& color, const ValueRange& range,
                              const SweepGeometry& sweep);

  const SweptEntry* entries() const { return entries_.data(); }
  const SweptColumn& column(int column) const { return columns_[static_cast<size_t>(column)]; }
  /// Whether one of the eight columns from a multiple of eight on is shifted. Far from the axis none is.
  bool isShifted(int firstColumn) const { return shifted_[static_cast<size_t>(firstColumn) / 8] != 0; }

  /// Whether codes whose reach (sweptReach()) lies in [first, last], in steps of the mean, first < last, may give
  /// light.
  bool mayBeLit(int first, int last) const {
    return litSteps_[static_cast<size_t>(last)] > litSteps_[static_cast<size_t>(first)];
  }

  /// Of one voxel, as the slicer has it before a dither decides: for what is slow, and for tests.
  glm::vec3 lightOf(uint16_t code, int column) const;

 private:
  SweptLight() : entries_(kSweptCodes, 0) {}
  void addColumn(const SweptColumn& column);

  std::vector<SweptEntry> entries_;
  std::vector<SweptColumn> columns_;         ///< a multiple of eight
  std::vector<char> shifted_;                ///< by eight columns
  std::array<int, kSweptMeans> litSteps_{};  ///< how many of the segments between the steps before each may be lit
};

/// How far from its mean, in steps of the mean, a surface may lie that a code's voxel shows light of.
inline float sweptReach(float halfSpread) {
  return std::max(2 * halfSpread * (kSweptMeans - 1), 1.0f);
}

/// The thickness of a column's cells, in display radii: d(r) above; of a column that holds the axis, their volume for
/// the area of the screen.
double sweptThickness(const SweepGeometry& sweep, int column);

}  // namespace ocelli
