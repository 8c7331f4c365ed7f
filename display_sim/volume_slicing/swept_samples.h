// A volume as the voxels of a display cover it: what does not change when its transfer function moves.
//
// Each cell of the sweep (display_sim/frames/sweep_geometry.h) that the volume's box covers some of keeps the mean and
// the spread of the field in it (swept_code.h), and gives its light by the covered share. A cell is a thin wedge:
// columns and rows are as wide everywhere, and the thickness grows from 0 at the axis. So it is sampled by points
// spread evenly over it, as many in each direction as the volume has voxels there, and two at least across it where it
// is thicker than wide; a volume that is finer than 1.5 voxels a column is made coarser first, by averages
// (volume_levels.h). What the points miss of the spread follows from the differences to the neighbours in the slice.
// The spread within what was averaged is lost: such a volume is classified as a coarser scan would be.
//
// Slices of one half turn stand for all: those of a second half turn are the same, seen from behind. So a volume turns
// with the screen by whole steps of the sweep, without being sampled anew (VolumeSlicer).
//
// In memory: for each slice, the bricks of 8 rows and 8 columns that hold some of the volume, rows of bricks from the
// top, each from left to right; the 64 codes of a brick row by row. Two bytes for each voxel of the display, and one
// for its weight in bricks that have weights (swept_weights.h), however large the volume is.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "display_sim/frames/display_profile.h"
#include "display_sim/frames/sweep_geometry.h"
#include "display_sim/volume_slicing/swept_code.h"
#include "display_sim/volume_slicing/swept_weights.h"
#include "oc_core/base/progress.h"
#include "oc_core/volume/scalar_volume.h"
#include "oc_core/volume/volume_scene.h"

namespace ocelli {

/// The bricks of a slice that hold some of the volume: those of a rectangle.
struct SweptSlice {
  int firstBrickColumn = 0;
  int firstBrickRow = 0;
  int brickColumns = 0;
  int brickRows = 0;
  size_t firstBrick = 0;  ///< of the rectangle, among those of all slices
};

/// Between which steps of the mean the reach (swept_light.h) of a brick's codes lies; none where the first is greater.
struct SweptReach {
  uint16_t first = kSweptMeans - 1;
  uint16_t last = 0;
};

struct SweptSampling {
  /// Weigh each voxel's light by the shade of the field's gradient, as `shading` says: the ambient part and the diffuse
  /// one, for light from both sides. Specular light depends on the eye, and is left out.
  bool shaded = true;
  /// Weigh it by how much the field changes, too: full light where it changes by this share of range() over
  /// one of its voxels, and less in proportion. 0: not at all.
  double fullLightGradient = 0;
  /// Values that codes have to tell apart, besides what is common in the volume and where its transfer function
  /// changes (swept_range.h): of a surface, of a mask, of transfer functions that come later.
  std::vector<double> toldApart{};
};

/// Whether two ways to light a volume give a display the same light: highlights, which depend on the eye, are left out.
bool isSameOnDisplay(const VolumeShading& a, const VolumeShading& b);

class SweptSamples {
 public:
  /// Of the volume of a scene alone: neither its surfaces nor its clips. `scene` is in display radii. The same with any
  /// number of threads.
  SweptSamples(const VolumeScene& scene, const DisplayProfile& profile, const SweptSampling& sampling = {},
               const Progress& progress = {});

  const DisplayProfile& profile() const { return profile_; }
  const SweepGeometry& sweep() const { return sweep_; }
  /// Of the values that codes tell apart (swept_range.h); codes are shares of it. What lies beyond counts as its end.
  const ValueRange& range() const { return range_; }
  /// Of the values that most voxels have: how many steps of the mean tell them apart.
  double commonSteps() const { return commonSteps_; }
  double sceneLengthOfUnit() const { return sceneLengthOfUnit_; }

  /// Of a half turn.
  const std::vector<SweptSlice>& slices() const { return slices_; }
  size_t bricks() const { return reaches_.size(); }
  const uint16_t* codes() const { return codes_.data(); }  ///< of the first brick; the others follow
  const SweptWeights& weights() const { return hasPart_ ? weights_ : sampledWeights_; }
  const std::vector<SweptReach>& reaches() const { return reaches_; }
  size_t bytes() const;

  /// Of a voxel of a slice of the half turn: kNothingSwept where there is no brick.
  uint16_t codeAt(int slice, int column, int row) const;
  uint8_t weightAt(int slice, int column, int row) const;

  /// The weight of each voxel is multiplied by what `part` says of its cell, from 0 to 1: its centre, and the longest
  /// side of the cell. May be called again: the weights of the sampling are kept. Empty: those alone. `part` is called
  /// by several threads.
  using Part = std::function<double(const glm::dvec3& center, double cellSide)>;
  void setPart(const Part& part, const Progress& progress = {});

 private:
  std::optional<size_t> placeOf(int slice, int column, int row) const;

  DisplayProfile profile_;
  SweepGeometry sweep_;
  ValueRange range_;
  double commonSteps_ = 0;
  double sceneLengthOfUnit_ = 1;
  std::vector<SweptSlice> slices_;
  std::vector<uint16_t> codes_;
  SweptWeights sampledWeights_;
  SweptWeights weights_;  ///< with what setPart() was told
  bool hasPart_ = false;
  std::vector<SweptReach> reaches_;
};

}  // namespace ocelli
