// Patterns that tell slices from each other: phase, wedges, stairs.
#include <cstdlib>

#include "display_driver/selftest/pattern_canvas.h"
#include "display_driver/selftest/pattern_volumes.h"

namespace ocelli {
namespace {

constexpr double kScaleInner = 0.9;      // of the ticks beside slice 0
constexpr double kLongScaleInner = 0.8;  // of the longer ones
constexpr int kScaleReach = 10;          // slices
constexpr int kScaleRows = 32;           // the scale takes 1 / 32 of the rows
constexpr double kWedgesInner = 0.2;
constexpr double kWedgesOuter = 0.9;
constexpr double kMarkInner = 0.94;
constexpr double kStairsInner = 0.6;
constexpr double kStairsOuter = 0.95;

}  // namespace

Volume phasePattern(const DisplayProfile& profile) {
  const PatternGrid grid(profile);
  const int half = profile.slicesPerHalfTurn;
  const Rgb8 first = profile.secondHalfTurn == SecondHalfTurn::kOwn ? Rgb8(grid.full(), 0, 0) : grid.white();
  const Rgb8 second(0, grid.full(), grid.full());
  const int scaleRow = grid.rows() - std::max(1, grid.rows() / kScaleRows);
  return painted(grid, [&](const PatternVoxel& v) {
    const int fromFront = grid.sectorsFrom(0, v.sector);
    const int fromBack = grid.sectorsFrom(half, v.sector);
    bool lit = fromFront == 0 || (fromBack == 0 && v.row >= grid.rows() / 2);
    // Ticks of the two sides must not meet: where there are so few slices, the scale is shorter.
    const int from = std::min(std::abs(fromFront), std::abs(fromBack));
    if (v.row >= scaleRow && from <= std::min(kScaleReach, half / 2 - 1) && from % 2 == 0) {
      lit |= grid.radiusOf(v.ring) >= (from == kScaleReach ? kLongScaleInner : kScaleInner);
    }
    return !lit ? Rgb8(0) : v.slice < half ? first : second;
  });
}

std::vector<int> wedgeWidths(const DisplayProfile& profile) {
  const int half = profile.slicesPerHalfTurn;
  std::vector<int> widths{1};
  for (int width = 2; width <= half; ++width) {
    if (half % width == 0 && width >= 3 * widths.back()) {
      widths.push_back(width);
    }
  }
  return widths;
}

Volume wedgesPattern(const DisplayProfile& profile) {
  const PatternGrid grid(profile);
  const std::vector<int> widths = wedgeWidths(profile);
  const int second = std::max(1, profile.slicesPerHalfTurn / 4);
  const int markRing = grid.ringAt(kMarkInner);
  return painted(grid, [&](const PatternVoxel& v) {
    if (v.ring >= markRing && (v.sector == 0 || (v.sector == second && v.row >= grid.rows() / 2))) {
      return grid.white();
    }
    const double across = (kWedgesOuter - grid.radiusOf(v.ring)) / (kWedgesOuter - kWedgesInner);
    if (v.row != grid.rows() / 2 || across < 0 || across >= 1) {
      return Rgb8(0);
    }
    // A ring takes five sixths of its place, so that neighbours stay apart.
    const double place = across * static_cast<double>(widths.size());
    const auto ring = static_cast<size_t>(place);
    const bool lit = place - static_cast<double>(ring) < 5.0 / 6 && v.sector / widths[ring] % 2 == 0;
    return lit ? grid.white() : Rgb8(0);
  });
}

Volume stairsPattern(const DisplayProfile& profile) {
  const PatternGrid grid(profile);
  const int inner = grid.ringAt(kStairsInner);
  const int outer = grid.ringAt(kStairsOuter);
  // All steps have as many rows, so that they have the same light.
  const int stepRows = (grid.rows() + grid.sectors() - 1) / grid.sectors();
  return painted(grid, [&](const PatternVoxel& v) {
    const int lowest = v.sector * (grid.rows() - stepRows) / (grid.sectors() - 1);
    const int height = grid.rows() - 1 - v.row;
    const bool lit = v.ring >= inner && v.ring <= outer && height >= lowest && height < lowest + stepRows;
    return lit ? grid.white() : Rgb8(0);
  });
}

}  // namespace ocelli
