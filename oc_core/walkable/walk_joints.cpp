#include "oc_core/walkable/walk_joints.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "oc_core/base/disjoint_sets.h"

namespace ocelli {
namespace {

// In heights of the agent: floors of one room differ by less than that in the middle. A flight of stairs from storey to
// storey, of 2.5 m at least, has its middle higher by 1.2 m.
constexpr float kSameLevel = 0.5f;
// Of the border of a pocket. A closet of 0.9 by 1.2 m with a door of 0.8 m is open for 0.2 of its border.
constexpr double kOpenPocket = 1.0 / 3;

bool isAtEnd(const PieceLine& line, const WalkShape& shape) {
  return shape.isTunnel && (line.side % 2 == 0) == shape.isAlongX;
}

/// Where ways part or turn: of streets and corridors, the pieces with ways on sides that are not opposite.
std::vector<uint8_t> crossingsAmong(const std::vector<PieceLine>& lines, const WalkLayout& layout) {
  std::vector<std::array<uint8_t, 2>> hasWay(layout.pieces.count, std::array<uint8_t, 2>{0, 0});  // along x, along z
  for (const PieceLine& line : lines) {
    if (layout.shapes[line.a].isOfWays && layout.shapes[line.b].isOfWays && !line.hasLintel) {
      hasWay[line.a][line.side % 2] = hasWay[line.b][line.side % 2] = 1;
    }
  }
  std::vector<uint8_t> isCrossing(layout.pieces.count, 0);
  for (uint32_t piece = 0; piece < layout.pieces.count; ++piece) {
    isCrossing[piece] = !layout.shapes[piece].isTunnel && hasWay[piece][0] != 0 && hasWay[piece][1] != 0;
  }
  return isCrossing;
}

std::vector<uint32_t> eachAlone(uint32_t count) {
  std::vector<uint32_t> groups(count);
  std::iota(groups.begin(), groups.end(), 0U);
  return groups;
}

/// Of each piece: the median.
std::vector<float> floorsOf(const WalkField& field, const WalkPieces& pieces) {
  std::vector<std::vector<float>> all(pieces.count);
  for (size_t i = 0; i < pieces.of.size(); ++i) {
    all[pieces.of[i]].push_back(field.squares[i].floor);
  }
  std::vector<float> floors;
  for (std::vector<float>& values : all) {
    std::nth_element(values.begin(), values.begin() + static_cast<long>(values.size() / 2), values.end());
    floors.push_back(values[values.size() / 2]);
  }
  return floors;
}

/// Whether a piece mostly lies under a ceiling that is lower than twice the agent's height, as inside of a house.
std::vector<uint8_t> areInside(const JointSearch& search, const WalkPieces& pieces) {
  std::vector<size_t> covered(pieces.count, 0);
  for (size_t i = 0; i < pieces.of.size(); ++i) {
    const WalkSquare& square = search.field.squares[i];
    covered[pieces.of[i]] += square.ceiling - square.floor < 2 * search.agentHeight ? 1 : 0;
  }
  const std::vector<size_t> sizes = pieces.sizes();
  std::vector<uint8_t> isInside(pieces.count, 0);
  for (uint32_t piece = 0; piece < pieces.count; ++piece) {
    isInside[piece] = 2 * covered[piece] > sizes[piece];
  }
  return isInside;
}

/// What joints depend on, of one layout.
class Joints {
 public:
  Joints(const JointSearch& search, const WalkLayout& layout, const std::vector<uint32_t>& groups)
      : search_(search),
        layout_(layout),
        lines_(pieceLines(search, layout.pieces, groups)),
        isCrossing_(crossingsAmong(lines_, layout)),
        floors_(floorsOf(search.field, layout.pieces)),
        isInside_(areInside(search, layout.pieces)) {}

  const std::vector<uint8_t>& isCrossing() const { return isCrossing_; }

  /// Pairs whose border is mostly of lines that fulfil a condition.
  std::vector<PieceBorder> borders(bool (Joints::*isJoint)(const PieceLine&) const) const {
    std::vector<PieceBorder> borders;
    for (size_t begin = 0; begin < lines_.size();) {
      size_t all = 0;
      size_t joints = 0;
      size_t end = begin;
      for (; end < lines_.size() && lines_[end].a == lines_[begin].a && lines_[end].b == lines_[begin].b; ++end) {
        all += lines_[end].touching;
        joints += mayJoin(lines_[end]) && (this->*isJoint)(lines_[end]) ? lines_[end].touching : 0;
      }
      if (2 * joints >= all) {
        borders.push_back({lines_[begin].a, lines_[begin].b, joints});
      }
      begin = end;
    }
    return borders;
  }

