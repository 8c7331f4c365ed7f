#include "display_sim/dither/diffusion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <glm/common.hpp>
#include <vector>

#include "display_sim/dither/dither.h"
#include "display_sim/frames/sweep_geometry.h"
#include "oc_core/base/check.h"

namespace ocelli {
namespace {

/// Where an error may go, seen from its voxel.
struct Offset {
  int columns;
  int rows;
  int slices;  ///< 0 or 1
};

constexpr int kRings = kDiffusionReach;
constexpr int kNone = -1;

/// In the ring at `ring` columns or rows: voxels of the same slice that come later on the path (which leads `forward`
/// to the right, else to the left), and all of the next slice's. The first ring has the next slice's voxel at the same
/// position too.
std::vector<Offset> ringOffsets(int ring, bool forward) {
  std::vector<Offset> offsets;
  for (int rows = -ring; rows <= ring; ++rows) {
    for (int columns = -ring; columns <= ring; ++columns) {
      if (std::max(std::abs(rows), std::abs(columns)) == ring) {
        offsets.push_back({columns, rows, 1});
        if (rows > 0 || (rows == 0 && (columns > 0) == forward)) {
          offsets.push_back({columns, rows, 0});
        }
      }
    }
  }
  if (ring == 1) {
    offsets.push_back({0, 0, 1});
  }
  return offsets;
}

/// The voxels of one slice, found by their position.
class SliceMap {
 public:
  explicit SliceMap(size_t positions) : indices_(positions, kNone) {}

  void fill(SliceColors* voxels) {
    if (voxels_ != nullptr) {
      for (const ColoredVoxel& voxel : *voxels_) {
        indices_[voxel.position] = kNone;
      }
    }
    voxels_ = voxels;
    if (voxels_ != nullptr) {
      for (size_t i = 0; i < voxels_->size(); ++i) {
        indices_[(*voxels_)[i].position] = static_cast<int>(i);
      }
    }
  }

  int indexAt(size_t position) const { return indices_[position]; }

 private:
  std::vector<int> indices_;
  SliceColors* voxels_ = nullptr;
};

class Diffusion {
 public:
  Diffusion(VoxelColors colors, const DisplayProfile& profile)
      : sweep_(profile),
        colors_(std::move(colors)),
        result_{Volume(profile)},
        full_(result_.volume.fullLevel()),
        maps_{SliceMap(static_cast<size_t>(profile.width) * static_cast<size_t>(profile.height)),
              SliceMap(static_cast<size_t>(profile.width) * static_cast<size_t>(profile.height))} {
    OC_CHECK(colors_.size() == static_cast<size_t>(result_.volume.slices()), "colours of another profile");
    for (int ring = 1; ring <= kRings; ++ring) {
      for (const bool forward : {false, true}) {
        offsets_[static_cast<size_t>(ring - 1)][forward ? 1 : 0] = ringOffsets(ring, forward);
      }
    }
  }

  Diffused run() {
    const int slices = result_.volume.slices();
    maps_[0].fill(&colors_[0]);
    errors_[0].assign(colors_[0].size(), glm::vec3(0));
    for (int slice = 0; slice < slices; ++slice) {
      SliceColors* next = slice + 1 < slices ? &colors_[static_cast<size_t>(slice) + 1] : nullptr;
      maps_[1].fill(next);
      errors_[1].assign(next != nullptr ? next->size() : 0, glm::vec3(0));
      decideSlice(slice);
      std::swap(maps_[0], maps_[1]);
      std::swap(errors_[0], errors_[1]);
    }
    return std::move(result_);
  }

 private:
  const SliceColors& voxels(int slice) const { return colors_[static_cast<size_t>(slice)]; }

  /// Rows from the top, the even ones to the right and the odd ones to the left.
  void decideSlice(int slice) {
    const SliceColors& all = voxels(slice);
    for (size_t first = 0; first < all.size();) {
      const int row = rowOf(all[first]);
      size_t end = first;
      while (end < all.size() && rowOf(all[end]) == row) {
        ++end;
      }
      const bool forward = row % 2 == 0;
      for (size_t i = first; i < end; ++i) {
        decide(slice, row, forward ? i : end - 1 - (i - first), forward);
      }
      first = end;
    }
  }

  int rowOf(const ColoredVoxel& voxel) const { return static_cast<int>(voxel.position) / sweep_.width(); }
  static bool takesErrors(float light) { return light > 0 && light < 1; }

