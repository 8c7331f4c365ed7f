// Where people can walk in a scene: rooms, crossings and the tunnels between them, and the openings through which one
// goes from one to the next. It is the "maze" of section 4.3.1.4 for any scene: upright boxes of any size, and tunnels
// of four faces whose cross sections are modulated with rings. Constructors of graph cameras build on it.
//
// A room that no single box fits, such as one with two wings, is several cells: the openings between those are joints.
//
// Cells, openings, parts and rooms count from 0, in files, plans and messages too.
//
// Frame and units are those of the scene; y is up.
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "oc_core/scene/portal.h"

namespace ocelli {

/// A cross section of a tunnel: an upright rectangle across its axis.
struct WalkRing {
  float along = 0;    ///< from the beginning of the cell, along its axis
  float left = 0;     ///< from the axis to the left wall, at least 0; left is that of someone who walks along the axis
  float right = 0;    ///< to the right wall
  float ceiling = 0;  ///< over the floor

  bool operator==(const WalkRing&) const = default;
};

enum class WalkCellKind : uint8_t {
  kRoom,    ///< a room, a crossing, or a turn
  kTunnel,  ///< a corridor or a street: it has its openings at both ends, and may have others along its walls
};

/// A piece of walkable floor with the space over it: an upright box, turned about the vertical.
struct WalkCell {
  WalkCellKind kind = WalkCellKind::kRoom;
  glm::vec3 center{0};       ///< on the floor, where one can stand
  glm::vec3 axis{0, 0, -1};  ///< level unit vector; that of its length
  float halfLength = 0.5f;   ///< along the axis
  float halfWidth = 0.5f;    ///< across it
  float height = 2;     ///< from the floor to the ceiling; where there is none, the height of what stands around it
  float floorRise = 0;  ///< of the floor from the beginning to the end of its axis, as of stairs and slopes
  std::vector<WalkRing> rings;  ///< of a tunnel, at least two, in order along the axis; of a room none

  /// Level, to the right of someone who looks along the axis.
  glm::vec3 right() const { return {-axis.z, 0, axis.x}; }

  bool operator==(const WalkCell&) const = default;
};

/// The opening between two cells, level or not: whoever goes from cell `from` to cell `to` goes through it.
struct WalkPortal {
  uint32_t from = 0;  ///< of WalkMap::cells
  uint32_t to = 0;
  Portal opening;        ///< seen from within `from`: its normal points into that cell
  bool isJoint = false;  ///< where two boxes of one room meet: nothing stands at its sides, and one sees through freely

  /// The same, for who comes the other way.
  WalkPortal reversed() const {
    return {to, from, {opening.center, -opening.normal, -opening.halfRight, opening.halfUp}, isJoint};
  }
};

struct WalkMap {
  std::vector<WalkCell> cells;
  std::vector<WalkPortal> portals;  ///< each opening once
  /// Of each cell, the number of the part of the scene that one can reach from it: cells of one number are connected.
  std::vector<uint32_t> partOfCell;
  /// Of each cell, the number of its room, or of its street or crossing: joints lead to the other cells of that number.
  std::vector<uint32_t> roomOfCell;
  /// How far beyond the sides of cells walls and ceilings may lie, at most: of maps that were found from a scene, whose
  /// cells end before what stands along walls. 0: cells end at the walls.
  float toWalls = 0;

  size_t partCount() const;
  size_t roomCount() const;
  /// Openings that are no joints.
  size_t openingCount() const;
};

/// Fills in partOfCell and roomOfCell from the portals, in the order of the cells.
void numberCells(WalkMap& map);

/// "cell 7": what messages and plans call it.
std::string nameOfCell(size_t cell);
/// "opening 7", of WalkMap::portals.
std::string nameOfOpening(size_t portal);

/// The same map where the transform of its scene puts it: a uniform scale and a translation.
WalkMap moved(const WalkMap& map, const glm::mat4& newFromOld);

}  // namespace ocelli
