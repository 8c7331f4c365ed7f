#include "oc_core/walkable/walk_extent.h"

#include <algorithm>

namespace ocelli {

SquareRange extentOf(const WalkField& field, const std::vector<uint32_t>& squares, bool alongX) {
  int low = coordinateOf(field, squares.front(), alongX);
  int high = low;
  for (const uint32_t i : squares) {
    low = std::min(low, coordinateOf(field, i, alongX));
    high = std::max(high, coordinateOf(field, i, alongX));
  }
  std::vector<int> counts(high - low + 1, 0);
  for (const uint32_t i : squares) {
    ++counts[coordinateOf(field, i, alongX) - low];
  }
  std::vector<int> ordered = counts;
  std::nth_element(ordered.begin(), ordered.begin() + static_cast<long>(ordered.size() / 2), ordered.end());
  const int least = (ordered[ordered.size() / 2] + 1) / 2;
  SquareRange range{low, high};
  while (counts[range.first - low] < least) {
    ++range.first;
  }
  while (counts[range.last - low] < least) {
    --range.last;
  }
  return range;
}

std::vector<std::vector<uint32_t>> squaresOf(const WalkPieces& pieces) {
  std::vector<std::vector<uint32_t>> squares(pieces.count);
  for (uint32_t i = 0; i < pieces.of.size(); ++i) {
    squares[pieces.of[i]].push_back(i);
  }
  return squares;
}

}  // namespace ocelli
