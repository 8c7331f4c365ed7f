// How well a walk map agrees with one that is known: floor, rooms and openings that both have, that one lacks, and that
// one has alone. For tests and measurements of what is found from geometry, and for maps that were edited by hand.
//
// Rooms (WalkMap::roomOfCell) are compared as their boxes seen from above, on one level where their floors differ by
// less than `levelStep`. Two rooms match where they share the share `roomOverlap` of the area that either covers
// (intersection over union); two openings match where their middles on the floor lie nearer together than
// `openingReach` and their normals agree to 45 degrees. Each one matches one other at most, the best pairs first.
// Joints within rooms are no openings.
//
// Of the found map only the part counts that has the most floor in common with the known one: roofs, and the insides of
// what is closed, are floors for who finds them, and out of reach.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "oc_core/scene/walk_map.h"

namespace ocelli {

struct WalkAgreementRules {
  double roomOverlap = 0.3;
  double openingReach = 1;  ///< in units of the scene, or half of the width of the known opening where that is more
  double levelStep = 1;     ///< units of the scene
};

/// Numbers are those of WalkMap::cells, roomOfCell and portals.
struct WalkAgreement {
  static constexpr uint32_t kNone = 0xffffffffu;

  std::vector<uint32_t> foundOfRoom;     ///< of each known room the found one that matches, or kNone
  std::vector<uint32_t> foundOfPortal;   ///< of each known portal; kNone of joints
  std::vector<uint32_t> reached;         ///< the found cells of the part that counts
  std::vector<uint32_t> reachedRooms;    ///< their rooms
  std::vector<uint32_t> reachedPortals;  ///< their portals, joints among them
  size_t reachedOpenings = 0;            ///< how many of these are no joints
  double knownArea = 0;
  double reachedArea = 0;   ///< of the found cells that count
  double coveredShare = 0;  ///< of the known floor, what found cells cover
  double knownShare = 0;    ///< of the found floor, what known cells cover
  size_t otherCells = 0;    ///< of the found map: those of other parts

  size_t matchedRooms() const;
  size_t matchedPortals() const;
};

/// Both maps in the same frame, with their cells numbered (numberCells()).
WalkAgreement compareWalkMaps(const WalkMap& known, const WalkMap& found, const WalkAgreementRules& rules = {});

}  // namespace ocelli
