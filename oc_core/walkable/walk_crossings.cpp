#include "oc_core/walkable/walk_crossings.h"

#include <algorithm>
#include <array>

#include "oc_core/walkable/walk_extent.h"

namespace ocelli {
namespace {

constexpr double kCrossingReach = 1.5;  // in widths
constexpr double kThinPiece = 0.35;     // in widths of the area
constexpr double kIsRectangle = 0.6;    // of its rectangle that a crossing fills

/// What a square is within its area.
enum StripLabel : uint32_t { kArm = 0, kCrossing = 1, kArmAlongX = 2, kArmAlongZ = 3, kStripLabels = 4 };

/// How many squares of the same label stand in a row with each square, itself included, along x or z.
std::vector<uint32_t> runsOf(const WalkField& field, const std::vector<uint32_t>& labels, bool alongX) {
  const int back = alongX ? 0 : 3;
  const int ahead = alongX ? 2 : 1;
  const auto count = static_cast<uint32_t>(labels.size());
  const auto follows = [&](uint32_t i, int side) {
    const uint32_t k = field.squares[i].next[side];
    return k != kNoSquare && labels[k] == labels[i] ? k : kNoSquare;
  };
  std::vector<uint32_t> result(count, 0);
  std::vector<uint32_t> row;
  for (uint32_t i = 0; i < count; ++i) {
    if (result[i] != 0 || follows(i, back) != kNoSquare) {
      continue;
    }
    row.assign(1, i);
    for (uint32_t k = follows(i, ahead); k != kNoSquare; k = follows(k, ahead)) {
      row.push_back(k);
    }
    for (const uint32_t k : row) {
      result[k] = static_cast<uint32_t>(row.size());
    }
  }
  return result;
}

/// The rectangle of a crossing, filled with floor of its area that hangs together with it.
void squareUp(const WalkField& field, const std::vector<uint32_t>& crossing, const std::vector<uint32_t>& area,
              std::vector<uint8_t>& isCrossing) {
  const SquareRange x = extentOf(field, crossing, true);
  const SquareRange z = extentOf(field, crossing, false);
  const auto isInside = [&](uint32_t i) {
    const WalkSquare& square = field.squares[i];
    return square.x >= x.first && square.x <= x.last && square.z >= z.first && square.z <= z.last;
  };
  const auto filled = static_cast<double>(std::count_if(crossing.begin(), crossing.end(), isInside));
  if (filled < kIsRectangle * x.length() * z.length()) {
    return;
  }
  std::vector<uint32_t> open;
  for (const uint32_t i : crossing) {
    isCrossing[i] = isInside(i) ? 1 : 0;
    if (isInside(i)) {
      open.push_back(i);
    }
  }
  while (!open.empty()) {
    const uint32_t i = open.back();
    open.pop_back();
    for (const uint32_t k : field.squares[i].next) {
      if (k != kNoSquare && area[k] == area[i] && isCrossing[k] == 0 && isInside(k)) {
        isCrossing[k] = 1;
        open.push_back(k);
      }
    }
  }
}

/// Of each square: its area times kStripLabels and what it is there.
std::vector<uint32_t> stripLabels(const WalkField& field, const WalkAreas& areas) {
  const std::vector<uint32_t>& area = areas.pieces.of;
  const std::vector<uint32_t> alongX = runsOf(field, area, true);
  const std::vector<uint32_t> alongZ = runsOf(field, area, false);
  std::vector<uint32_t> raw(area.size());
  for (size_t i = 0; i < raw.size(); ++i) {
    const double reach = kCrossingReach * widthOf(areas.halfWidth[area[i]]);
    raw[i] = 2 * area[i] + (alongX[i] >= reach && alongZ[i] >= reach ? 1 : 0);
  }
  const WalkPieces pieces = connectedPieces(field, raw);
  const std::vector<uint16_t> thickness = thicknesses(field, pieces);
  const std::vector<std::vector<uint32_t>> squares = squaresOf(pieces);
  std::vector<uint8_t> isCrossing(area.size(), 0);
  for (uint32_t piece = 0; piece < pieces.count; ++piece) {
    const uint32_t first = squares[piece].front();
    if (raw[first] % 2 == 1 && thickness[piece] > std::max(1.0, kThinPiece * areas.halfWidth[area[first]])) {
      for (const uint32_t i : squares[piece]) {
        isCrossing[i] = 1;
      }
      squareUp(field, squares[piece], area, isCrossing);
    }
  }
  std::vector<uint8_t> hasCrossing(areas.pieces.count, 0);
  for (size_t i = 0; i < area.size(); ++i) {
    hasCrossing[area[i]] |= isCrossing[i];
  }
  std::vector<uint32_t> labels(area.size());
  for (size_t i = 0; i < labels.size(); ++i) {
    const StripLabel label = isCrossing[i] != 0          ? kCrossing
                             : hasCrossing[area[i]] == 0 ? kArm
                             : alongX[i] >= alongZ[i]    ? kArmAlongX
                                                         : kArmAlongZ;
    labels[i] = kStripLabels * area[i] + label;
  }
  return labels;
}

}  // namespace

WalkCrossings crossingsOf(const WalkField& field, const WalkAreas& areas, int radius) {
  const std::vector<uint32_t> labels = stripLabels(field, areas);
  const WalkPieces raw = connectedPieces(field, labels);
  std::vector<uint32_t> labelOf(raw.count);
  for (size_t i = 0; i < labels.size(); ++i) {
    labelOf[raw.of[i]] = labels[i];
  }
  const auto isCrossing = [&](uint32_t piece) { return labelOf[piece] % kStripLabels == kCrossing; };
  std::vector<int> crossingsBeside(raw.count, 0);
  for (const PieceBorder& border : bordersOf(field, raw.of)) {
    crossingsBeside[border.a] += isCrossing(border.b) ? 1 : 0;
    crossingsBeside[border.b] += isCrossing(border.a) ? 1 : 0;
  }
  const std::vector<uint16_t> thickness = thicknesses(field, raw);
  std::vector<uint8_t> isThin(raw.count, 0);
  for (uint32_t piece = 0; piece < raw.count; ++piece) {
    const double least = std::max<double>(radius, kThinPiece * areas.halfWidth[labelOf[piece] / kStripLabels]);
    isThin[piece] = !isCrossing(piece) && labelOf[piece] % kStripLabels != kArm && thickness[piece] <= least &&
                    crossingsBeside[piece] < 2;
  }
  WalkCrossings result;
  result.pieces = absorbed(field, raw, isThin);
  result.isCrossing.assign(result.pieces.count, 0);
  result.area.assign(result.pieces.count, 0);
  for (const bool thinOnes : {true, false}) {  // what a piece mostly is comes last
    for (size_t i = 0; i < labels.size(); ++i) {
      if ((isThin[raw.of[i]] != 0) == thinOnes) {
        result.isCrossing[result.pieces.of[i]] = isCrossing(raw.of[i]);
        result.area[result.pieces.of[i]] = labels[i] / kStripLabels;
      }
    }
  }
  return result;
}

}  // namespace ocelli
