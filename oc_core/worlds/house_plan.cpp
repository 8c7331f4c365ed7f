#include "oc_core/worlds/house_plan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "oc_core/base/check.h"
#include "oc_core/base/random.h"
#include "oc_core/worlds/house_furnishing.h"
#include "oc_core/worlds/palette.h"

namespace ocelli {
namespace {

constexpr float kMinRoomWidth = 3.0f;
constexpr float kMaxRoomWidth = 5.6f;
constexpr float kLandingBelow = 1.3f;  // before the first step
constexpr float kLandingAbove = 1.5f;  // behind the last one
constexpr float kStairRun = kStairTread * kStairSteps;
constexpr float kStairwellWidth = kLandingBelow + kStairRun + kLandingAbove;
constexpr float kDoorToCorner = 0.35f;  // of a doorway from the walls beside it, at least
constexpr float kWindowSill = 0.9f;
constexpr float kWindowTop = 2.1f;
constexpr float kTerraceDepth = 3;

glm::vec3 floorColorOf(HouseRoomKind kind) {
  switch (kind) {
    case HouseRoomKind::kHall:
    case HouseRoomKind::kCorridor:
    case HouseRoomKind::kStairwell:
      return palette::fromSrgbBytes(206, 186, 160);
    case HouseRoomKind::kLiving:
    case HouseRoomKind::kDining:
    case HouseRoomKind::kStudy:
      return palette::fromSrgbBytes(190, 140, 96);
    case HouseRoomKind::kBedroom:
      return palette::fromSrgbBytes(120, 150, 190);
    case HouseRoomKind::kKitchen:
      return palette::fromSrgbBytes(226, 196, 120);
    case HouseRoomKind::kBathroom:
      return palette::fromSrgbBytes(150, 200, 210);
  }
  return glm::vec3(1);
}

class HousePlanner {
 public:
  explicit HousePlanner(const HouseOptions& options) : random_(options.seed) {
    const int drawn = random_.below(3) == 0 ? 1 : 2;
    plan_.storeys = options.storeys == 0 ? drawn : options.storeys;
  }

  HousePlan plan() {
    const float halfX = random_.inRange(6.8f, 9);
    northDepth_ = random_.inRange(4.2f, 5.6f);
    southDepth_ = random_.inRange(4.2f, 5.6f);
    corridor_ = random_.inRange(1.5f, 2.1f);
    const float halfZ = (northDepth_ + southDepth_ + corridor_) / 2 + kInnerWall;
    plan_.inside = {{-halfX, -halfZ}, {halfX, halfZ}};
    stairsInWest_ = random_.below(2) == 0;
    static const std::vector<glm::vec3> wallColors{palette::fromSrgbBytes(240, 214, 168),
                                                   palette::fromSrgbBytes(226, 170, 150),
                                                   palette::fromSrgbBytes(170, 206, 214)};
    plan_.wallColor = wallColors[random_.below(wallColors.size())];
    plan_.roofColor = random_.below(2) == 0 ? palette::brick() : palette::slate();
    for (int storey = 0; storey < plan_.storeys; ++storey) {
      addStorey(storey);
    }
    for (size_t room = 0; room < plan_.rooms.size(); ++room) {
      furnishRoom(plan_, room, random_);
    }
    return std::move(plan_);
  }

 private:
  float north() const { return plan_.inside.lower.y; }
  float south() const { return plan_.inside.upper.y; }
  float corridorNorth() const { return north() + northDepth_ + kInnerWall; }
  float corridorSouth() const { return corridorNorth() + corridor_; }

  size_t addRoom(HouseRoomKind kind, int storey, const HouseRectangle& area) {
    plan_.rooms.push_back({kind, storey, area, floorColorOf(kind)});
    return plan_.rooms.size() - 1;
  }

  size_t addHouseWall(int storey, bool isAlongX, float from, float to, float middle, float thickness = kInnerWall) {
    plan_.walls.push_back({storey, isAlongX, from, to, middle, thickness, thickness == kOuterWall, {}});
    return plan_.walls.size() - 1;
  }

  /// An opening in a wall with a door at the middle `along` it; `sign` says to which side of the wall `from` lies, +1
  /// is the one of greater x or z.
  void addDoor(size_t wallNumber, float along, float halfWidth, float sign, size_t from, size_t to) {
    HouseWall& wall = plan_.walls[wallNumber];
    HouseDoor door;
    door.from = from;
    door.to = to;
    door.halfWidth = halfWidth;
    door.wall = wall.thickness;
    const float floor = kFloorToFloor * static_cast<float>(wall.storey);
    door.place = wall.isAlongX ? glm::vec3(along, floor, wall.middle) : glm::vec3(wall.middle, floor, along);
    door.normal = wall.isAlongX ? glm::vec3(0, 0, sign) : glm::vec3(sign, 0, 0);
    wall.openings.push_back({along - halfWidth, along + halfWidth, 0, kInnerDoorHeight, false});
    if (halfWidth < 0.55f && random_.below(5) < 3) {
      door.hasLeaf = true;
      // It hangs at one side of the opening, at the face of the wall.
      const float hinge = along + (random_.below(2) == 0 ? -halfWidth - 0.03f : halfWidth + 0.03f);
      const float face = wall.middle + sign * wall.thickness / 2;
      const float end = face + sign * (2 * halfWidth - 0.05f);
      const float low = std::min(face, end);
      const float high = std::max(face, end);
      door.leaf = wall.isAlongX ? HouseRectangle{{hinge - 0.03f, low}, {hinge + 0.03f, high}}
                                : HouseRectangle{{low, hinge - 0.03f}, {high, hinge + 0.03f}};
    }
    plan_.doors.push_back(door);
  }

