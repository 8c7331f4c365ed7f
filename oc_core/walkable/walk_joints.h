// Which pieces of floor are parts of one room. Where two of them meet at a joint, nothing changes from one to the
// other, or one is a niche of the other. An opening, such as a door or the mouth of a street, narrows the passage; the
// edge of a wardrobe does not.
#pragma once

#include <cstdint>
#include <vector>

#include "oc_core/walkable/walk_strips.h"

namespace ocelli {

/// What pieces are joined by.
struct JointSearch {
  const WalkField& field;
  const std::vector<uint16_t>& halfWidths;  ///< of each square (walk_width.h)
  float agentHeight = 0;                    ///< in units of the field
};

/// The line along which two pieces touch on one side, and the free line that it is a part of, which may go on between
/// other pieces. Lengths are in squares. Floor below obstacles is free: one sees over it.
struct PieceLine {
  uint32_t a = 0;  ///< pieces; the lower number
  uint32_t b = 0;
  int side = 0;         ///< of the squares of `a`
  size_t touching = 0;  ///< how long a and b touch along it
  size_t open = 0;      ///< how long the free line is, from wall to wall
  /// The side of the largest free square that fits into a, or into b, or covers floor of it no farther from the line
  /// than that is long.
  double widthOfA = 0;
  double widthOfB = 0;
  size_t depthOfA = 0;  ///< how deep the group of a is, away from the line: the median
  size_t depthOfB = 0;
  /// At how many ends of the free line floor goes on beside it, so that something ends or narrows it: a wall, or
  /// furniture, which does not reach the ceiling.
  int wallEnds = 0;
  int furnitureEnds = 0;
  bool hasLintel = false;      ///< the ceiling is lower there than on both sides, as in a door or an arch
  int at = 0;                  ///< the coordinate of the line
  uint32_t first = kNoSquare;  ///< the lowest square beside the ends of the free line
};

/// All lines of all pairs of pieces, in order of a, b and side. `groups` are numbers of pieces that go on in each
/// other.
std::vector<PieceLine> pieceLines(const JointSearch& search, const WalkPieces& pieces,
                                  const std::vector<uint32_t>& groups);

/// Of streets and corridors, the pieces where ways part or turn.
std::vector<uint8_t> crossingsOfWays(const JointSearch& search, const WalkLayout& layout);

/// Pairs of pieces that go on in each other, as jointBorders() says.
std::vector<PieceBorder> straightJoints(const JointSearch& search, const WalkLayout& layout);

/// Pairs of pieces that touch along joints for half of their border at least, and how long these are.
///
/// A joint is a line that is four fifths (kSameWidth) as wide, from wall to wall, as the pieces on both sides: these go
/// on in each other. So is one that is as wide as the narrower one, where that is no deeper, with what it goes on in,
/// than the line is long: a niche. Tunnels have no niches at their ends, which are mouths. What furniture alone narrows
/// is a joint, however narrow. So is the longest border of a pocket: a piece smaller than a square as wide as the agent
/// is high, and open for a third of its border, such as what is between a tree and a wall.
///
/// There is none under a lintel, none between what is inside of a house and what is outside, none at the ends of
/// stairs, and none where streets or corridors come to a crossing or a turn.
std::vector<PieceBorder> jointBorders(const JointSearch& search, const WalkLayout& layout);

}  // namespace ocelli