  /// Whether nothing narrows or widens the passage, or furniture alone does.
  bool goesOn(const PieceLine& line) const {
    return (line.wallEnds == 0 && line.furnitureEnds > 0) ||
           static_cast<double>(line.open) >= kSameWidth * std::max(line.widthOfA, line.widthOfB);
  }

  bool isAny(const PieceLine&) const { return true; }

  bool isNiche(const PieceLine& line) const {
    const bool isANarrower = line.widthOfA <= line.widthOfB;
    const uint32_t niche = isANarrower ? line.a : line.b;
    const double width = isANarrower ? line.widthOfA : line.widthOfB;
    const size_t depth = isANarrower ? line.depthOfA : line.depthOfB;
    return static_cast<double>(line.open) >= kSameWidth * width && depth <= line.open && isCrossing_[niche] == 0 &&
           !isAtEnd(line, layout_.shapes[niche]);
  }

  /// Of each pocket, its longest border that may be a joint.
  std::vector<PieceBorder> pockets() const {
    const WalkField& field = search_.field;
    std::vector<size_t> around(layout_.pieces.count, 0);  // sides of squares: all, and those that are open
    std::vector<size_t> open(layout_.pieces.count, 0);
    for (uint32_t i = 0; i < field.squares.size(); ++i) {
      const uint32_t piece = layout_.pieces.of[i];
      for (const uint32_t k : field.squares[i].next) {
        const bool isInside = k != kNoSquare && layout_.pieces.of[k] == piece;
        around[piece] += isInside ? 0 : 1;
        open[piece] += !isInside && k != kNoSquare ? 1 : 0;
      }
    }
    const std::vector<size_t> sizes = layout_.pieces.sizes();
    const double largest = std::pow(search_.agentHeight / field.cellSize, 2);
    std::vector<PieceBorder> longest(layout_.pieces.count);
    for (const PieceBorder& border : borders(&Joints::isAny)) {
      for (const uint32_t piece : {border.a, border.b}) {
        longest[piece] = border.length > longest[piece].length ? border : longest[piece];
      }
    }
    std::vector<PieceBorder> pockets;
    for (uint32_t piece = 0; piece < layout_.pieces.count; ++piece) {
      if (static_cast<double>(sizes[piece]) < largest && longest[piece].length > 0 &&
          static_cast<double>(open[piece]) >= kOpenPocket * static_cast<double>(around[piece])) {
        pockets.push_back(longest[piece]);
      }
    }
    return pockets;
  }

 private:
  bool mayJoin(const PieceLine& line) const {
    const WalkShape& a = layout_.shapes[line.a];
    const WalkShape& b = layout_.shapes[line.b];
    const bool areWays = a.isOfWays && b.isOfWays;
    const bool isBesideTunnel = (a.isTunnel && !isAtEnd(line, a)) || (b.isTunnel && !isAtEnd(line, b));
    return !line.hasLintel && isInside_[line.a] == isInside_[line.b] &&
           std::abs(floors_[line.a] - floors_[line.b]) <= kSameLevel * search_.agentHeight &&
           !(areWays && !isBesideTunnel && (isCrossing_[line.a] != 0 || isCrossing_[line.b] != 0));
  }

  const JointSearch& search_;
  const WalkLayout& layout_;
  std::vector<PieceLine> lines_;
  std::vector<uint8_t> isCrossing_;
  std::vector<float> floors_;  ///< of each piece
  std::vector<uint8_t> isInside_;
};

}  // namespace

std::vector<uint8_t> crossingsOfWays(const JointSearch& search, const WalkLayout& layout) {
  return Joints(search, layout, eachAlone(layout.pieces.count)).isCrossing();
}

std::vector<PieceBorder> straightJoints(const JointSearch& search, const WalkLayout& layout) {
  return Joints(search, layout, eachAlone(layout.pieces.count)).borders(&Joints::goesOn);
}

std::vector<PieceBorder> jointBorders(const JointSearch& search, const WalkLayout& layout) {
  std::vector<PieceBorder> borders = straightJoints(search, layout);
  DisjointSets sets(layout.pieces.count);
  for (const PieceBorder& border : borders) {
    sets.join(border.a, border.b);
  }
  std::vector<uint32_t> groups(layout.pieces.count);
  for (uint32_t piece = 0; piece < layout.pieces.count; ++piece) {
    groups[piece] = sets.least(piece);
  }
  const Joints grouped(search, layout, groups);
  for (const std::vector<PieceBorder>& more : {grouped.borders(&Joints::isNiche), grouped.pockets()}) {
    borders.insert(borders.end(), more.begin(), more.end());
  }
  return borders;
}

}  // namespace ocelli
