#include "oc_core/walkable/walk_joints.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <tuple>

#include "oc_core/base/disjoint_sets.h"
#include "oc_core/walkable/walk_extent.h"

namespace ocelli {
namespace {

// Stairs are steeper than that, and ramps are not: 20 degrees (E. Neufert, Architects' Data, "Stairs").
constexpr float kSameSlope = 0.36f;

/// Two squares on both sides of a line.
struct LinePlace {
  uint32_t a = kNoSquare;
  uint32_t b = kNoSquare;
};

class LineSearch {
 public:
  LineSearch(const WalkField& field, const std::vector<uint16_t>& halfWidths, const WalkPieces& pieces,
             const std::vector<uint32_t>& groups)
      : field_(field), halfWidths_(halfWidths), pieces_(pieces), groups_(groups), isSeen_(field.squares.size(), 0) {}

  std::vector<PieceLine> lines() {
    std::vector<PieceLine> lines;
    for (uint32_t i = 0; i < field_.squares.size(); ++i) {
      for (const int side : {1, 2}) {
        const uint32_t k = field_.squares[i].next[side];
        if (k != kNoSquare && pieces_.of[k] != pieces_.of[i] && (isSeen_[i] >> side & 1) == 0) {
          lines.push_back(lineFrom({i, k}, side));
        }
      }
    }
    std::sort(lines.begin(), lines.end(), [](const PieceLine& p, const PieceLine& q) {
      return std::tie(p.a, p.b, p.side, p.at, p.first, p.open) < std::tie(q.a, q.b, q.side, q.at, q.first, q.open);
    });
    return inOne(lines);
  }

 private:
  /// Lines of two pieces that lie on one straight line are one, which obstacles part.
  static std::vector<PieceLine> inOne(const std::vector<PieceLine>& lines) {
    std::vector<PieceLine> joined;
    for (const PieceLine& line : lines) {
      const bool goesOn = !joined.empty() && joined.back().a == line.a && joined.back().b == line.b &&
                          joined.back().side == line.side && joined.back().at == line.at;
      if (!goesOn) {
        joined.push_back(line);
        continue;
      }
      PieceLine& whole = joined.back();
      whole.open += whole.first == line.first ? 0 : line.open;
      whole.first = line.first;
      whole.touching += line.touching;
      whole.widthOfA = std::max(whole.widthOfA, line.widthOfA);
      whole.widthOfB = std::max(whole.widthOfB, line.widthOfB);
      whole.depthOfA = std::max(whole.depthOfA, line.depthOfA);
      whole.depthOfB = std::max(whole.depthOfB, line.depthOfB);
      whole.wallEnds = std::max(whole.wallEnds, line.wallEnds);
      whole.furnitureEnds = std::max(whole.furnitureEnds, line.furnitureEnds);
      whole.bend = std::max(whole.bend, line.bend);
    }
    return joined;
  }

  /// The next place along a line; none where it ends.
  LinePlace following(const LinePlace& place, int side, int along) const {
    const uint32_t a = field_.squares[place.a].next[along];
    const uint32_t b = field_.squares[place.b].next[along];
    return a != kNoSquare && b != kNoSquare && field_.squares[a].next[side] == b ? LinePlace{a, b} : LinePlace{};
  }

  struct Beside {
    int away = 0;  ///< from the line
    double width = 0;
    std::vector<size_t> depths{};
    std::vector<float> slopes{};
  };

  static size_t medianOf(std::vector<size_t>& values) {
    std::nth_element(values.begin(), values.begin() + static_cast<long>(values.size() / 2), values.end());
    return values[values.size() / 2];
  }

  /// Goes away from the line, within the group of the square.
  void lookBeside(uint32_t square, size_t open, Beside& beside) const {
    const uint32_t group = groups_[pieces_.of[square]];
    size_t depth = 0;
    uint32_t last = square;
    for (uint32_t i = square; i != kNoSquare && groups_[pieces_.of[i]] == group; i = field_.squares[i].next[beside.away]) {
      if (depth < open) {
        beside.width = std::max(beside.width, widthOf(halfWidths_[i]));
        last = i;
      }
      ++depth;
    }
    beside.depths.push_back(depth);
    const auto steps = static_cast<float>(std::min(depth, open) - 1);
    const float rise = field_.squares[last].floor - field_.squares[square].floor;
    beside.slopes.push_back(steps > 0 ? rise / (steps * field_.cellSize) : 0);
  }

  bool isDeep(uint32_t square, int away, size_t depth) const {
    for (; square != kNoSquare && depth > 0; square = field_.squares[square].next[away]) {
      --depth;
    }
    return depth == 0;
  }

