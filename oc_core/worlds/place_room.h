// The walls, floor, ceiling and lamps of a place (place_builder.h).
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "oc_core/worlds/place_builder.h"

namespace ocelli {

enum class RoomSide : size_t { kNorth, kSouth, kWest, kEast };  ///< at the least z, most z, least x, most x

/// An upright rectangle of a side: from left to right as one within the room sees it, from the room's left corner.
struct RoomOpening {
  float left, right, bottom, top;
};

struct RoomSideLook {
  SurfaceTexture texture;
  std::vector<RoomOpening> openings;
};

/// An upright box of room, walls 0.2 m thick around it.
struct PlaceRoom {
  glm::vec2 lower{0};  ///< x and z
  glm::vec2 upper{1};
  float height = 3;
  std::array<RoomSideLook, 4> sides;  ///< by RoomSide
  SurfaceTexture floor;
  SurfaceTexture ceiling;
};
void addRoom(PlaceBuilder& place, const PlaceRoom& room);

/// The frame of a side: its origin in the room's lower left corner of it, z into the room.
glm::mat4 worldFromSide(const PlaceRoom& room, RoomSide side);

/// Boards along the foot of a side, but for `gaps` from left to right.
void addSkirting(PlaceBuilder& place, const PlaceRoom& room, RoomSide side, const std::vector<glm::vec2>& gaps,
                 const SurfaceTexture& texture);

/// Panels of light below the ceiling, at (x, z).
void addCeilingLamps(PlaceBuilder& place, float ceiling, const std::vector<glm::vec2>& places, const glm::vec2& size,
                     const glm::vec3& power);

/// A closed door with a frame, in a wall, around (`middle`, 0) of a side's frame.
void addClosedDoor(PlaceBuilder& place, const glm::mat4& worldFromSide, float middle, const glm::vec3& color,
                   uint32_t seed);

}  // namespace ocelli
