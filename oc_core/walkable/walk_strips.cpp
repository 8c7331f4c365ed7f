#include "oc_core/walkable/walk_strips.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>

#include "oc_core/base/disjoint_sets.h"
#include "oc_core/walkable/walk_crossings.h"
#include "oc_core/walkable/walk_extent.h"

namespace ocelli {
namespace {

constexpr double kTunnelLength = 2.5;   // in widths, of an area without crossings
constexpr double kMouthOfTunnel = 0.4;  // the least width of what crosses, in widths of the tunnel
constexpr double kWidestMouth = 2.5;
constexpr double kMouthIsWhole = 0.8;    // of the width of what opens there: else it is a door
constexpr double kGoesOnThrough = 0.35;  // of the width of tunnels that are one: the least opening between them
constexpr double kGoesOnWidth = 0.6;     // the narrower of the wider
constexpr double kGoesOnBeside = 0.3;    // of their width: how far their middle lines may be apart

/// The pieces as they are divided step by step.
struct Division {
  const WalkField& field;
  WalkPieces pieces;
  std::vector<WalkShape> shapes;
  std::vector<uint8_t> isCrossing;
  std::vector<uint32_t> area;
  std::vector<std::vector<uint32_t>> squares;  ///< of each piece

  int along(uint32_t square, bool alongX) const { return coordinateOf(field, square, alongX); }

