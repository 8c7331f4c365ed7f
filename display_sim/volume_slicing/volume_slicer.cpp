#include "display_sim/volume_slicing/volume_slicer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "display_sim/dither/blue_noise.h"
#include "display_sim/dither/diffusion.h"
#include "display_sim/dither/dither.h"
#include "display_sim/frames/volume_pool.h"
#include "oc_core/base/check.h"
#include "oc_core/base/conventions.h"
#include "oc_core/base/parallel.h"

namespace ocelli {
namespace {

constexpr uint32_t kFullSwept = uint32_t{1} << kSweptLightBits;

// The thresholds of a row: of each column in units of light, below full light. A channel is lit where its light is
// more.

struct OrderedRow {
  uint32_t start;
  OrderedRow(int slice, int row)
      : start(static_cast<uint32_t>(row) * kDitherRowStep + static_cast<uint32_t>(slice) * kDitherSliceStep) {}
  uint32_t at(int column) const {
    return (start + static_cast<uint32_t>(column) * kDitherColumnStep) >> (32 - kSweptLightBits);
  }
};

struct BlueNoiseRow {
  const uint16_t* ranks;
  BlueNoiseRow(int slice, int row) : ranks(blueNoiseMask().data() + blueNoisePlace(slice, 0, row)) {}
  uint32_t at(int column) const {
    constexpr uint32_t kRank = kFullSwept / kBlueNoiseRanks;
    return ranks[column & (kBlueNoiseSide - 1)] * kRank + kRank / 2;
  }
};

template <uint32_t kThreshold>
struct EqualRow {
  EqualRow(int, int) {}
  uint32_t at(int) const { return kThreshold; }
};
using NearestRow = EqualRow<kFullSwept / 2>;
using OccupancyRow = EqualRow<0>;

/// What is left from a threshold to full light, where lights are multiplied by 2^shift.
uint64_t restOf(uint32_t threshold, int shift) {
  const uint64_t shifted = uint64_t{threshold} << shift;
  return kFullSwept - 1 - std::min<uint64_t>(shifted, kFullSwept - 1);
}

/// The three channels of a voxel, in fields of kSweptFieldBits, in units of light multiplied by 2^shift of its column.
/// `weight` is 255 at the most.
uint64_t lightFields(SweptEntry entry, const SweptColumn& column, uint32_t weight) {
  uint32_t opacity = column.opacity[entry >> kSweptLogShift & kSweptLogMask];
  // 255 is 2^16.
  opacity = opacity * (weight * 257 + (weight >> 7)) >> 16;
  return (entry & kSweptColorMask) * opacity;
}

uint64_t lightFields(SweptEntry entry, const SweptColumn& column) {
  return (entry & kSweptColorMask) * column.opacity[entry >> kSweptLogShift & kSweptLogMask];
}

/// A slice of the display, and the sampled slice that it shows.
struct SweptTask {
  const SweptSamples& samples;
  const SweptLight& light;
  int slice;   ///< of the display
  int source;  ///< of the samples
  bool isMirrored;
};

/// The sampled slice that the sector of a slice shows, where a scene is turned.
SweptTask taskOf(const SweptSamples& samples, const SweptLight& light, int slice, int stepsTurned) {
  const int half = samples.sweep().slicesPerHalfTurn();
  const int sector = ((slice + stepsTurned) % (2 * half) + 2 * half) % (2 * half);
  return {samples, light, slice, sector % half, sector >= half};
}

/// Eight voxels of a row, from the left of the display.
struct SweptEight {
  const uint16_t* codes;
  const uint8_t* weights;  ///< nullptr where there are none
};

/// The same mirrored.
class MirroredEight {
 public:
  SweptEight of(const uint16_t* codes, const uint8_t* weights) {
    std::reverse_copy(codes, codes + kSweptBrickSide, codes_.begin());
    if (weights != nullptr) {
      std::reverse_copy(weights, weights + kSweptBrickSide, weights_.begin());
    }
    return {codes_.data(), weights != nullptr ? weights_.data() : nullptr};
  }