  /// Windows of about equal distances in the part of an outer wall that a room has.
  void addWindows(size_t wallNumber, float from, float to) {
    HouseWall& wall = plan_.walls[wallNumber];
    const int windows = std::max(1, static_cast<int>((to - from) / 2.4f));
    for (int i = 0; i < windows; ++i) {
      const float middle = from + (to - from) * (static_cast<float>(i) + 0.5f) / static_cast<float>(windows);
      const float half = std::min(0.65f, (to - from) / 2 - 0.3f);
      const bool isFree = std::none_of(wall.openings.begin(), wall.openings.end(), [&](const HouseOpening& other) {
        return other.from < middle + half + 0.3f && middle - half - 0.3f < other.to;
      });
      if (isFree) {
        wall.openings.push_back({middle - half, middle + half, kWindowSill, kWindowTop, true});
      }
    }
  }

  /// Widths of rooms side by side with walls between them.
  std::vector<HouseRectangle> divideStrip(float from, float to, float z0, float z1) {
    std::vector<HouseRectangle> rooms;
    while (true) {
      const float left = to - from;
      float width = random_.inRange(kMinRoomWidth, kMaxRoomWidth);
      if (left - width - kInnerWall < kMinRoomWidth) {
        width = left <= kMaxRoomWidth + 0.6f ? left : (left - kInnerWall) / 2;
      }
      rooms.push_back({{from, z0}, {width == left ? to : from + width, z1}});
      if (width == left) {
        return rooms;
      }
      from += width + kInnerWall;
    }
  }

  HouseRoomKind drawKind(int storey) {
    static constexpr std::array kBelow{HouseRoomKind::kLiving, HouseRoomKind::kDining, HouseRoomKind::kKitchen,
                                       HouseRoomKind::kStudy};
    static constexpr std::array kAbove{HouseRoomKind::kBedroom, HouseRoomKind::kBedroom, HouseRoomKind::kStudy,
                                       HouseRoomKind::kLiving};
    const size_t next = drawn_++;
    // Of a house of one storey every other room is one to sleep in.
    const bool isAbove = storey > 0 || (plan_.storeys == 1 && next % 2 == 1);
    return isAbove ? kAbove[next / 2 % kAbove.size()] : kBelow[next % kBelow.size()];
  }

  void addStorey(int storey) {
    const float west = plan_.inside.lower.x;
    const float east = plan_.inside.upper.x;
    const size_t corridor =
        addRoom(HouseRoomKind::kCorridor, storey, {{west, corridorNorth()}, {east, corridorSouth()}});
    const float outX = kOuterWall / 2;
    outerNorth_ = addHouseWall(storey, true, west - kOuterWall, east + kOuterWall, north() - outX, kOuterWall);
    outerSouth_ = addHouseWall(storey, true, west - kOuterWall, east + kOuterWall, south() + outX, kOuterWall);
    outerWest_ = addHouseWall(storey, false, north(), south(), west - outX, kOuterWall);
    outerEast_ = addHouseWall(storey, false, north(), south(), east + outX, kOuterWall);
    addWindows(outerWest_, corridorNorth(), corridorSouth());
    addWindows(outerEast_, corridorNorth(), corridorSouth());
    const size_t northWall = addHouseWall(storey, true, west, east, corridorNorth() - kInnerWall / 2);
    const size_t southWall = addHouseWall(storey, true, west, east, corridorSouth() + kInnerWall / 2);

    float from = west;
    float to = east;
    if (plan_.storeys > 1) {
      const float start = stairsInWest_ ? west : east - kStairwellWidth;
      addStairwell(storey, start, corridor, northWall);
      (stairsInWest_ ? from : to) = stairsInWest_ ? start + kStairwellWidth + kInnerWall : start - kInnerWall;
      addHouseWall(storey, false, north(), corridorNorth() - kInnerWall,
                   stairsInWest_ ? from - kInnerWall / 2 : to + kInnerWall / 2);
    }
    addStrip(storey, divideStrip(from, to, north(), corridorNorth() - kInnerWall), -1, corridor, northWall);
    addStrip(storey, divideStrip(west, east, corridorSouth() + kInnerWall, south()), 1, corridor, southWall);
  }