  /// How far floor goes on along the line beyond its end, half as deep as the line is long, or its piece.
  bool goesOnBeyond(uint32_t square, const Beside& beside, int along, size_t depth) const {
    size_t beyond = 0;
    size_t steps = 0;
    for (uint32_t i = square; i != kNoSquare && steps < depth; i = field_.squares[i].next[beside.away]) {
      const uint32_t k = field_.squares[i].next[along];
      beyond += k != kNoSquare && field_.squares[k].next[along] != kNoSquare ? 1 : 0;  // walls are out by a square
      ++steps;
    }
    return 2 * beyond > steps;
  }

  /// Whether what stands at the end of a line reaches up to the ceiling. Under the open sky all does.
  bool endsAtWall(const LinePlace& last, int along) const {
    for (const uint32_t end : {last.a, last.b}) {
      const uint32_t beyond = field_.squares[end].next[along];
      const WalkSquare& square = field_.squares[beyond == kNoSquare ? end : beyond];
      if (square.ceiling == kNoCeiling || square.wallTop > square.ceiling - field_.cellSize) {
        return true;
      }
    }
    return false;
  }

  PieceLine lineFrom(const LinePlace& begin, int side) {
    PieceLine line;
    line.a = pieces_.of[begin.a];
    line.b = pieces_.of[begin.b];
    line.side = side;
    const std::array<int, 2> alongs{(side + 1) % 4, (side + 3) % 4};
    std::vector<LinePlace> touching{begin};
    std::array<LinePlace, 2> ends{begin, begin};
    for (const size_t way : {size_t{0}, size_t{1}}) {
      for (LinePlace at = following(begin, side, alongs[way]);
           at.a != kNoSquare && pieces_.of[at.a] == line.a && pieces_.of[at.b] == line.b;
           at = following(at, side, alongs[way])) {
        touching.push_back(at);
        ends[way] = at;
      }
    }
    line.touching = touching.size();
    Beside besideA{(side + 2) % 4};
    Beside besideB{side};
    for (const LinePlace& at : touching) {
      isSeen_[at.a] |= static_cast<uint8_t>(1 << side);
      lookBeside(at.a, line.touching, besideA);
      lookBeside(at.b, line.touching, besideB);
    }
    line.widthOfA = besideA.width;
    line.widthOfB = besideB.width;
    line.depthOfA = medianOf(besideA.depths);
    line.depthOfB = medianOf(besideB.depths);
    const auto slopeOf = [](std::vector<float>& slopes) {
      std::nth_element(slopes.begin(), slopes.begin() + static_cast<long>(slopes.size() / 2), slopes.end());
      return slopes[slopes.size() / 2];
    };
    line.bend = std::abs(slopeOf(besideA.slopes) + slopeOf(besideB.slopes));
    // The free line goes on where floor beside it is half as deep as where the pieces touch.
    const size_t deepA = (std::min(line.depthOfA, line.touching) + 1) / 2;
    const size_t deepB = (std::min(line.depthOfB, line.touching) + 1) / 2;
    line.open = line.touching;
    for (const size_t way : {size_t{0}, size_t{1}}) {
      LinePlace last = ends[way];
      for (LinePlace at = following(last, side, alongs[way]);
           at.a != kNoSquare && isDeep(at.a, besideA.away, deepA) && isDeep(at.b, besideB.away, deepB);
           at = following(at, side, alongs[way])) {
        ++line.open;
        last = at;
      }
      if (goesOnBeyond(last.a, besideA, alongs[way], line.touching) ||
          goesOnBeyond(last.b, besideB, alongs[way], line.touching)) {
        ++(endsAtWall(last, alongs[way]) ? line.wallEnds : line.furnitureEnds);
      }
      line.first = std::min({line.first, last.a, last.b});
    }
    line.at = coordinateOf(field_, begin.a, side % 2 == 0) + (side == 1 || side == 2 ? 1 : 0);
    if (line.a > line.b) {
      std::swap(line.a, line.b);
      std::swap(line.widthOfA, line.widthOfB);
      std::swap(line.depthOfA, line.depthOfB);
      line.side = (side + 2) % 4;
    }
    return line;
  }

