#include "oc_core/walkable/walk_pieces.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "oc_core/walkable/walk_width.h"

namespace ocelli {
namespace {

WalkPieces renumbered(std::vector<uint32_t> labels) {
  WalkPieces pieces;
  std::vector<uint32_t> numbers(labels.size() + 1, kNoSquare);
  for (uint32_t& label : labels) {
    uint32_t& number = numbers[label];
    if (number == kNoSquare) {
      number = pieces.count++;
    }
    label = number;
  }
  pieces.of = std::move(labels);
  return pieces;
}

}  // namespace

std::vector<size_t> WalkPieces::sizes() const {
  std::vector<size_t> sizes(count, 0);
  for (const uint32_t piece : of) {
    ++sizes[piece];
  }
  return sizes;
}

std::vector<size_t> standingSizes(const WalkField& field, const WalkPieces& pieces) {
  std::vector<size_t> sizes(pieces.count, 0);
  for (size_t i = 0; i < pieces.of.size(); ++i) {
    sizes[pieces.of[i]] += field.squares[i].isObstacle ? 0 : 1;
  }
  return sizes;
}

std::vector<PieceBorder> bordersOf(const WalkField& field, const std::vector<uint32_t>& labels) {
  std::vector<std::pair<uint32_t, uint32_t>> pairs;
  for (uint32_t i = 0; i < field.squares.size(); ++i) {
    for (const int side : {1, 2}) {
      const uint32_t k = field.squares[i].next[side];
      if (k != kNoSquare && labels[k] != labels[i]) {
        pairs.push_back(std::minmax(labels[i], labels[k]));
      }
    }
  }
  std::sort(pairs.begin(), pairs.end());
  std::vector<PieceBorder> borders;
  for (const auto& [a, b] : pairs) {
    if (borders.empty() || borders.back().a != a || borders.back().b != b) {
      borders.push_back({a, b, 0});
    }
    ++borders.back().length;
  }
  return borders;
}

WalkPieces connectedPieces(const WalkField& field, const std::vector<uint32_t>& labels) {
  WalkPieces pieces;
  pieces.of.assign(labels.size(), kNoSquare);
  std::vector<uint32_t> open;
  for (uint32_t seed = 0; seed < labels.size(); ++seed) {
    if (pieces.of[seed] != kNoSquare) {
      continue;
    }
    pieces.of[seed] = pieces.count;
    open.assign(1, seed);
    while (!open.empty()) {
      const uint32_t i = open.back();
      open.pop_back();
      for (const uint32_t k : field.squares[i].next) {
        if (k != kNoSquare && labels[k] == labels[i] && pieces.of[k] == kNoSquare) {
          pieces.of[k] = pieces.count;
          open.push_back(k);
        }
      }
    }
    ++pieces.count;
  }
  return pieces;
}

WalkPieces absorbed(const WalkField& field, const WalkPieces& pieces, const std::vector<uint8_t>& isMarked) {
  std::vector<std::vector<std::pair<uint32_t, size_t>>> around(pieces.count);
  for (const PieceBorder& border : bordersOf(field, pieces.of)) {
    around[border.a].push_back({border.b, border.length});
    around[border.b].push_back({border.a, border.length});
  }
  std::vector<uint32_t> owner(pieces.count);
  std::iota(owner.begin(), owner.end(), 0U);
  std::vector<uint8_t> isLeft = isMarked;
  const std::vector<size_t> sizes = pieces.sizes();
  std::vector<uint32_t> order;
  for (uint32_t piece = 0; piece < pieces.count; ++piece) {
    if (isMarked[piece] != 0) {
      order.push_back(piece);
    }
  }
  std::stable_sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) { return sizes[a] < sizes[b]; });
  for (bool changed = true; changed;) {
    changed = false;
    for (const uint32_t piece : order) {
      if (isLeft[piece] == 0) {
        continue;
      }
      std::vector<std::pair<uint32_t, size_t>> owners;  // and the length of the border to each
      for (const auto& [other, length] : around[piece]) {
        if (isLeft[other] == 0) {
          owners.push_back({owner[other], length});
        }
      }
      std::sort(owners.begin(), owners.end());
      size_t best = 0;
      size_t sum = 0;
      for (size_t i = 0; i < owners.size(); ++i) {
        sum = i > 0 && owners[i].first == owners[i - 1].first ? sum + owners[i].second : owners[i].second;
        if (sum > best) {
          best = sum;
          owner[piece] = owners[i].first;
        }
      }
      if (best > 0) {
        isLeft[piece] = 0;
        changed = true;
      }
    }
  }
  std::vector<uint32_t> labels = pieces.of;
  for (uint32_t& label : labels) {
    label = owner[label];
  }
  return renumbered(std::move(labels));
}

std::vector<uint16_t> thicknesses(const WalkField& field, const WalkPieces& pieces) {
  const std::vector<uint16_t> steps = stepsToBorder(field, pieces.of);
  std::vector<uint16_t> result(pieces.count, 0);
  for (size_t i = 0; i < steps.size(); ++i) {
    result[pieces.of[i]] = std::max(result[pieces.of[i]], steps[i]);
  }
  return result;
}

}  // namespace ocelli
