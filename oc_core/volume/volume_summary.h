// What a volume is, in figures: for those who ask before they look at it.
#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "oc_core/volume/volume_series.h"
#include "oc_core/volume/voxel_survey.h"

namespace ocelli {

struct VolumeSummary {
  static constexpr std::array<double, 7> kPercents{1, 5, 25, 50, 75, 95, 99};

  VolumeGrid grid;
  Box bounds;  ///< in the world of the grid
  VoxelType type = VoxelType::kUint8;
  double scale = 1;
  double offset = 0;
  VolumeFacts facts;
  std::vector<double> times;  ///< s; empty where it stands still
  size_t bytes = 0;           ///< of the voxels of one volume
  size_t bytesToRead = 0;     ///< of these: what is no hole of a sparse file
  bool isMapped = false;      ///< in a file, of which what is looked at comes into memory
  VoxelSurvey survey;
  std::array<double, kPercents.size()> percentiles{};  ///< the values that kPercents of the voxels lie below
  /// Where the volume is larger than memory, `survey` and `percentiles` are of what stands for it: this says how.
  std::string level;
  std::string preset;  ///< the transfer function that is taken unless the user says one; empty: one of its own
};

/// Of one volume of a series. Voxels may be no numbers: `survey` says so.
VolumeSummary summaryOf(const VolumeSeries& series, size_t index, const LevelOptions& level = {},
                        const Progress& progress = {});

/// Where an axis (0 for i, ...) of a grid runs to: "left", "front" or "top" of a patient and their opposites, else
/// "+x",
/// "-y" and so on; "about" before it where it is none of these to a thousandth.
std::string directionOfAxis(const VolumeGrid& grid, int axis);

}  // namespace ocelli
