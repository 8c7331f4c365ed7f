#include "oc_core/walkable/walk_strips.h"

#include <algorithm>
#include <array>
#include <utility>

namespace ocelli {
namespace {

constexpr double kCrossingReach = 1.5;  // in widths
constexpr double kTunnelLength = 2.5;   // in widths, of an area without crossings
constexpr double kMouthOfTunnel = 0.4;  // the least width of what crosses, in widths of the tunnel
constexpr double kWidestMouth = 2.5;
constexpr double kMouthIsWhole = 0.8;   // of the width of what opens there: else it is a door
constexpr double kThinCrossing = 0.35;  // in widths

double widthOf(uint16_t half) {
  return 2.0 * half - 1;
}

/// How many squares of the same piece stand in a row with each square, itself included, along x or z.
std::vector<uint32_t> runs(const WalkField& field, const std::vector<uint32_t>& labels, bool alongX) {
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

/// A part of a tunnel's length, in squares; `last` belongs to it.
struct Interval {
  int first = 0;
  int last = -1;
  int length() const { return last - first + 1; }
};

/// The pieces as they are divided step by step.
struct Division {
  const WalkField& field;
  WalkPieces pieces;
  std::vector<WalkShape> shapes;
  std::vector<uint8_t> isCrossing;
  std::vector<std::vector<uint32_t>> squares;  ///< of each piece

  int along(uint32_t square, bool alongX) const { return alongX ? field.squares[square].x : field.squares[square].z; }

  void gather() {
    squares.assign(pieces.count, {});
    for (uint32_t i = 0; i < pieces.of.size(); ++i) {
      squares[pieces.of[i]].push_back(i);
    }
  }

  /// Where a piece is at least half as wide as it mostly is.
  Interval extent(uint32_t piece, bool alongX) const {
    int low = along(squares[piece].front(), alongX);
    int high = low;
    for (const uint32_t i : squares[piece]) {
      low = std::min(low, along(i, alongX));
      high = std::max(high, along(i, alongX));
    }
    std::vector<int> counts(high - low + 1, 0);
    for (const uint32_t i : squares[piece]) {
      ++counts[along(i, alongX) - low];
    }
    std::vector<int> ordered = counts;
    std::nth_element(ordered.begin(), ordered.begin() + static_cast<long>(ordered.size() / 2), ordered.end());
    const int least = (ordered[ordered.size() / 2] + 1) / 2;
    Interval interval{low, high};
    while (counts[interval.first - low] < least) {
      ++interval.first;
    }
    while (counts[interval.last - low] < least) {
      --interval.last;
    }
    return interval;
  }

  /// Makes a piece of the squares of another one whose coordinate along an axis lies in the interval.
  uint32_t cut(uint32_t piece, bool alongX, const Interval& interval, const WalkShape& shape) {
    std::vector<uint32_t> kept;
    std::vector<uint32_t> taken;
    for (const uint32_t i : squares[piece]) {
      const int at = along(i, alongX);
      (at >= interval.first && at <= interval.last ? taken : kept).push_back(i);
    }
    const uint32_t made = pieces.count++;
    for (const uint32_t i : taken) {
      pieces.of[i] = made;
    }
    squares[piece] = std::move(kept);
    squares.push_back(std::move(taken));
    shapes.push_back(shape);
    isCrossing.push_back(0);
    return made;
  }
};

/// Crossings and what is between them, by label: two labels of each area.
WalkPieces crossingsAndArms(const WalkField& field, const WalkAreas& areas, int radius, std::vector<uint8_t>& isCross) {
  const std::vector<uint32_t> alongX = runs(field, areas.pieces.of, true);
  const std::vector<uint32_t> alongZ = runs(field, areas.pieces.of, false);
  std::vector<uint32_t> labels(areas.pieces.of.size());
  for (size_t i = 0; i < labels.size(); ++i) {
    const uint32_t area = areas.pieces.of[i];
    const double reach = kCrossingReach * widthOf(areas.halfWidth[area]);
    labels[i] = 2 * area + (alongX[i] >= reach && alongZ[i] >= reach ? 1 : 0);
  }
  for (int pass = 0; pass < 2; ++pass) {
    const WalkPieces raw = connectedPieces(field, labels);
    std::vector<uint32_t> labelOf(raw.count);
    for (size_t i = 0; i < labels.size(); ++i) {
      labelOf[raw.of[i]] = labels[i];
    }
    std::vector<int> crossingsBeside(raw.count, 0);
    std::vector<int> armsBeside(raw.count, 0);
    for (const PieceBorder& border : bordersOf(field, raw.of)) {
      if (labelOf[border.a] / 2 == labelOf[border.b] / 2) {
        ++crossingsBeside[labelOf[border.b] % 2 == 1 ? border.a : border.b];
        ++armsBeside[labelOf[border.b] % 2 == 1 ? border.b : border.a];
      }
    }
    // First thin crossings, then what is left over beside crossings.
    const std::vector<uint16_t> thickness = thicknesses(field, raw);
    std::vector<uint8_t> isMarked(raw.count, 0);
    for (uint32_t piece = 0; piece < raw.count; ++piece) {
      const uint16_t half = areas.halfWidth[labelOf[piece] / 2];
      const bool isThin = thickness[piece] <= std::max<double>(1, kThinCrossing * half);
      isMarked[piece] = labelOf[piece] % 2 == 1
                            ? pass == 0 && isThin && armsBeside[piece] > 0
                            : pass == 1 && thickness[piece] <= radius && crossingsBeside[piece] == 1;
    }
    const WalkPieces left = absorbed(field, raw, isMarked);
    std::vector<uint32_t> ownLabel(left.count, kNoSquare);
    for (size_t i = 0; i < labels.size(); ++i) {
      if (isMarked[raw.of[i]] == 0) {
        ownLabel[left.of[i]] = labelOf[raw.of[i]];
      }
    }
    for (size_t i = 0; i < labels.size(); ++i) {
      labels[i] = ownLabel[left.of[i]] == kNoSquare ? labels[i] : ownLabel[left.of[i]];
    }
  }
  const WalkPieces pieces = connectedPieces(field, labels);
  isCross.assign(pieces.count, 0);
  for (size_t i = 0; i < labels.size(); ++i) {
    isCross[pieces.of[i]] = labels[i] % 2;
  }
  return pieces;
}

/// Along which axis an arm leaves its crossings; the longer one where it has none. `touches` tells whether it has.
bool armIsAlongX(const Division& d, uint32_t piece, bool& touches) {
  std::array<size_t, 2> sides{0, 0};
  for (const uint32_t i : d.squares[piece]) {
    for (int side = 0; side < 4; ++side) {
      const uint32_t k = d.field.squares[i].next[side];
      if (k != kNoSquare && d.pieces.of[k] != piece && d.isCrossing[d.pieces.of[k]] != 0) {
        ++sides[side % 2];
      }
    }
  }
  touches = sides[0] + sides[1] > 0;
  return touches ? sides[0] > sides[1] : d.extent(piece, true).length() > d.extent(piece, false).length();
}

/// Whether one gets out at an end of a strip, through a side that looks that way.
bool isOpenAt(const Division& d, uint32_t piece, bool alongX, bool atLast, const Interval& extent, double slack) {
  const int side = alongX ? (atLast ? 2 : 0) : (atLast ? 1 : 3);
  for (const uint32_t i : d.squares[piece]) {
    const int at = d.along(i, alongX);
    const uint32_t k = d.field.squares[i].next[side];
    if (k != kNoSquare && d.pieces.of[k] != piece &&
        (atLast ? at >= extent.last - slack : at <= extent.first + slack)) {
      return true;
    }
  }
  return false;
}

void divideArm(Division& d, uint32_t piece) {
  bool touches = false;
  WalkShape& shape = d.shapes[piece];
  const bool alongX = armIsAlongX(d, piece, touches);
  shape.isAlongX = alongX;
  const double width = widthOf(shape.halfWidth);
  const Interval extent = d.extent(piece, alongX);
  if (!touches && extent.length() < kTunnelLength * width) {
    return;
  }
  const bool firstOpen = isOpenAt(d, piece, alongX, false, extent, width / 2);
  const bool lastOpen = isOpenAt(d, piece, alongX, true, extent, width / 2);
  const auto end = static_cast<int>(width);
  const int rest = extent.length() - (firstOpen ? 0 : end) - (lastOpen ? 0 : end);
  constexpr int kShortestTunnel = 2;  // squares
  if (rest < kShortestTunnel) {
    return;
  }
  shape.isTunnel = true;
  WalkShape room = shape;
  room.isTunnel = false;
  constexpr int kFar = 1 << 30;
  if (!firstOpen) {
    d.cut(piece, alongX, {-kFar, extent.first + end - 1}, room);
  }
  if (!lastOpen) {
    d.cut(piece, alongX, {extent.last - end + 1, kFar}, room);
  }
}

/// Where other tunnels open into the sides of a tunnel.
std::vector<Interval> mouthsOf(const Division& d, uint32_t piece) {
  const bool alongX = d.shapes[piece].isAlongX;
  const double width = widthOf(d.shapes[piece].halfWidth);
  std::vector<std::pair<uint32_t, int>> edges;  // the other piece, and where along the tunnel
  for (const uint32_t i : d.squares[piece]) {
    for (int side = alongX ? 1 : 0; side < 4; side += 2) {
      const uint32_t k = d.field.squares[i].next[side];
      if (k != kNoSquare && d.pieces.of[k] != piece) {
        const WalkShape& other = d.shapes[d.pieces.of[k]];
        if (other.isTunnel && other.isAlongX != alongX) {
          edges.push_back({d.pieces.of[k], d.along(i, alongX)});
        }
      }
    }
  }
  std::sort(edges.begin(), edges.end());
  std::vector<Interval> mouths;
  for (size_t begin = 0; begin < edges.size();) {
    size_t end = begin + 1;
    while (end < edges.size() && edges[end].first == edges[begin].first &&
           edges[end].second <= edges[end - 1].second + 1) {
      ++end;
    }
    const Interval mouth{edges[begin].second, edges[end - 1].second};
    if (mouth.length() >= kMouthOfTunnel * width && mouth.length() <= kWidestMouth * width &&
        mouth.length() >= kMouthIsWhole * widthOf(d.shapes[edges[begin].first].halfWidth)) {
      mouths.push_back(mouth);
    }
    begin = end;
  }
  std::sort(mouths.begin(), mouths.end(), [](const Interval& a, const Interval& b) { return a.first < b.first; });
  std::vector<Interval> joined;
  for (const Interval& mouth : mouths) {
    if (!joined.empty() && mouth.first <= joined.back().last) {
      joined.back().last = std::max(joined.back().last, mouth.last);
    } else {
      joined.push_back(mouth);
    }
  }
  return joined;
}

/// Pieces that cuts left in several parts are one each, and crumbs go to their neighbours.
WalkLayout settled(const Division& d) {
  const WalkPieces parts = connectedPieces(d.field, d.pieces.of);
  const std::vector<size_t> sizes = parts.sizes();
  std::vector<uint32_t> pieceOf(parts.count);
  for (size_t i = 0; i < d.pieces.of.size(); ++i) {
    pieceOf[parts.of[i]] = d.pieces.of[i];
  }
  std::vector<size_t> largest(d.pieces.count, 0);
  for (uint32_t part = 0; part < parts.count; ++part) {
    largest[pieceOf[part]] = std::max(largest[pieceOf[part]], sizes[part]);
  }
  std::vector<uint8_t> isCrumb(parts.count, 0);
  for (uint32_t part = 0; part < parts.count; ++part) {
    isCrumb[part] = sizes[part] * 4 < largest[pieceOf[part]];
  }
  WalkLayout layout;
  layout.pieces = absorbed(d.field, parts, isCrumb);
  layout.shapes.resize(layout.pieces.count);
  for (const bool crumbs : {true, false}) {
    for (size_t i = 0; i < d.pieces.of.size(); ++i) {
      if ((isCrumb[parts.of[i]] != 0) == crumbs) {
        layout.shapes[layout.pieces.of[i]] = d.shapes[d.pieces.of[i]];
      }
    }
  }
  return layout;
}

}  // namespace

WalkLayout layoutOf(const WalkField& field, const WalkAreas& areas, int radius) {
  Division d{field, {}, {}, {}, {}};
  d.pieces = crossingsAndArms(field, areas, radius, d.isCrossing);
  d.gather();
  d.shapes.resize(d.pieces.count);
  for (uint32_t piece = 0; piece < d.pieces.count; ++piece) {
    d.shapes[piece].halfWidth = areas.halfWidth[areas.pieces.of[d.squares[piece].front()]];
  }
  const uint32_t arms = d.pieces.count;
  for (uint32_t piece = 0; piece < arms; ++piece) {
    if (d.isCrossing[piece] == 0) {
      divideArm(d, piece);
    }
  }
  const uint32_t tunnels = d.pieces.count;
  std::vector<std::vector<Interval>> mouths(tunnels);
  for (uint32_t piece = 0; piece < tunnels; ++piece) {
    if (d.shapes[piece].isTunnel) {
      mouths[piece] = mouthsOf(d, piece);
    }
  }
  for (uint32_t piece = 0; piece < tunnels; ++piece) {
    for (const Interval& mouth : mouths[piece]) {
      WalkShape room = d.shapes[piece];
      room.isTunnel = false;
      d.cut(piece, d.shapes[piece].isAlongX, mouth, room);
    }
  }
  return settled(d);
}

}  // namespace ocelli
