// The straight lines along which pieces of floor touch (walk_joints.h).
#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "oc_core/walkable/walk_extent.h"
#include "oc_core/walkable/walk_joints.h"

namespace ocelli {
namespace {

/// Two squares on both sides of a line.
struct LinePlace {
  uint32_t a = kNoSquare;
  uint32_t b = kNoSquare;
};

/// One side of a line.
struct LineSide {
  int away = 0;  ///< from the line
  double width = 0;
  std::vector<size_t> depths{};

  size_t depth() {
    std::nth_element(depths.begin(), depths.begin() + static_cast<long>(depths.size() / 2), depths.end());
    return depths[depths.size() / 2];
  }
};

class LineSearch {
 public:
  LineSearch(const JointSearch& search, const WalkPieces& pieces, const std::vector<uint32_t>& groups)
      : field_(search.field),
        halfWidths_(search.halfWidths),
        pieces_(pieces),
        groups_(groups),
        thickness_(thicknesses(search.field, pieces)),
        isSeen_(field_.squares.size(), 0) {}

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
  /// Lines of two pieces that look the same way are one, which obstacles part, or which a facade shifts.
  static std::vector<PieceLine> inOne(const std::vector<PieceLine>& lines) {
    std::vector<PieceLine> joined;
    for (const PieceLine& line : lines) {
      const bool goesOn =
          !joined.empty() && joined.back().a == line.a && joined.back().b == line.b && joined.back().side == line.side;
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
      whole.hasLintel = whole.hasLintel || line.hasLintel;
    }
    return joined;
  }

  /// The next place along a line; none where it ends.
  LinePlace following(const LinePlace& place, int side, int along) const {
    const uint32_t a = field_.squares[place.a].next[along];
    const uint32_t b = field_.squares[place.b].next[along];
    return a != kNoSquare && b != kNoSquare && field_.squares[a].next[side] == b ? LinePlace{a, b} : LinePlace{};
  }

  /// Goes away from the line, within the group of the square.
  void lookBeside(uint32_t square, size_t length, LineSide& beside) const {
    const uint32_t group = groups_[pieces_.of[square]];
    size_t depth = 0;
    for (uint32_t i = square; i != kNoSquare && groups_[pieces_.of[i]] == group;
         i = field_.squares[i].next[beside.away]) {
      if (depth < length) {
        beside.width = std::max(beside.width, widthOf(halfWidths_[i]));
      }
      ++depth;
    }
    beside.depths.push_back(depth);
  }

  bool isDeep(uint32_t square, int away, size_t depth) const {
    for (; square != kNoSquare && depth > 0; square = field_.squares[square].next[away]) {
      --depth;
    }
    return depth == 0;
  }

  /// Whether floor beside the line mostly goes on beyond its end.
  bool goesOnBeyond(uint32_t square, const LineSide& beside, int along, size_t depth) const {
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

  /// The lowest ceiling within a distance from the line, and that at the end of it.
  std::pair<float, float> ceilingsBeside(uint32_t square, int away, size_t depth) const {
    float lowest = kNoCeiling;
    float last = kNoCeiling;
    for (uint32_t i = square; i != kNoSquare && depth > 0; i = field_.squares[i].next[away]) {
      last = field_.squares[i].ceiling;
      lowest = std::min(lowest, last);
      --depth;
    }
    return {lowest, last};
  }

  bool isUnderLintel(const std::vector<LinePlace>& touching, int awayA, int awayB) const {
    return std::all_of(touching.begin(), touching.end(), [&](const LinePlace& at) {
      const auto [lowestA, lastA] = ceilingsBeside(at.a, awayA, touching.size());
      const auto [lowestB, lastB] = ceilingsBeside(at.b, awayB, touching.size());
      return std::min(lowestA, lowestB) < std::min(lastA, lastB) - field_.cellSize;
    });
  }

  PieceLine lineFrom(const LinePlace& begin, int side) {
    PieceLine line;
    line.a = pieces_.of[begin.a];
    line.b = pieces_.of[begin.b];
    line.side = side;
    line.at = coordinateOf(field_, begin.a, side % 2 == 0);
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
    LineSide besideA{(side + 2) % 4, widthOf(thickness_[line.a])};
    LineSide besideB{side, widthOf(thickness_[line.b])};
    for (const LinePlace& at : touching) {
      isSeen_[at.a] |= static_cast<uint8_t>(1 << side);
      lookBeside(at.a, line.touching, besideA);
      lookBeside(at.b, line.touching, besideB);
    }
    line.widthOfA = besideA.width;
    line.widthOfB = besideB.width;
    line.depthOfA = besideA.depth();
    line.depthOfB = besideB.depth();
    line.hasLintel = isUnderLintel(touching, besideA.away, besideB.away);
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
  std::vector<uint16_t> thickness_;
  std::vector<uint8_t> isSeen_;  ///< a bit for each side
};

}  // namespace

std::vector<PieceLine> pieceLines(const JointSearch& search, const WalkPieces& pieces,
                                  const std::vector<uint32_t>& groups) {
  return LineSearch(search, pieces, groups).lines();
}

}  // namespace ocelli
