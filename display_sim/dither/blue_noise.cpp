#include "display_sim/dither/blue_noise.h"

#include <cmath>

namespace ocelli {
namespace {

constexpr int kSide = kBlueNoiseSide;
constexpr int kRows = kSide * kSide;
constexpr int kReach = 5;             ///< of the Gaussian, in voxels
constexpr double kSigma = 1.5;        ///< Ulichney's, in voxels
constexpr uint32_t kPeak = 1u << 20;  ///< of the Gaussian: whole numbers add up to the same in any order

/// A pattern of points, and at every voxel the sum of the Gaussians around them.
class Pattern {
 public:
  Pattern() : set_(kBlueNoiseRanks), energy_(kBlueNoiseRanks) {
    for (int z = -kReach; z <= kReach; ++z) {
      for (int y = -kReach; y <= kReach; ++y) {
        for (int x = -kReach; x <= kReach; ++x) {
          gaussian_.push_back(
              static_cast<uint32_t>(std::lround(kPeak * std::exp(-(x * x + y * y + z * z) / (2 * kSigma * kSigma)))));
        }
      }
    }
    // Places of equal energy are taken in no regular order.
    uint32_t random = 1;
    for (uint32_t& energy : energy_) {
      random = random * 1664525u + 1013904223u;
      energy = random >> 22;
    }
  }

  bool isSet(int voxel) const { return set_[static_cast<size_t>(voxel)] != 0; }

  void set(int voxel, bool value) {
    set_[static_cast<size_t>(voxel)] = value ? 1 : 0;
    const uint32_t sign = value ? 1u : ~0u;
    const uint32_t* weight = gaussian_.data();
    for (int z = -kReach; z <= kReach; ++z) {
      for (int y = -kReach; y <= kReach; ++y) {
        const int row = wrap(voxel / kRows + z) * kSide + wrap(voxel / kSide % kSide + y);
        uint32_t* energies = &energy_[static_cast<size_t>(row) * kSide];
        for (int x = -kReach; x <= kReach; ++x) {
          energies[wrap(voxel % kSide + x)] += sign * *weight++;
        }
        // What was best stays so where it was not touched and the others became worse.
        tightest_.touch(row, voxel % kSide, value);
        emptiest_.touch(row, voxel % kSide, !value);
      }
    }
  }

  /// The set voxel that has most points around it.
  int tightestCluster() {
    return best(tightest_, true, [](uint32_t a, uint32_t b) { return a > b; });
  }
  /// The unset voxel that has fewest.
  int largestVoid() {
    return best(emptiest_, false, [](uint32_t a, uint32_t b) { return a < b; });
  }

 private:
  /// The best voxel of each row, -1 where it has none.
  struct RowBests {
    std::vector<int> voxels = std::vector<int>(kRows, -1);
    std::vector<uint8_t> stale = std::vector<uint8_t>(kRows, 1);

    void touch(int row, int column, bool othersBetter) {
      const int voxel = voxels[static_cast<size_t>(row)];
      if (othersBetter || (voxel >= 0 && wrap(voxel - column + kReach) <= 2 * kReach)) {
        stale[static_cast<size_t>(row)] = 1;
      }
    }
  };

  static int wrap(int i) { return i & (kSide - 1); }

  template <class Better>
  int best(RowBests& rows, bool set, Better&& better) {
    const auto beats = [&](int voxel, int other) {
      return other < 0 || better(energy_[static_cast<size_t>(voxel)], energy_[static_cast<size_t>(other)]);
    };
    int found = -1;
    for (int row = 0; row < kRows; ++row) {
      int& voxel = rows.voxels[static_cast<size_t>(row)];
      if (rows.stale[static_cast<size_t>(row)] != 0) {
        voxel = -1;
        for (int i = row * kSide; i < (row + 1) * kSide; ++i) {
          if (isSet(i) == set && beats(i, voxel)) {
            voxel = i;
          }
        }
        rows.stale[static_cast<size_t>(row)] = 0;
      }
      if (voxel >= 0 && beats(voxel, found)) {
        found = voxel;
      }
    }
    return found;
  }

  std::vector<uint32_t> gaussian_;
  std::vector<uint8_t> set_;
  std::vector<uint32_t> energy_;
  RowBests tightest_;
  RowBests emptiest_;
};

/// Points strewn at random, then each of the tightest cluster moved to the largest void until that changes nothing.
Pattern evenPattern(int points) {
  Pattern pattern;
  uint32_t random = 12345;
  for (int count = 0; count < points;) {
    random = random * 1664525u + 1013904223u;
    const int voxel = static_cast<int>(random >> 17) % kBlueNoiseRanks;
    if (!pattern.isSet(voxel)) {
      pattern.set(voxel, true);
      ++count;
    }
  }
  // Each move lowers the energy, but for ties; the bound is far above the moves needed.
  for (int i = 0; i < 10 * points; ++i) {
    const int from = pattern.tightestCluster();
    pattern.set(from, false);
    const int to = pattern.largestVoid();
    pattern.set(to, true);
    if (to == from) {
      break;
    }
  }
  return pattern;
}

std::vector<uint16_t> makeMask() {
  constexpr int kFirstPoints = kBlueNoiseRanks / 10;
  std::vector<uint16_t> ranks(kBlueNoiseRanks);
  const Pattern even = evenPattern(kFirstPoints);
  Pattern pattern = even;
  for (int rank = kFirstPoints - 1; rank >= 0; --rank) {
    const int voxel = pattern.tightestCluster();
    pattern.set(voxel, false);
    ranks[static_cast<size_t>(voxel)] = static_cast<uint16_t>(rank);
  }
  // With Gaussians that wrap around, the tightest cluster of unset voxels (Ulichney's third phase) is the largest void.
  pattern = even;
  for (int rank = kFirstPoints; rank < kBlueNoiseRanks; ++rank) {
    const int voxel = pattern.largestVoid();
    pattern.set(voxel, true);
    ranks[static_cast<size_t>(voxel)] = static_cast<uint16_t>(rank);
  }
  return ranks;
}

}  // namespace

const std::vector<uint16_t>& blueNoiseMask() {
  static const std::vector<uint16_t> mask = makeMask();
  return mask;
}

}  // namespace ocelli
