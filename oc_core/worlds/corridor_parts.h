// Walls, slabs and what hangs on walls of places along ways (place_builder.h): corridors, courts, shops. A wall runs
// from its start along its turn (placement.h); at a turn of 0 it runs towards +x, and its front faces +z.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "oc_core/worlds/place_builder.h"

namespace ocelli {

inline constexpr float kCorridorWallThickness = 0.2f;

struct CorridorWall {
  glm::vec2 start{0};  ///< x and z of the left end of its front
  double turnDegrees = 0;
  float length = 1;
  float height = 2.8f;
  SurfaceTexture front;
};
/// Reaches a little into the floor and the ceiling. Returns the frame of its front: x along it, y up, z out of it.
glm::mat4 addCorridorWall(PlaceBuilder& place, const CorridorWall& wall);

/// A horizontal slab 0.2 m thick; corners in (x, z).
struct CorridorSlab {
  glm::vec2 lower{0};
  glm::vec2 upper{1};
  float middle = 0;  ///< its height
  SurfaceTexture texture;
  bool isFloor = true;
};
void addCorridorSlab(PlaceBuilder& place, const CorridorSlab& slab);

struct OnWall {
  float along;  ///< metres from the left end of the wall
  glm::vec2 size;
  bool isFramed;  ///< a picture in a frame; else a poster
};
/// Each is an object of its own.
void hangOn(PlaceBuilder& place, const glm::mat4& worldFromWall, const std::vector<OnWall>& list, uint32_t seed);

}  // namespace ocelli