  void addStairwell(int storey, float west, size_t corridor, size_t corridorWall) {
    const HouseRectangle area{{west, north()}, {west + kStairwellWidth, corridorNorth() - kInnerWall}};
    const size_t room = addRoom(HouseRoomKind::kStairwell, storey, area);
    if (storey == 0) {
      HouseStairs stairs;
      stairs.risesEast = random_.below(2) == 0;
      const float start = west + (stairs.risesEast ? kLandingBelow : kLandingAbove);
      stairs.area = {{start, north()}, {start + kStairRun, north() + kStairWidth}};
      plan_.stairs = stairs;
    }
    addDoor(corridorWall, random_.inRange(area.lower.x + 1, area.upper.x - 1), random_.inRange(0.46f, 0.52f), -1, room,
            corridor);
    addWindows(outerNorth_, area.lower.x, area.upper.x);
  }

  /// Rooms north (`sign` -1) or south (+1) of the corridor.
  void addStrip(int storey, const std::vector<HouseRectangle>& areas, float sign, size_t corridor,
                size_t corridorWall) {
    const bool hasHall = storey == 0 && sign > 0;
    const size_t hall = hasHall ? random_.below(areas.size()) : areas.size();
    std::vector<size_t> rooms;  // those at the corridor
    for (size_t i = 0; i < areas.size(); ++i) {
      const HouseRoomKind kind = i == hall ? HouseRoomKind::kHall : drawKind(storey);
      const size_t room = addRoom(kind, storey, areas[i]);
      rooms.push_back(room);
      const float half = i == hall ? 0.8f : random_.inRange(kMinDoorWidth / 2, 0.52f);
      const float margin = half + kDoorToCorner;
      addDoor(corridorWall, random_.inRange(areas[i].lower.x + margin, areas[i].upper.x - margin), half, sign, room,
              corridor);
      if (i == hall) {
        enter(room, areas[i]);
      }
      if (i > 0) {
        const size_t wall =
            addHouseWall(storey, false, areas[i].lower.y, areas[i].upper.y, areas[i].lower.x - kInnerWall / 2);
        // Some rooms are open to their neighbours.
        if (i != hall && i - 1 != hall && random_.below(3) == 0) {
          const float middle = areas[i].center().y + (sign > 0 ? -0.8f : 0.8f);
          addDoor(wall, middle, random_.inRange(0.5f, 0.8f), 1, room, rooms[i - 1]);
        }
      }
      const bool isDeep = areas[i].size().y >= 4.6f && areas[i].size().x <= 4.4f;
      if (i != hall && isDeep && random_.below(2) == 0) {
        splitOff(storey, room, sign);
      }
      addWindows(sign < 0 ? outerNorth_ : outerSouth_, areas[i].lower.x, areas[i].upper.x);
      if (i == 0 && areas[i].lower.x == plan_.inside.lower.x) {
        addWindows(outerWest_, plan_.rooms[room].area.lower.y, plan_.rooms[room].area.upper.y);
      }
      if (i + 1 == areas.size() && areas[i].upper.x == plan_.inside.upper.x) {
        addWindows(outerEast_, plan_.rooms[room].area.lower.y, plan_.rooms[room].area.upper.y);
      }
    }
  }

  /// The front door and the terrace before it.
  void enter(size_t hall, const HouseRectangle& area) {
    const float x = random_.inRange(area.lower.x + 1, area.upper.x - 1);
    addDoor(outerSouth_, x, 0.52f, -1, hall, kOutdoors);
    std::rotate(plan_.doors.begin(), plan_.doors.end() - 1, plan_.doors.end());
    const float front = plan_.inside.upper.y + kOuterWall;
    plan_.terrace = {{x - 2, front}, {x + 2, front + kTerraceDepth}};
  }

  /// The outer part of a room becomes a bathroom, which is reached through it.
  void splitOff(int storey, size_t room, float sign) {
    HouseRectangle& area = plan_.rooms[room].area;
    const float depth = random_.inRange(1.8f, 2.1f);
    HouseRectangle behind = area;
    float middle = 0;
    if (sign < 0) {
      behind.upper.y = area.lower.y + depth;
      middle = behind.upper.y + kInnerWall / 2;
      area.lower.y = behind.upper.y + kInnerWall;
    } else {
      behind.lower.y = area.upper.y - depth;
      middle = behind.lower.y - kInnerWall / 2;
      area.upper.y = behind.lower.y - kInnerWall;
    }
    const HouseRectangle front = area;
    const size_t bath = addRoom(HouseRoomKind::kBathroom, storey, behind);
    const size_t wall = addHouseWall(storey, true, front.lower.x, front.upper.x, middle);
    const float half = kMinDoorWidth / 2;
    const float margin = half + kDoorToCorner;
    addDoor(wall, random_.inRange(front.lower.x + margin, front.upper.x - margin), half, sign, bath, room);
  }

  Random random_;
  HousePlan plan_;
  float northDepth_ = 0;
  float southDepth_ = 0;
  float corridor_ = 0;
  bool stairsInWest_ = true;
  size_t outerNorth_ = 0;
  size_t outerSouth_ = 0;
  size_t outerWest_ = 0;
  size_t outerEast_ = 0;
  size_t drawn_ = 0;
};

}  // namespace

HousePlan planHouse(const HouseOptions& options) {
  OC_CHECK(options.storeys >= 0 && options.storeys <= 2, "storeys are checked by their reader");
  return HousePlanner(options).plan();
}

}  // namespace ocelli