 private:
  std::array<uint16_t, kSweptBrickSide> codes_;
  std::array<uint8_t, kSweptBrickSide> weights_;
};

/// Calls `visit(column of the first, row, eight)` for the rows of each brick that may be lit; bricks stand at columns
/// that are multiples of eight.
template <class Visit>
void forEachSweptRow(const SweptTask& task, const Visit& visit) {
  const SweptSamples& samples = task.samples;
  const int width = samples.profile().width;
  const SweptSlice& place = samples.slices()[static_cast<size_t>(task.source)];
  const bool wholeBricks = width % kSweptBrickSide == 0;
  const SweptWeights& allWeights = samples.weights();
  if (task.isMirrored && !wholeBricks) {
    // Bricks of the mirrored slice lie between those of the screen.
    for (int row = place.firstBrickRow * kSweptBrickSide;
         row < std::min((place.firstBrickRow + place.brickRows) * kSweptBrickSide, samples.profile().height); ++row) {
      for (int column = 0; column < width; column += kSweptBrickSide) {
        std::array<uint16_t, kSweptBrickSide> codes;
        std::array<uint8_t, kSweptBrickSide> weights;
        for (int x = 0; x < kSweptBrickSide; ++x) {
          const int from = width - 1 - column - x;
          codes[static_cast<size_t>(x)] = from >= 0 ? samples.codeAt(task.source, from, row) : kNothingSwept;
          weights[static_cast<size_t>(x)] = from >= 0 ? samples.weightAt(task.source, from, row) : uint8_t{0};
        }
        visit(column, row, SweptEight{codes.data(), allWeights.areFull() ? nullptr : weights.data()});
      }
    }
    return;
  }
  const uint16_t* codes = samples.codes() + place.firstBrick * kSweptBrickVoxels;
  size_t brick = place.firstBrick;
  const SweptReach* reach = samples.reaches().data() + place.firstBrick;
  for (int brickRow = 0; brickRow < place.brickRows; ++brickRow) {
    for (int brickColumn = 0; brickColumn < place.brickColumns; ++brickColumn, ++reach, ++brick) {
      const uint16_t* brickCodes = codes;
      codes += kSweptBrickVoxels;
      if (reach->first >= reach->last || !task.light.mayBeLit(reach->first, reach->last)) {
        continue;
      }
      const uint8_t* brickWeights = allWeights.of(brick);
      const int from = (place.firstBrickColumn + brickColumn) * kSweptBrickSide;
      const int column = task.isMirrored ? width - kSweptBrickSide - from : from;
      MirroredEight mirrored;
      for (int y = 0; y < kSweptBrickSide; ++y) {
        const int row = (place.firstBrickRow + brickRow) * kSweptBrickSide + y;
        visit(column, row,
              task.isMirrored ? mirrored.of(brickCodes, brickWeights) : SweptEight{brickCodes, brickWeights});
        brickCodes += kSweptBrickSide;
        brickWeights = brickWeights != nullptr ? brickWeights + kSweptBrickSide : nullptr;
      }
    }
  }
}

/// The bits of eight voxels: of a channel's field those from kFirstEightBit on are the voxels' from the left.
constexpr int kFirstEightBit = kSweptLightBits - (kSweptBrickSide - 1);

template <bool kWeighted, bool kShifted, class DitherRow>
uint64_t litEight(const SweptEntry* entries, const SweptEight& eight, const SweptColumn* columns,
                  const DitherRow& dither, int column) {
  constexpr uint64_t kCarries = kSweptOneEach << kSweptLightBits;
  uint64_t lit = 0;
  for (int x = 0; x < kSweptBrickSide; ++x) {
    const SweptEntry entry = entries[eight.codes[x]];
    const uint64_t light =
        kWeighted ? lightFields(entry, columns[x], eight.weights[x]) : lightFields(entry, columns[x]);
    const uint32_t threshold = dither.at(column + x);
    const uint64_t rest = kShifted ? restOf(threshold, columns[x].shift) : kFullSwept - 1 - threshold;
    // The first of the eight moves down by seven bits, the last by none.
    lit = lit >> 1 | ((light + kSweptOneEach * rest) & kCarries);
  }
  return lit;
}

/// A bit for each channel.
template <class DitherRow>
void sliceOneBit(const SweptTask& task, const VolumeLayout& layout, std::span<uint8_t> planes) {
  const SweptEntry* entries = task.light.entries();
  const int height = task.samples.profile().height;
  forEachSweptRow(task, [&](int column, int row, const SweptEight& eight) {
    if (row >= height) {
      return;
    }
    const DitherRow dither(task.slice, row);
    const SweptColumn* columns = &task.light.column(column);
    const bool isShifted = task.light.isShifted(column);
    uint64_t lit = 0;
    if (eight.weights == nullptr) {
      lit = isShifted ? litEight<false, true>(entries, eight, columns, dither, column)
                      : litEight<false, false>(entries, eight, columns, dither, column);
    } else {
      lit = isShifted ? litEight<true, true>(entries, eight, columns, dither, column)
                      : litEight<true, false>(entries, eight, columns, dither, column);
    }
    const size_t at = static_cast<size_t>(row) * layout.rowBytes + static_cast<size_t>(column / kSweptBrickSide);
    for (size_t channel = 0; channel < kColorChannels; ++channel) {
      planes[channel * layout.planeBytes + at] =
          static_cast<uint8_t>(lit >> (channel * kSweptFieldBits + kFirstEightBit));
    }
  });
}

/// Levels of several bits, or full light for any.
template <class DitherRow>
void sliceLevels(const SweptTask& task, const VolumeLayout& layout, int bits, bool occupancy,
                 std::span<uint8_t> planes) {
  const SweptEntry* entries = task.light.entries();
  const int height = task.samples.profile().height;
  const auto fullLevel = static_cast<uint64_t>((1 << bits) - 1);
  forEachSweptRow(task, [&](int column, int row, const SweptEight& eight) {
    if (row >= height) {
      return;
    }
    const DitherRow dither(task.slice, row);
    const size_t at = static_cast<size_t>(row) * layout.rowBytes + static_cast<size_t>(column / kSweptBrickSide);
    for (int x = 0; x < kSweptBrickSide; ++x) {
      const SweptColumn& of = task.light.column(column + x);
      const uint64_t light =
          lightFields(entries[eight.codes[x]], of, eight.weights != nullptr ? eight.weights[x] : 255u);
      const uint64_t rest = restOf(dither.at(column + x), 0);
      for (size_t channel = 0; channel < kColorChannels; ++channel) {
        const uint64_t field = light >> (channel * kSweptFieldBits) & ((uint64_t{1} << kSweptFieldBits) - 1);
        const uint64_t level =
            occupancy ? (field > 0 ? fullLevel : 0) : ((field * fullLevel >> of.shift) + rest) >> kSweptLightBits;
        for (size_t bit = 0; bit < static_cast<size_t>(bits); ++bit) {
          planes[(channel * static_cast<size_t>(bits) + bit) * layout.planeBytes + at] |=
              static_cast<uint8_t>((level >> bit & 1) << x);
        }
      }
    }
  });
}

template <class DitherRow>
void sliceWith(const SweptTask& task, bool occupancy, Volume& volume) {
  const std::span<uint8_t> planes = volume.slice(task.slice);
  std::ranges::fill(planes, uint8_t{0});
  if (volume.bitsPerChannel() > 1) {
    sliceLevels<DitherRow>(task, volume.layout(), volume.bitsPerChannel(), occupancy, planes);
  } else {
    sliceOneBit<DitherRow>(task, volume.layout(), planes);
  }
}

void sliceInto(const SweptTask& task, ColorReduction colors, Volume& volume) {
  switch (colors) {
    case ColorReduction::kDither:
      return sliceWith<OrderedRow>(task, false, volume);
    case ColorReduction::kBlueNoise:
      return sliceWith<BlueNoiseRow>(task, false, volume);
    case ColorReduction::kNearest:
      return sliceWith<NearestRow>(task, false, volume);
    case ColorReduction::kOccupancy:
      return sliceWith<OccupancyRow>(task, true, volume);
    case ColorReduction::kDiffusion:
      break;
  }
  OC_CHECK(false, "error diffusion decides on all voxels together");
}

}  // namespace

const char* unfitForVolumes(const SliceOptions& options) {
  return options.angularAntialiasing ? "--antialias" : options.evenLightRadius > 0 ? "--even-light" : nullptr;
}

struct VolumeSlicer::Impl {
  Impl(DisplayProfile display, const SliceOptions& given)
      : profile(std::move(display)), options(given), volume(volumes.take(profile)) {}