  const WalkField& field_;
  const std::vector<uint16_t>& halfWidths_;
  const WalkPieces& pieces_;
  const std::vector<uint32_t>& groups_;
  std::vector<uint8_t> isSeen_;  ///< a bit for each side
};

bool isAtEnd(const PieceLine& line, const WalkShape& shape) {
  return shape.isTunnel && (line.side % 2 == 0) == shape.isAlongX;
}

/// Where ways part or turn: of streets and corridors, the pieces with ways on sides that are not opposite.
std::vector<uint8_t> crossingsAmong(const std::vector<PieceLine>& lines, const WalkLayout& layout) {
  std::vector<std::array<uint8_t, 2>> hasWay(layout.pieces.count, std::array<uint8_t, 2>{0, 0});  // along x, along z
  for (const PieceLine& line : lines) {
    if (layout.shapes[line.a].isOfWays && layout.shapes[line.b].isOfWays) {
      hasWay[line.a][line.side % 2] = hasWay[line.b][line.side % 2] = 1;
    }
  }
  std::vector<uint8_t> isCrossing(layout.pieces.count, 0);
  for (uint32_t piece = 0; piece < layout.pieces.count; ++piece) {
    isCrossing[piece] = !layout.shapes[piece].isTunnel && hasWay[piece][0] != 0 && hasWay[piece][1] != 0;
  }
  return isCrossing;
}

/// Whether pieces go on in each other: nothing narrows or widens the passage, or furniture alone does.
bool goesOn(const PieceLine& line, const WalkLayout& layout, const std::vector<uint8_t>& isCrossing) {
  const bool isOfWays = layout.shapes[line.a].isOfWays && layout.shapes[line.b].isOfWays;
  if (line.bend > kSameSlope || (isOfWays && (isCrossing[line.a] != 0 || isCrossing[line.b] != 0))) {
    return false;
  }
  return (line.wallEnds == 0 && line.furnitureEnds > 0) ||
         static_cast<double>(line.open) >= kSameWidth * std::max(line.widthOfA, line.widthOfB);
}

bool isNiche(const PieceLine& line, const WalkLayout& layout, const std::vector<uint8_t>& isCrossing) {
  const WalkShape& a = layout.shapes[line.a];
  const WalkShape& b = layout.shapes[line.b];
  if (line.bend > kSameSlope || (a.isOfWays && b.isOfWays && (isCrossing[line.a] != 0 || isCrossing[line.b] != 0))) {
    return false;
  }
  const bool isANarrower = line.widthOfA <= line.widthOfB;
  const double width = isANarrower ? line.widthOfA : line.widthOfB;
  const size_t depth = isANarrower ? line.depthOfA : line.depthOfB;
  return static_cast<double>(line.open) >= kSameWidth * width && depth <= line.open &&
         !isAtEnd(line, isANarrower ? a : b);
}

std::vector<uint32_t> eachAlone(uint32_t count) {
  std::vector<uint32_t> groups(count);
  std::iota(groups.begin(), groups.end(), 0U);
  return groups;
}

using IsJoint = bool (*)(const PieceLine&, const WalkLayout&, const std::vector<uint8_t>&);

/// Pairs whose border is mostly of such lines.
void addBorders(const std::vector<PieceLine>& lines, const WalkLayout& layout, IsJoint isJoint,
                std::vector<PieceBorder>& borders) {
  const std::vector<uint8_t> isCrossing = crossingsAmong(lines, layout);
  for (size_t begin = 0; begin < lines.size();) {
    size_t all = 0;
    size_t joints = 0;
    size_t end = begin;
    for (; end < lines.size() && lines[end].a == lines[begin].a && lines[end].b == lines[begin].b; ++end) {
      all += lines[end].touching;
      joints += isJoint(lines[end], layout, isCrossing) ? lines[end].touching : 0;
    }
    if (2 * joints >= all) {
      borders.push_back({lines[begin].a, lines[begin].b, joints});
    }
    begin = end;
  }
}

}  // namespace

std::vector<PieceLine> pieceLines(const WalkField& field, const std::vector<uint16_t>& halfWidths,
                                  const WalkPieces& pieces, const std::vector<uint32_t>& groups) {
  return LineSearch(field, halfWidths, pieces, groups).lines();
}

std::vector<uint8_t> crossingsOfWays(const WalkField& field, const std::vector<uint16_t>& halfWidths,
                                     const WalkLayout& layout) {
  return crossingsAmong(pieceLines(field, halfWidths, layout.pieces, eachAlone(layout.pieces.count)), layout);
}

std::vector<PieceBorder> straightJoints(const WalkField& field, const std::vector<uint16_t>& halfWidths,
                                        const WalkLayout& layout) {
  std::vector<PieceBorder> borders;
  addBorders(pieceLines(field, halfWidths, layout.pieces, eachAlone(layout.pieces.count)), layout, goesOn, borders);
  return borders;
}

std::vector<PieceBorder> jointBorders(const WalkField& field, const std::vector<uint16_t>& halfWidths,
                                      const WalkLayout& layout) {
  std::vector<PieceBorder> borders = straightJoints(field, halfWidths, layout);
  DisjointSets sets(layout.pieces.count);
  for (const PieceBorder& border : borders) {
    sets.join(border.a, border.b);
  }
  std::vector<uint32_t> groups(layout.pieces.count);
  for (uint32_t piece = 0; piece < layout.pieces.count; ++piece) {
    groups[piece] = sets.least(piece);
  }
  addBorders(pieceLines(field, halfWidths, layout.pieces, groups), layout, isNiche, borders);
  return borders;
}

}  // namespace ocelli
