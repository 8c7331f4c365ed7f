// What the toolkit makes of a city or a house that it knows nothing of but triangles: where one can walk
// (oc_core/walkable), compared with the plan that the scene was built from, and what the comprehensive camera
// (section 4.3.2.2) then shows of it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "oc_core/constructor/walk_comprehensive.h"
#include "oc_core/scene/mesh.h"
#include "oc_core/scene/walk_map.h"
#include "oc_core/walkable/walk_agreement.h"

namespace ocelli::bench {

/// A scene to walk in, in metres, and what its plan knows.
struct WalkScene {
  std::string source;
  Mesh mesh;
  WalkMap known;
};

WalkScene cityToWalk(uint64_t seed, float size);
WalkScene houseToWalk(uint64_t seed);

/// Of a cell of the found map in the comprehensive image.
struct SeenCell {
  uint32_t cell = 0;
  size_t pixels = 0;    ///< that show the middle of its floor (middleOf()), by ray casting
  double expected = 0;  ///< the same without what stands before it, by the camera
  std::string why;      ///< there are fewer than asked for; empty where there are enough
};

struct WalkAcceptance {
  WalkMap found;
  WalkAgreement agreement;
  std::vector<SeenCell> cells;  ///< of those that can be reached; none where no image was asked for
  size_t frusta = 0;
  double findMilliseconds = 0;
  double cameraMilliseconds = 0;

  size_t seenCells() const;
  /// Rooms of which the largest box is seen.
  size_t seenRooms() const;
};

/// An image of that size, none where it is 0 pixels wide; the middle of a cell is seen where as many pixels as the
/// options want show it.
WalkAcceptance acceptWalks(const WalkScene& scene, int width, int height, const WalkComprehensiveOptions& options = {});

}  // namespace ocelli::bench