  /// Makes a piece of the squares of another one whose coordinate along an axis lies in the range.
  uint32_t cut(uint32_t piece, bool alongX, const SquareRange& range, const WalkShape& shape) {
    std::vector<uint32_t> kept;
    std::vector<uint32_t> taken;
    for (const uint32_t i : squares[piece]) {
      const int at = along(i, alongX);
      (at >= range.first && at <= range.last ? taken : kept).push_back(i);
    }
    const uint32_t made = pieces.count++;
    for (const uint32_t i : taken) {
      pieces.of[i] = made;
    }
    squares[piece] = std::move(kept);
    squares.push_back(std::move(taken));
    shapes.push_back(shape);
    isCrossing.push_back(0);
    area.push_back(area[piece]);
    return made;
  }
};

/// An arm as a strip.
struct Strip {
  bool touchesCrossing = false;
  bool alongX = false;
  SquareRange length;
  SquareRange across;
};

/// Along the axis by which it leaves crossings of its area; along the longer one where it has none.
Strip stripOf(const Division& d, uint32_t piece) {
  std::array<size_t, 2> sides{0, 0};
  for (const uint32_t i : d.squares[piece]) {
    for (int side = 0; side < 4; ++side) {
      const uint32_t k = d.field.squares[i].next[side];
      if (k != kNoSquare && d.pieces.of[k] != piece && d.isCrossing[d.pieces.of[k]] != 0 &&
          d.area[d.pieces.of[k]] == d.area[piece]) {
        ++sides[side % 2];
      }
    }
  }
  const SquareRange x = extentOf(d.field, d.squares[piece], true);
  const SquareRange z = extentOf(d.field, d.squares[piece], false);
  Strip strip;
  strip.touchesCrossing = sides[0] + sides[1] > 0;
  strip.alongX = strip.touchesCrossing ? sides[0] > sides[1] : x.length() > z.length();
  strip.length = strip.alongX ? x : z;
  strip.across = strip.alongX ? z : x;
  return strip;
}

/// How much of the border of two pieces lies across an axis.
size_t borderAcross(const Division& d, uint32_t a, uint32_t b, bool alongX) {
  size_t length = 0;
  for (const uint32_t i : d.squares[a]) {
    for (int side = alongX ? 0 : 1; side < 4; side += 2) {
      const uint32_t k = d.field.squares[i].next[side];
      length += k != kNoSquare && d.pieces.of[k] == b ? 1 : 0;
    }
  }
  return length;
}

/// Joins the arms that go on in each other.
void joinStrips(Division& d) {
  std::vector<Strip> strips;
  std::vector<uint8_t> isLong;
  for (uint32_t piece = 0; piece < d.pieces.count; ++piece) {
    strips.push_back(stripOf(d, piece));
    isLong.push_back(d.isCrossing[piece] == 0 &&
                     (strips[piece].touchesCrossing ||
                      strips[piece].length.length() >= kTunnelLength * widthOf(d.shapes[piece].halfWidth)));
  }
  DisjointSets sets(d.pieces.count);
  for (const PieceBorder& border : bordersOf(d.field, d.pieces.of)) {
    const Strip& a = strips[border.a];
    const Strip& b = strips[border.b];
    const double widthA = widthOf(d.shapes[border.a].halfWidth);
    const double widthB = widthOf(d.shapes[border.b].halfWidth);
    const double narrower = std::min(widthA, widthB);
    const double apart = std::abs(a.across.first + a.across.last - b.across.first - b.across.last) / 2.0;
    if (isLong[border.a] != 0 && isLong[border.b] != 0 && a.alongX == b.alongX &&
        narrower >= kGoesOnWidth * std::max(widthA, widthB) && apart <= kGoesOnBeside * narrower &&
        static_cast<double>(borderAcross(d, border.a, border.b, a.alongX)) >= kGoesOnThrough * narrower) {
      sets.join(border.a, border.b);
    }
  }
  for (uint32_t& piece : d.pieces.of) {
    piece = sets.least(piece);
  }
  const WalkPieces joined = connectedPieces(d.field, d.pieces.of);
  std::vector<WalkShape> shapes(joined.count);
  std::vector<uint8_t> isCrossing(joined.count, 0);
  std::vector<uint32_t> area(joined.count, 0);
  for (size_t i = 0; i < joined.of.size(); ++i) {
    const uint32_t old = d.pieces.of[i];
    shapes[joined.of[i]].halfWidth = std::max(shapes[joined.of[i]].halfWidth, d.shapes[old].halfWidth);
    shapes[joined.of[i]].isOfWays = shapes[joined.of[i]].isOfWays || d.shapes[old].isOfWays;
    isCrossing[joined.of[i]] = d.isCrossing[old];
    area[joined.of[i]] = d.area[old];
  }
  d.pieces = joined;
  d.shapes = std::move(shapes);
  d.isCrossing = std::move(isCrossing);
  d.area = std::move(area);
  d.squares = squaresOf(d.pieces);
}

/// Whether one gets out at an end of a strip, through a side that looks that way.
bool isOpenAt(const Division& d, uint32_t piece, const Strip& strip, bool atLast, double slack) {
  const int side = strip.alongX ? (atLast ? 2 : 0) : (atLast ? 1 : 3);
  for (const uint32_t i : d.squares[piece]) {
    const int at = d.along(i, strip.alongX);
    const uint32_t k = d.field.squares[i].next[side];
    if (k != kNoSquare && d.pieces.of[k] != piece &&
        (atLast ? at >= strip.length.last - slack : at <= strip.length.first + slack)) {
      return true;
    }
  }
  return false;
}

void divideArm(Division& d, uint32_t piece) {
  const Strip strip = stripOf(d, piece);
  WalkShape shape = d.shapes[piece];
  shape.isAlongX = strip.alongX;
  const double width = widthOf(shape.halfWidth);
  if (!strip.touchesCrossing && strip.length.length() < kTunnelLength * width) {
    return;
  }
  const bool firstOpen = isOpenAt(d, piece, strip, false, width / 2);
  const bool lastOpen = isOpenAt(d, piece, strip, true, width / 2);
  const auto end = static_cast<int>(width);
  const int rest = strip.length.length() - (firstOpen ? 0 : end) - (lastOpen ? 0 : end);
  constexpr int kShortestTunnel = 2;  // squares
  if (rest < kShortestTunnel) {
    return;
  }
  shape.isOfWays = true;
  const WalkShape room = shape;
  shape.isTunnel = true;
  d.shapes[piece] = shape;
  constexpr int kFar = 1 << 30;
  if (!firstOpen) {
    d.cut(piece, strip.alongX, {-kFar, strip.length.first + end - 1}, room);
  }
  if (!lastOpen) {
    d.cut(piece, strip.alongX, {strip.length.last - end + 1, kFar}, room);
  }
}

/// Where other tunnels open into the sides of a tunnel.
std::vector<SquareRange> mouthsOf(const Division& d, uint32_t piece) {
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
  std::vector<SquareRange> mouths;
  for (size_t begin = 0; begin < edges.size();) {
    size_t end = begin + 1;
    const double mouthWidth = widthOf(d.shapes[edges[begin].first].halfWidth);
    const double widestGap = 1 + (1 - kMouthIsWhole) * mouthWidth;  // behind a tree, a lamp or a car
    while (end < edges.size() && edges[end].first == edges[begin].first &&
           edges[end].second <= edges[end - 1].second + widestGap) {
      ++end;
    }
    const SquareRange mouth{edges[begin].second, edges[end - 1].second};
    if (mouth.length() >= kMouthOfTunnel * width && mouth.length() <= kWidestMouth * width &&
        mouth.length() >= kMouthIsWhole * mouthWidth) {
      mouths.push_back(mouth);
    }
    begin = end;
  }
  std::sort(mouths.begin(), mouths.end(), [](const SquareRange& a, const SquareRange& b) { return a.first < b.first; });
  std::vector<SquareRange> joined;
  for (const SquareRange& mouth : mouths) {
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
  WalkCrossings crossings = crossingsOf(field, areas, radius);
  Division d{field, std::move(crossings.pieces), {}, std::move(crossings.isCrossing), std::move(crossings.area), {}};
  d.squares = squaresOf(d.pieces);
  d.shapes.resize(d.pieces.count);
  for (uint32_t piece = 0; piece < d.pieces.count; ++piece) {
    d.shapes[piece].halfWidth = areas.halfWidth[d.area[piece]];
  }
  std::vector<uint8_t> hasCrossing(areas.pieces.count, 0);
  for (uint32_t piece = 0; piece < d.pieces.count; ++piece) {
    hasCrossing[d.area[piece]] |= d.isCrossing[piece];
  }
  for (uint32_t piece = 0; piece < d.pieces.count; ++piece) {
    d.shapes[piece].isOfWays = hasCrossing[d.area[piece]] != 0;
  }
  joinStrips(d);
  const uint32_t arms = d.pieces.count;
  for (uint32_t piece = 0; piece < arms; ++piece) {
    if (d.isCrossing[piece] == 0) {
      divideArm(d, piece);
    }
  }
  const uint32_t tunnels = d.pieces.count;
  std::vector<std::vector<SquareRange>> mouths(tunnels);
  for (uint32_t piece = 0; piece < tunnels; ++piece) {
    if (d.shapes[piece].isTunnel) {
      mouths[piece] = mouthsOf(d, piece);
    }
  }
  for (uint32_t piece = 0; piece < tunnels; ++piece) {
    for (const SquareRange& mouth : mouths[piece]) {
      WalkShape room = d.shapes[piece];
      room.isTunnel = false;
      d.cut(piece, d.shapes[piece].isAlongX, mouth, room);
    }
  }
  return settled(d);
}

}  // namespace ocelli
