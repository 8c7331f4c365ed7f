// The plan of `builtin:house`: a dwelling of one or two storeys, in metres. x runs to the east, z to the south, y up;
// the floor of the ground storey is y = 0, and the front door is in the south. Rectangles are given by their corners in
// (x, z).
//
// A corridor runs through each storey from the west to the east with rooms on both sides of it, some with a smaller one
// behind. The stairs lie in a room of their own. What is random follows from the seed.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <optional>
#include <vector>

#include "oc_core/scene/portal.h"
#include "oc_core/scene/walk_map.h"

namespace ocelli {

struct HouseOptions {
  uint64_t seed = 1;
  int storeys = 0;  ///< 1 or 2; 0: one or two, as the seed has it
};

inline constexpr float kRoomHeight = 2.7f;  ///< from the floor to the ceiling
inline constexpr float kFloorToFloor = 3.0f;
inline constexpr float kOuterWall = 0.3f;   ///< thickness
inline constexpr float kInnerWall = 0.15f;  ///< thickness
inline constexpr float kInnerDoorHeight = 2.05f;
inline constexpr float kMinDoorWidth = 0.9f;
inline constexpr float kStairWidth = 1.1f;
inline constexpr int kStairSteps = 17;
inline constexpr float kStairTread = 0.28f;  ///< from one step to the next; a step rises by kFloorToFloor / kStairSteps
inline constexpr size_t kOutdoors = std::numeric_limits<size_t>::max();  ///< instead of a room: before the front door

enum class HouseRoomKind : uint8_t {
  kHall,  ///< behind the front door
  kCorridor,
  kStairwell,
  kLiving,
  kDining,
  kKitchen,
  kBedroom,
  kStudy,
  kBathroom,
};

struct HouseRectangle {
  glm::vec2 lower{0};
  glm::vec2 upper{0};

  glm::vec2 size() const { return upper - lower; }
  glm::vec2 center() const { return (lower + upper) * 0.5f; }
  bool meets(const HouseRectangle& other) const {
    return lower.x < other.upper.x && other.lower.x < upper.x && lower.y < other.upper.y && other.lower.y < upper.y;
  }
};

struct HouseRoom {
  HouseRoomKind kind = HouseRoomKind::kLiving;
  int storey = 0;
  HouseRectangle area;  ///< between its walls
  glm::vec3 floorColor{1};
  float floor() const { return kFloorToFloor * static_cast<float>(storey); }
};

/// An opening of a wall: a doorway that reaches down to the floor, or a window.
struct HouseOpening {
  float from = 0;  ///< along the wall: x or z
  float to = 0;
  float bottom = 0;  ///< over the floor of the storey
  float top = 2;
  bool isWindow = false;
};

/// A wall of one storey from `from` to `to` along x or z, around `middle` across.
struct HouseWall {
  int storey = 0;
  bool isAlongX = true;
  float from = 0;
  float to = 0;
  float middle = 0;
  float thickness = kInnerWall;
  bool isOuter = false;  ///< its height is that of a storey with the floor above; that of others a room's
  std::vector<HouseOpening> openings;
};

struct HouseDoor {
  size_t from = 0;          ///< of HousePlan::rooms
  size_t to = kOutdoors;    ///< likewise, or kOutdoors; a door has its leaf, if any, in `from`
  glm::vec3 place{0};       ///< on the floor in the middle of the opening and of the wall
  glm::vec3 normal{0};      ///< level, into `from`
  float wall = kInnerWall;  ///< thickness
  float halfWidth = 0.5f;
  float height = kInnerDoorHeight;
  bool hasLeaf = false;
  /// Where an open leaf stands: at a right angle to the wall.
  HouseRectangle leaf{};
};

enum class FurnitureKind : uint8_t {
  kBed,
  kWardrobe,
  kDesk,
  kChair,
  kSofa,
  kShelf,
  kCounter,
  kTable,
  kBathtub,
  kToilet,
  kPlant,
};

struct HouseFurniture {
  FurnitureKind kind = FurnitureKind::kTable;
  size_t room = 0;
  glm::vec3 position{0};  ///< of its middle, on the floor
  float turnDegrees = 0;  ///< 0, 90, 180 or 270; its front looks to +z where it is 0
  glm::vec3 color{1};
  HouseRectangle area;  ///< that it takes of the floor
};

/// A flight from the ground storey to the one above.
struct HouseStairs {
  HouseRectangle area;
  bool risesEast = true;
};

struct HousePlan {
  int storeys = 1;
  HouseRectangle inside;  ///< of the outer walls
  std::vector<HouseRoom> rooms;
  std::vector<HouseWall> walls;
  std::vector<HouseDoor> doors;  ///< the front door first
  std::vector<HouseFurniture> furniture;
  std::optional<HouseStairs> stairs;
  HouseRectangle terrace;  ///< before the front door, level with the floor
  glm::vec3 wallColor{1};
  glm::vec3 roofColor{1};
};

/// Width (along x) and depth of a piece of furniture that looks to +z.
glm::vec2 furnitureSize(FurnitureKind kind);

HousePlan planHouse(const HouseOptions& options);

/// Where one can walk: first the terrace, then rooms, corridors as tunnels, and the flight of stairs as a tunnel that
/// rises; a stairwell is three cells around the flight. This is the truth that what is found from the mesh is compared
/// with; guides do not give it. Furniture is not left out.
WalkMap houseWalkMap(const HousePlan& plan);

/// The doorways of all storeys, each as seen from either side.
std::vector<Portal> housePortals(const HousePlan& plan);

/// A walk at the height of eyes from the terrace to the cell that the most doors part from it.
std::vector<glm::vec3> housePath(const HousePlan& plan);

}  // namespace ocelli
