// Patterns of light and sharpness: dark, white, colours, brightness, focus.
#include <array>

#include "display_driver/selftest/pattern_canvas.h"
#include "display_driver/selftest/pattern_volumes.h"
#include "oc_core/base/conventions.h"

namespace ocelli {
namespace {

constexpr double kDrumInner = 0.7;  // one ring of voxels
constexpr double kFinInner = 0.85;
constexpr double kNotchSide = 0.04;  // half of its width
constexpr double kNotchStep = 0.16;
constexpr int kMaxColourSteps = 8;
/// Bit 0 red, bit 1 green, bit 2 blue.
constexpr std::array<unsigned, 7> kBands{1, 2, 4, 6, 5, 3, 7};

constexpr int kBrightnessRings = 10;
constexpr double kOutermostRing = 0.95;
constexpr double kConeTop = 0.9;  // of half the height
constexpr double kConeBottom = 0.1;

constexpr int kTargets = 3;           // along the radius, and along the height
constexpr double kTargetShare = 0.7;  // of the place that a target has
constexpr double kFanHeight = 0.94;   // of half the height

/// Slabs through the drum, seen from the front and from the side: the same light is cut from its near and its far wall.
bool isNotched(unsigned channels, double x, double z) {
  const int notches = channels == 1 ? 1 : channels == 2 ? 2 : channels == 4 ? 3 : 0;
  for (int i = 0; i < notches; ++i) {
    const double at = (i - (notches - 1) / 2.0) * kNotchStep;
    if (std::abs(x - at) <= kNotchSide || std::abs(z - at) <= kNotchSide) {
      return true;
    }
  }
  return false;
}

/// Where in its place a target's line pattern has a voxel lit: `x` and `y` from its corner, of `width` by `height`.
bool isTargetLit(int x, int y, int width, int height) {
  const int pair = 2 * y < height ? 1 : 2;
  return (2 * x < width ? x : y) / pair % 2 == 0;
}

/// One of so many equal places along `count`, cut down to the share that its target takes; index -1 beside it.
struct TargetPlace {
  int index = -1;
  int size = 0;
};
TargetPlace targetPlace(int at, int count) {
  const int place = count / kTargets;
  if (place < 4 || at / place >= kTargets) {
    return {};
  }
  const int size = std::max(4, static_cast<int>(kTargetShare * place));
  const int inside = at % place - (place - size) / 2;
  return inside >= 0 && inside < size ? TargetPlace{inside, size} : TargetPlace{};
}

}  // namespace

Volume darkPattern(const DisplayProfile& profile) {
  return Volume(profile);
}

Volume whitePattern(const DisplayProfile& profile) {
  const PatternGrid grid(profile);
  return painted(grid, [&](const PatternVoxel&) { return grid.white(); });
}

std::vector<int> colourSteps(const DisplayProfile& profile) {
  const int full = (1 << profile.colorBitsPerChannel) - 1;
  const int steps = std::min(full, kMaxColourSteps);
  std::vector<int> levels;
  for (int i = 0; i < steps; ++i) {
    levels.push_back((full * (steps - i) + steps / 2) / steps);
  }
  return levels;
}

Volume coloursPattern(const DisplayProfile& profile) {
  const PatternGrid grid(profile);
  const std::vector<int> steps = colourSteps(profile);
  const auto bands = static_cast<int>(kBands.size());
  const auto stepCount = static_cast<int>(steps.size());
  const int drum = grid.ringAt(kDrumInner);
  const int fin = grid.ringAt(kFinInner);
  return painted(grid, [&](const PatternVoxel& v) {
    const int band = v.row * bands / grid.rows();
    if (v.ring >= fin && band == bands - 1) {
      // Between the notches, seen from any of the four sides.
      for (int i = 1; i < 16; i += 2) {
        if (v.sector == grid.sectors() * i / 16) {
          return grid.white();
        }
      }
    }
    const int bandTop = (band * grid.rows() + bands - 1) / bands;
    const int bandRows = ((band + 1) * grid.rows() + bands - 1) / bands - bandTop;
    // The last row of a band is dark, so that neighbours stay apart.
    const int litRows = std::max(1, bandRows - std::max(1, bandRows / 8));
    const int row = v.row - bandTop;
    const unsigned channels = kBands[static_cast<size_t>(band)];
    const glm::dvec3 p = grid.geometry().voxelCenter(v.slice, v.column, v.row);
    if (v.ring != drum || row >= litRows || isNotched(channels, p.x, p.z)) {
      return Rgb8(0);
    }
    const auto level = static_cast<uint8_t>(steps[static_cast<size_t>(row * stepCount / litRows)]);
    return Rgb8((channels & 1u) != 0 ? level : 0, (channels & 2u) != 0 ? level : 0, (channels & 4u) != 0 ? level : 0);
  });
}

std::vector<BrightnessRing> brightnessRings(const DisplayProfile& profile) {
  const PatternGrid grid(profile);
  std::vector<BrightnessRing> rings;
  for (int i = 1; i <= kBrightnessRings; ++i) {
    const double out = i / static_cast<double>(kBrightnessRings);
    const double height = profile.halfHeightRadii * (kConeTop + (kConeBottom - kConeTop) * out);
    const int row = grid.rowAt(height);
    rings.push_back({grid.ringAt(kOutermostRing * out), row, grid.rows() - 1 - row});
  }
  return rings;
}

Volume brightnessPattern(const DisplayProfile& profile) {
  const PatternGrid grid(profile);
  const std::vector<BrightnessRing> rings = brightnessRings(profile);
  const double outermost = grid.radiusOf(rings.back().ring);
  return painted(grid, [&](const PatternVoxel& v) {
    for (const BrightnessRing& ring : rings) {
      if (v.ring != ring.ring) {
        continue;
      }
      const double share = grid.radiusOf(v.ring) / outermost;
      const bool chosen = std::floor((v.sector + 1) * share) > std::floor(v.sector * share);
      if (v.row == ring.upperRow || (v.row == ring.lowerRow && chosen)) {
        return grid.white();
      }
    }
    return Rgb8(0);
  });
}

Volume focusPattern(const DisplayProfile& profile) {
  const PatternGrid grid(profile);
  const int quarter = grid.sectors() / 4;
  const int fanRow = grid.rowAt(kFanHeight * profile.halfHeightRadii);
  return painted(grid, [&](const PatternVoxel& v) {
    const TargetPlace out = targetPlace(v.ring, grid.rings());
    bool lit = (v.row == fanRow || v.row == grid.rows() - 1 - fanRow) && out.index >= 0 && v.sector % 2 == 0;
    if (v.sector % quarter == 0 && v.sector / quarter < 4) {
      const TargetPlace down = targetPlace(v.row, grid.rows());
      lit |= out.index >= 0 && down.index >= 0 && isTargetLit(out.index, down.index, out.size, down.size);
    }
    return lit ? grid.white() : Rgb8(0);
  });
}

}  // namespace ocelli
