// Which pieces of floor are parts of one room. Where two of them meet at a joint, nothing changes from one to the other,
// or one is a niche of the other. An opening, such as a door or the mouth of a street, narrows the passage; the edge of
// a wardrobe does not.
#pragma once

#include <cstdint>
#include <vector>

#include "oc_core/walkable/walk_strips.h"

namespace ocelli {

/// A straight line along which two pieces touch, and the free line that it is a part of, which may go on between other
/// pieces. Lengths are in squares. Floor below obstacles is free: one sees over it.
struct PieceLine {
  uint32_t a = 0;  ///< pieces; the lower number
  uint32_t b = 0;
  int side = 0;         ///< of the squares of `a`
  size_t touching = 0;  ///< how long a and b touch along it
  size_t open = 0;      ///< how long the free line is, from wall to wall
  /// The side of the largest free square (walk_width.h) that covers floor of a, or of b, that is no farther from the
  /// line than `open`.
  double widthOfA = 0;
  double widthOfB = 0;
  size_t depthOfA = 0;  ///< how deep the group of a is, away from the line: the median
  size_t depthOfB = 0;
  /// At how many ends of the free line floor goes on beside it, so that something ends or narrows it: a wall, or
  /// furniture, which does not reach the ceiling.
  int wallEnds = 0;
  int furnitureEnds = 0;
  float bend = 0;        ///< by how much the slope of the floor differs on both sides, away from the line
  int at = 0;            ///< the coordinate of the line
  uint32_t first = kNoSquare;  ///< the lowest square beside the ends of the free line
};

/// All lines of all pairs of pieces, in order of a, b, side and place. `halfWidths` are those of walk_width.h; `groups`
/// are numbers of pieces that go on in each other.
std::vector<PieceLine> pieceLines(const WalkField& field, const std::vector<uint16_t>& halfWidths,
                                  const WalkPieces& pieces, const std::vector<uint32_t>& groups);

/// Of streets and corridors, the pieces where ways part or turn.
std::vector<uint8_t> crossingsOfWays(const WalkField& field, const std::vector<uint16_t>& halfWidths,
                                     const WalkLayout& layout);

/// Pairs of pieces that go on in each other, as jointBorders() says.
std::vector<PieceBorder> straightJoints(const WalkField& field, const std::vector<uint16_t>& halfWidths,
                                        const WalkLayout& layout);

/// Pairs of pieces that touch along joints for half of their border at least, and how long these are.
///
/// A joint is a line that is four fifths (kSameWidth) as wide, from wall to wall, as the pieces on both sides: these go
/// on in each other. So is one that is as wide as the narrower one, where that is no deeper, with what it goes on in,
/// than the line is long: a niche. Tunnels have no niches at their ends, which are
/// mouths. What furniture alone narrows is a joint, however narrow. Streets and corridors have no joints at crossings and turns, only at dead ends, and where they go straight
/// on.
std::vector<PieceBorder> jointBorders(const WalkField& field, const std::vector<uint16_t>& halfWidths,
                                      const WalkLayout& layout);

}  // namespace ocelli
