#include "oc_core/walkable/walk_areas.h"

#include <algorithm>
#include <numeric>

#include "oc_core/base/disjoint_sets.h"

namespace ocelli {
namespace {

constexpr double kThinShare = 0.35;

}  // namespace

WalkAreas areasOf(const WalkField& field, const std::vector<uint16_t>& halfWidths, int radius, size_t smallest) {
  const WalkPieces levels = connectedPieces(field, std::vector<uint32_t>(halfWidths.begin(), halfWidths.end()));
  std::vector<uint16_t> width(levels.count, 0);
  for (size_t i = 0; i < halfWidths.size(); ++i) {
    width[levels.of[i]] = halfWidths[i];
  }
  std::vector<std::vector<uint32_t>> around(levels.count);
  for (const PieceBorder& border : bordersOf(field, levels.of)) {
    around[border.a].push_back(border.b);
    around[border.b].push_back(border.a);
  }
  std::vector<uint32_t> order(levels.count);
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) { return width[a] > width[b]; });

  DisjointSets areas(levels.count);
  std::vector<uint16_t> widest = width;  // of the area, at its least()
  for (const uint32_t level : order) {
    for (const uint32_t other : around[level]) {
      const uint32_t area = areas.least(other);
      const uint32_t mine = areas.least(level);
      if (width[other] > width[level] && area != mine && width[level] >= kSameWidth * widest[area]) {
        const uint16_t most = std::max(widest[area], widest[mine]);
        areas.join(area, mine);
        widest[areas.least(mine)] = most;
      }
    }
  }
  std::vector<uint32_t> labels = levels.of;
  for (uint32_t& label : labels) {
    label = areas.least(label);
  }
  const WalkPieces raw = connectedPieces(field, labels);
  std::vector<uint16_t> rawWidth(raw.count, 0);
  for (size_t i = 0; i < labels.size(); ++i) {
    rawWidth[raw.of[i]] = widest[labels[i]];
  }
  const std::vector<uint16_t> thickness = thicknesses(field, raw);
  const std::vector<size_t> sizes = standingSizes(field, raw);
  std::vector<uint8_t> isThin(raw.count, 0);
  for (uint32_t area = 0; area < raw.count; ++area) {
    isThin[area] =
        sizes[area] < smallest || thickness[area] <= radius || thickness[area] <= kThinShare * rawWidth[area];
  }
  WalkAreas result;
  result.pieces = absorbed(field, raw, isThin);
  result.halfWidth.assign(result.pieces.count, 0);
  for (size_t i = 0; i < labels.size(); ++i) {
    if (isThin[raw.of[i]] == 0 || result.halfWidth[result.pieces.of[i]] == 0) {
      uint16_t& half = result.halfWidth[result.pieces.of[i]];
      half = isThin[raw.of[i]] == 0 ? std::max(half, rawWidth[raw.of[i]]) : half;
    }
  }
  for (size_t i = 0; i < labels.size(); ++i) {  // thin ones that touch no other
    uint16_t& half = result.halfWidth[result.pieces.of[i]];
    half = half == 0 ? rawWidth[raw.of[i]] : half;
  }
  return result;
}

}  // namespace ocelli
