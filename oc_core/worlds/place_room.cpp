#include "oc_core/worlds/place_room.h"

#include <algorithm>

#include "oc_core/worlds/palette.h"
#include "oc_core/worlds/placement.h"

namespace ocelli {
namespace {

constexpr float kWallThickness = 0.2f;
constexpr float kIntoWall = 0.1f;    // how far walls and floors reach into one another
constexpr float kIntoFloor = 0.05f;  // how far walls reach into the floor and the ceiling

float lengthOf(const PlaceRoom& room, RoomSide side) {
  const bool isAlongX = side == RoomSide::kNorth || side == RoomSide::kSouth;
  return isAlongX ? room.upper.x - room.lower.x : room.upper.y - room.lower.y;
}

}  // namespace

glm::mat4 worldFromSide(const PlaceRoom& room, RoomSide side) {
  switch (side) {
    case RoomSide::kNorth:
      return placedAt({room.lower.x, 0, room.lower.y});
    case RoomSide::kSouth:
      return placedAt({room.upper.x, 0, room.upper.y}, 180);
    case RoomSide::kWest:
      return placedAt({room.lower.x, 0, room.upper.y}, 90);
    case RoomSide::kEast:
      return placedAt({room.upper.x, 0, room.lower.y}, -90);
  }
  return {};
}

void addRoom(PlaceBuilder& place, const PlaceRoom& room) {
  const glm::vec2 size = room.upper - room.lower;
  const glm::vec2 middle = (room.upper + room.lower) * 0.5f;
  const glm::vec3 slab(size.x + 2 * kIntoWall, 0.1f, size.y + 2 * kIntoWall);
  BoxLook floor = BoxLook(room.floor).finer(1.15f).stretched({1, 10, 1});
  BoxLook ceiling = BoxLook(room.ceiling).finer(2.2f).stretched({1, 10, 1});
  for (const BoxFace face : {BoxFace::kLeft, BoxFace::kRight, BoxFace::kBack, BoxFace::kFront}) {
    floor.plain(face);
    ceiling.plain(face);
  }
  place.addBox(slab, placedAt({middle.x, -0.05f, middle.y}), floor.plain(BoxFace::kBottom));
  place.addBox(slab, placedAt({middle.x, room.height + 0.05f, middle.y}), ceiling.plain(BoxFace::kTop));
  for (const RoomSide side : {RoomSide::kNorth, RoomSide::kSouth, RoomSide::kWest, RoomSide::kEast}) {
    const RoomSideLook& look = room.sides[static_cast<size_t>(side)];
    if (!look.texture) {
      continue;
    }
    PlaceWall wall;
    wall.size = {lengthOf(room, side) + 2 * kIntoWall, room.height + 2 * kIntoFloor};
    wall.thickness = kWallThickness;
    wall.front = wall.rim = wall.back = look.texture;
    wall.fineness = 1.45f;
    wall.isBackPlain = true;
    const glm::vec2 corner(kIntoWall, kIntoFloor);
    for (const RoomOpening& o : look.openings) {
      wall.openings.push_back({glm::vec2(o.left, o.bottom) + corner, glm::vec2(o.right, o.top) + corner});
    }
    place.addWall(wall, worldFromSide(room, side) * placedAt({-kIntoWall, -kIntoFloor, 0}));
  }
}

void addSkirting(PlaceBuilder& place, const PlaceRoom& room, RoomSide side, const std::vector<glm::vec2>& gaps,
                 const SurfaceTexture& texture) {
  std::vector<float> ends{-0.02f};
  for (const glm::vec2& gap : gaps) {
    ends.insert(ends.end(), {gap.x, gap.y});
  }
  ends.push_back(lengthOf(room, side) + 0.02f);
  // Those of the sides along x stand out a little more, so that no two end in one plane in a corner.
  const bool isAlongX = side == RoomSide::kNorth || side == RoomSide::kSouth;
  const float out = isAlongX ? 0.018f : 0.015f;
  const float height = isAlongX ? 0.09f : 0.088f;
  for (size_t i = 0; i + 1 < ends.size(); i += 2) {
    const float length = ends[i + 1] - ends[i];
    place.addBox({length, height + 0.01f, out + 0.01f},
                 worldFromSide(room, side) * placedAt({ends[i] + length / 2, height / 2 - 0.005f, out / 2 - 0.005f}),
                 BoxLook(texture).plain(BoxFace::kBack).plain(BoxFace::kBottom).noShadow());
  }
}

void addCeilingLamps(PlaceBuilder& place, float ceiling, const std::vector<glm::vec2>& places, const glm::vec2& size,
                     const glm::vec3& power) {
  uint32_t seed = 400;
  for (const glm::vec2& p : places) {
    constexpr float kBelow = 0.05f;
    place.addBox({size.x + 0.05f, kBelow, size.y + 0.05f}, placedAt({p.x, ceiling - kBelow / 2 + 0.01f, p.y}),
                 BoxLook(metalTexture(glm::vec3(0.6f), ++seed)).plain(BoxFace::kTop).noShadow());
    place.addBox({size.x, 0.02f, size.y}, placedAt({p.x, ceiling - kBelow + 0.007f, p.y}),
                 BoxLook(glowTexture({1, 0.98f, 0.93f}, ++seed)).plain(BoxFace::kTop).finer(2).glowing(1).noShadow());
    place.light().addLamp(
        {{p.x, ceiling - kBelow - 0.01f, p.y}, {size.x / 2, 0, 0}, {0, 0, size.y / 2}, {0, -1, 0}, power});
  }
}

void addClosedDoor(PlaceBuilder& place, const glm::mat4& m, float middle, const glm::vec3& color, uint32_t seed) {
  constexpr float kHigh = 2.08f;
  constexpr float kWide = 0.92f;
  const glm::mat4 door = m * placedAt({middle, 0, 0});
  const SurfaceTexture wood = uprightWoodTexture(color, seed);
  const SurfaceTexture frame = uprightWoodTexture(color * 0.75f, seed + 1);
  place.addBox({kWide, kHigh, 0.04f}, door * placedAt({0, kHigh / 2 - 0.01f, 0}), BoxLook(wood).plain(BoxFace::kBack));
  for (const float side : {-1.0f, 1.0f}) {
    place.addBox({0.09f, kHigh + 0.09f, 0.07f}, door * placedAt({side * (kWide / 2 + 0.03f), kHigh / 2 + 0.03f, 0}),
                 BoxLook(frame).plain(BoxFace::kBack).noShadow());
  }
  place.addBox({kWide + 0.14f, 0.085f, 0.066f}, door * placedAt({0, kHigh + 0.03f, 0}),
               BoxLook(woodTexture(color * 0.75f, seed + 2)).plain(BoxFace::kBack).noShadow());
  for (const float y : {0.6f, 1.55f}) {
    place.addBox({kWide - 0.3f, 0.7f, 0.02f}, door * placedAt({0, y, 0.018f}),
                 BoxLook(wood).plain(BoxFace::kBack).noShadow());
  }
  const SurfaceTexture metal = metalTexture(palette::fromSrgbBytes(190, 180, 160), seed + 3);
  const glm::vec3 at = glm::vec3(door * glm::vec4(kWide / 2 - 0.08f, 1.05f, 0.015f, 1));
  const glm::vec3 out = glm::vec3(door * glm::vec4(kWide / 2 - 0.08f, 1.05f, 0.07f, 1));
  const glm::vec3 end = glm::vec3(door * glm::vec4(kWide / 2 - 0.2f, 1.05f, 0.07f, 1));
  place.addTube({at, out, end}, 0.011f, metal);
}

}  // namespace ocelli