  DisplayProfile profile;
  SliceOptions options;
  VolumePool volumes;
  std::shared_ptr<Volume> volume;
};

VolumeSlicer::VolumeSlicer(const DisplayProfile& profile, const SliceOptions& options)
    : impl_(std::make_unique<Impl>(profile, options)) {
  OC_CHECK(unfitForVolumes(options) == nullptr, "slicers of volumes have no such option");
}
VolumeSlicer::~VolumeSlicer() = default;
VolumeSlicer::VolumeSlicer(VolumeSlicer&&) noexcept = default;

const Volume& VolumeSlicer::slice(const SweptSamples& samples, const SweptLight& light, int stepsTurned) {
  OC_CHECK(samples.profile() == impl_->profile, "the volume was sampled for another display");
  if (impl_->options.colors == ColorReduction::kDiffusion) {
    *impl_->volume = diffuse(sweptColors(samples, light, stepsTurned), impl_->profile).volume;
    return *impl_->volume;
  }
  parallelFor(static_cast<size_t>(impl_->profile.storedSlices()), 1, [&](size_t begin, size_t end) {
    for (size_t slice = begin; slice < end; ++slice) {
      sliceInto(taskOf(samples, light, static_cast<int>(slice), stepsTurned), impl_->options.colors, *impl_->volume);
    }
  });
  return *impl_->volume;
}

Volume VolumeSlicer::takeVolume() {
  return std::exchange(*impl_->volume, Volume(impl_->profile));
}

std::shared_ptr<const Volume> VolumeSlicer::takeShared() {
  std::shared_ptr<const Volume> taken = std::move(impl_->volume);
  impl_->volume = impl_->volumes.take(impl_->profile);
  return taken;
}

VoxelColors sweptColors(const SweptSamples& samples, const SweptLight& light, int stepsTurned) {
  const DisplayProfile& profile = samples.profile();
  VoxelColors colors(static_cast<size_t>(profile.storedSlices()));
  parallelFor(colors.size(), 1, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      SliceColors& lit = colors[i];
      forEachSweptRow(
          taskOf(samples, light, static_cast<int>(i), stepsTurned), [&](int column, int row, const SweptEight& eight) {
            for (int x = 0; x < kSweptBrickSide; ++x) {
              if (eight.codes[x] == kNothingSwept) {
                continue;
              }
              const float weight = eight.weights != nullptr ? static_cast<float>(eight.weights[x]) / 255 : 1.0f;
              const glm::vec3 color = light.lightOf(eight.codes[x], column + x) * weight;
              if (color != glm::vec3(0)) {
                lit.push_back({static_cast<uint32_t>(row * profile.width + column + x), color});
              }
            }
          });
      std::ranges::sort(lit, {}, &ColoredVoxel::position);
    }
  });
  return colors;
}

int stepsOfAngle(const SweepGeometry& sweep, double radians) {
  return static_cast<int>(std::lround(std::remainder(radians, 2 * kPi) / sweep.stepRadians()));
}

}  // namespace ocelli