  void decide(int slice, int row, size_t index, bool forward) {
    const ColoredVoxel& voxel = voxels(slice)[index];
    const int column = static_cast<int>(voxel.position) % sweep_.width();
    const float threshold = ditherThreshold(slice, column, row);
    Rgb8 levels(0);
    glm::vec3 error(0);
    for (int channel = 0; channel < kColorChannels; ++channel) {
      const float light = glm::clamp(voxel.color[channel], 0.0f, 1.0f);
      const float wanted = light * static_cast<float>(full_);
      result_.light[channel] += wanted / static_cast<double>(full_);
      if (takesErrors(light)) {
        const float withError = wanted + errors_[0][index][channel];
        const float level = std::floor(withError) + (withError - std::floor(withError) > threshold ? 1.0f : 0.0f);
        levels[channel] = static_cast<uint8_t>(glm::clamp(level, 0.0f, static_cast<float>(full_)));
        error[channel] = withError - static_cast<float>(levels[channel]);
      } else {
        levels[channel] = light > 0 ? static_cast<uint8_t>(full_) : uint8_t{0};
      }
    }
    result_.volume.raise(slice, column, row, levels);
    for (int channel = 0; channel < kColorChannels; ++channel) {
      if (error[channel] != 0) {
        passOn(slice, column, row, channel, error[channel], forward);
      }
    }
  }

  /// A neighbour that takes a share of an error.
  struct Taker {
    float* error;
    float weight;
  };

  void passOn(int slice, int column, int row, int channel, float error, bool forward) {
    for (const auto& ring : offsets_) {
      takers_.clear();
      float sum = 0;
      for (const Offset& offset : ring[forward ? 1 : 0]) {
        if (float* taker = takerAt(slice, column + offset.columns, row + offset.rows, offset.slices, channel)) {
          takers_.push_back({taker, 1 / squaredDistance(column, offset)});
          sum += takers_.back().weight;
        }
      }
      if (!takers_.empty()) {
        float rest = error;
        for (size_t i = 0; i + 1 < takers_.size(); ++i) {
          const float share = error * takers_[i].weight / sum;
          *takers_[i].error += share;
          rest -= share;
        }
        *takers_.back().error += rest;
        return;
      }
    }
    result_.leftOver[channel] += error / static_cast<double>(full_);
  }

  float* takerAt(int slice, int column, int row, int slicesOn, int channel) {
    if (column < 0 || column >= sweep_.width() || row < 0 || row >= sweep_.height()) {
      return nullptr;
    }
    const size_t position =
        static_cast<size_t>(row) * static_cast<size_t>(sweep_.width()) + static_cast<size_t>(column);
    const int index = maps_[static_cast<size_t>(slicesOn)].indexAt(position);
    if (index == kNone ||
        !takesErrors(colors_[static_cast<size_t>(slice + slicesOn)][static_cast<size_t>(index)].color[channel])) {
      return nullptr;
    }
    return &errors_[static_cast<size_t>(slicesOn)][static_cast<size_t>(index)][channel];
  }

  /// Of a voxel of this column and the one at the offset, in columns.
  float squaredDistance(int column, const Offset& offset) const {
    const double away = std::abs(column + 0.5 - sweep_.columnsPerRadius());
    const double arc = offset.slices * away * sweep_.stepRadians();
    const double up = offset.rows * sweep_.rowHeight() / sweep_.columnWidth();
    // At the axis the next slice's voxel lies at the same point: it takes almost everything.
    constexpr double kMin = 0.25;
    return static_cast<float>(std::max(offset.columns * offset.columns + up * up + arc * arc, kMin * kMin));
  }

  SweepGeometry sweep_;
  VoxelColors colors_;
  Diffused result_;
  int full_;
  std::array<SliceMap, 2> maps_;                  ///< of the slice that is being decided, and of the next
  std::array<std::vector<glm::vec3>, 2> errors_;  ///< that their voxels have got, in levels
  std::array<std::array<std::vector<Offset>, 2>, kRings> offsets_;  ///< backward, forward
  std::vector<Taker> takers_;
};

}  // namespace

Diffused diffuse(VoxelColors colors, const DisplayProfile& profile) {
  return Diffusion(std::move(colors), profile).run();
}

}  // namespace ocelli
