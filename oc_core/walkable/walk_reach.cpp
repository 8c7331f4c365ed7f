#include "oc_core/walkable/walk_reach.h"

#include <algorithm>

#include "oc_core/walkable/walk_width.h"

namespace ocelli {
namespace {

/// The connected parts of the squares where the agent's middle can be; kNoSquare elsewhere. Returns their number.
uint32_t labelParts(const WalkField& field, const std::vector<uint16_t>& steps, int radius,
                    std::vector<uint32_t>& labels) {
  uint32_t parts = 0;
  std::vector<uint32_t> open;
  for (uint32_t seed = 0; seed < field.squares.size(); ++seed) {
    if (steps[seed] <= radius || labels[seed] != kNoSquare) {
      continue;
    }
    labels[seed] = parts;
    open.assign(1, seed);
    while (!open.empty()) {
      const uint32_t i = open.back();
      open.pop_back();
      for (const uint32_t k : field.squares[i].next) {
        if (k != kNoSquare && steps[k] > radius && labels[k] == kNoSquare) {
          labels[k] = parts;
          open.push_back(k);
        }
      }
    }
    ++parts;
  }
  return parts;
}

/// Gives each square that the agent covers the part of the nearest position of its middle.
void spread(const WalkField& field, int radius, std::vector<uint32_t>& labels) {
  std::vector<uint32_t> front;
  for (uint32_t i = 0; i < labels.size(); ++i) {
    if (labels[i] != kNoSquare) {
      front.push_back(i);
    }
  }
  std::vector<uint32_t> after;
  for (int step = 0; step < radius; ++step) {
    after.clear();
    const auto give = [&](uint32_t from, uint32_t to) {
      if (to != kNoSquare && labels[to] == kNoSquare) {
        labels[to] = labels[from];
        after.push_back(to);
      }
    };
    for (const uint32_t i : front) {
      for (int side = 0; side < 4; ++side) {
        give(i, field.squares[i].next[side]);
      }
    }
    for (const uint32_t i : front) {
      for (int side = 0; side < 4; ++side) {
        give(i, field.diagonal(i, side));
      }
    }
    std::swap(front, after);
  }
}

/// Which parts lie, for more than half of them, over the floor of part `below`, or of any other and under the open sky
/// where that is kNoSquare.
std::vector<uint8_t> partsAbove(const WalkField& field, const std::vector<uint32_t>& labels,
                                const std::vector<size_t>& sizes, uint32_t below) {
  std::vector<size_t> above(sizes.size(), 0);
  for (uint32_t i = 0; i < labels.size(); ++i) {
    const WalkSquare& square = field.squares[i];
    if (labels[i] == kNoSquare || (below == kNoSquare && square.ceiling != kNoCeiling)) {
      continue;
    }
    // Squares of one column stand in a row, from the lowest up.
    for (uint32_t k = i; k-- > 0 && field.squares[k].x == square.x && field.squares[k].z == square.z;) {
      if (labels[k] != kNoSquare && labels[k] != labels[i] && (below == kNoSquare || labels[k] == below)) {
        ++above[labels[i]];
        break;
      }
    }
  }
  std::vector<uint8_t> isAbove(sizes.size(), 0);
  for (size_t part = 0; part < sizes.size(); ++part) {
    isAbove[part] = 2 * above[part] > sizes[part];
  }
  return isAbove;
}

/// Which parts to keep, as reachOf() says.
std::vector<uint8_t> keptParts(const WalkField& field, const std::vector<uint32_t>& labels,
                               const std::vector<size_t>& sizes, double partShare) {
  std::vector<uint8_t> isKept(sizes.size(), 1);
  if (partShare == 0 || sizes.empty()) {
    return isKept;
  }
  const std::vector<uint8_t> isRoof = partsAbove(field, labels, sizes, kNoSquare);
  uint32_t largest = kNoSquare;
  for (uint32_t part = 0; part < sizes.size(); ++part) {
    if (isRoof[part] == 0 && (largest == kNoSquare || sizes[part] > sizes[largest])) {
      largest = part;
    }
  }
  if (largest == kNoSquare) {  // each over another: there is nothing to choose by
    return isKept;
  }
  const std::vector<uint8_t> isAttic = partsAbove(field, labels, sizes, largest);
  for (uint32_t part = 0; part < sizes.size(); ++part) {
    const bool isSmall = static_cast<double>(sizes[part]) < partShare * static_cast<double>(sizes[largest]);
    isKept[part] = part == largest || (isRoof[part] == 0 && isAttic[part] == 0 && !isSmall);
  }
  return isKept;
}

}  // namespace

WalkReach reachOf(const WalkField& field, int radius, double partShare) {
  WalkReach reach;
  const std::vector<uint16_t> steps = stepsToBorder(field);
  std::vector<uint32_t> labels(field.squares.size(), kNoSquare);
  const uint32_t parts = labelParts(field, steps, radius, labels);
  spread(field, radius, labels);

  std::vector<size_t> sizes(parts, 0);
  size_t narrow = 0;
  for (const uint32_t label : labels) {
    if (label == kNoSquare) {
      ++narrow;
    } else {
      ++sizes[label];
    }
  }
  const std::vector<uint8_t> isKept = keptParts(field, labels, sizes, partShare);
  size_t small = 0;
  for (uint32_t part = 0; part < parts; ++part) {
    small += isKept[part] != 0 ? 0 : sizes[part];
    reach.smallParts += isKept[part] != 0 ? 0 : 1;
  }
  WalkField separate = field;
  std::vector<uint8_t> kept(labels.size(), 0);
  for (uint32_t i = 0; i < labels.size(); ++i) {
    kept[i] = labels[i] != kNoSquare && isKept[labels[i]] != 0;
    for (uint32_t& k : separate.squares[i].next) {
      k = k != kNoSquare && labels[k] == labels[i] ? k : kNoSquare;
    }
  }
  reach.field = partOf(separate, kept);
  const double square = static_cast<double>(field.cellSize) * field.cellSize;
  reach.tooNarrowArea = static_cast<double>(narrow) * square;
  reach.smallPartsArea = static_cast<double>(small) * square;
  return reach;
}

}  // namespace ocelli
