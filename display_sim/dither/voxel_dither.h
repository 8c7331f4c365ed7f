// The dithers that decide on each voxel alone, chosen at run time.
#pragma once

#include "display_sim/dither/blue_noise.h"
#include "display_sim/dither/dither.h"
#include "display_sim/dither/slice_options.h"
#include "oc_core/base/check.h"

namespace ocelli {

class VoxelDither {
 public:
  /// Any but kDiffusion, which is not of this kind.
  explicit VoxelDither(ColorReduction colors)
      : colors_(colors), mask_(colors == ColorReduction::kBlueNoise ? blueNoiseMask().data() : nullptr) {
    OC_CHECK(colors != ColorReduction::kDiffusion, "error diffusion has no thresholds");
  }

  /// Strictly between 0 and 1. kOccupancy has none.
  float threshold(int slice, int column, int row) const {
    if (colors_ == ColorReduction::kDither) {
      return ditherThreshold(slice, column, row);
    }
    if (mask_ != nullptr) {
      return (static_cast<float>(mask_[blueNoisePlace(slice, column, row)]) + 0.5f) / kBlueNoiseRanks;
    }
    return 0.5f;
  }

  Rgb8 levels(const glm::vec3& color, int fullLevel, int slice, int column, int row) const {
    return colors_ == ColorReduction::kOccupancy ? occupancyLevels(color, fullLevel)
                                                 : ditheredLevels(color, fullLevel, threshold(slice, column, row));
  }

 private:
  ColorReduction colors_;
  const uint16_t* mask_;
};

}  // namespace ocelli
