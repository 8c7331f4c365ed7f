// The truth of where one can walk in `builtin:house`, from its plan.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "oc_core/base/check.h"
#include "oc_core/worlds/house_plan.h"
#include "oc_core/worlds/plan_walk.h"

namespace ocelli {
namespace {

constexpr float kOpenAir = 3;       // height of the cell before the front door, which has no ceiling
constexpr float kHouseEyes = 1.6f;  // over the floor

class HouseWalks {
 public:
  explicit HouseWalks(const HousePlan& plan) : plan_(plan) {}

  WalkMap map() {
    map_.cells.push_back(levelCell(WalkCellKind::kRoom, plan_.terrace.lower, plan_.terrace.upper, 0, kOpenAir));
    std::vector<std::vector<uint32_t>> cellsOfRoom;
    for (const HouseRoom& room : plan_.rooms) {
      cellsOfRoom.push_back(addRoomCells(room));
    }
    for (const HouseDoor& door : plan_.doors) {
      const uint32_t from = cellAt(cellsOfRoom[door.from], door.place + door.normal * door.wall);
      const uint32_t to = door.to == kOutdoors ? 0 : cellAt(cellsOfRoom[door.to], door.place - door.normal * door.wall);
      map_.portals.push_back({from, to, uprightOpening(door.place, door.normal, door.halfWidth, door.height)});
    }
    if (plan_.stairs) {
      addFlight(*plan_.stairs, cellsOfRoom);
    }
    numberCells(map_);
    return std::move(map_);
  }

 private:
  uint32_t addCell(WalkCellKind kind, const HouseRectangle& area, float floor) {
    map_.cells.push_back(levelCell(kind, area.lower, area.upper, floor, kRoomHeight));
    return static_cast<uint32_t>(map_.cells.size() - 1);
  }

  std::vector<uint32_t> addRoomCells(const HouseRoom& room) {
    if (room.kind == HouseRoomKind::kStairwell) {
      // One room: what is beside the flight, before its first step and behind its last one.
      const HouseRectangle& flight = plan_.stairs->area;
      const uint32_t beside =
          addCell(WalkCellKind::kRoom, {{room.area.lower.x, flight.upper.y}, room.area.upper}, room.floor());
      const uint32_t west =
          addCell(WalkCellKind::kRoom, {room.area.lower, {flight.lower.x, flight.upper.y}}, room.floor());
      const uint32_t east =
          addCell(WalkCellKind::kRoom, {{flight.upper.x, room.area.lower.y}, {room.area.upper.x, flight.upper.y}},
                  room.floor());
      for (const uint32_t landing : {west, east}) {
        const CellFootprint area = footprintOf(map_.cells[landing]);
        const glm::vec3 place((area.lower.x + area.upper.x) / 2, room.floor(), area.upper.y);
        map_.portals.push_back(
            {beside, landing, uprightOpening(place, {0, 0, 1}, (area.upper.x - area.lower.x) / 2, kRoomHeight), true});
      }
      return {beside, west, east};
    }
    const bool isTunnel = room.kind == HouseRoomKind::kCorridor;
    const uint32_t cell = addCell(isTunnel ? WalkCellKind::kTunnel : WalkCellKind::kRoom, room.area, room.floor());
    if (isTunnel) {
      addStraightRings(map_.cells[cell]);
    }
    return {cell};
  }

  static void addStraightRings(WalkCell& cell) {
    for (const float along : {0.0f, 2 * cell.halfLength}) {
      cell.rings.push_back({along, cell.halfWidth, cell.halfWidth, cell.height});
    }
  }

  uint32_t cellAt(const std::vector<uint32_t>& cells, const glm::vec3& place) const {
    for (const uint32_t cell : cells) {
      const CellFootprint area = footprintOf(map_.cells[cell]);
      if (area.lower.x <= place.x && place.x <= area.upper.x && area.lower.y <= place.z && place.z <= area.upper.y) {
        return cell;
      }
    }
    OC_CHECK(false, "a door opens to the rooms that it names");
    return 0;
  }

  void addFlight(const HouseStairs& stairs, const std::vector<std::vector<uint32_t>>& cellsOfRoom) {
    const uint32_t flight = addCell(WalkCellKind::kTunnel, stairs.area, kFloorToFloor / 2);
    WalkCell& cell = map_.cells[flight];
    cell.axis = {stairs.risesEast ? 1.0f : -1.0f, 0, 0};
    cell.floorRise = kFloorToFloor;
    addStraightRings(cell);
    for (size_t room = 0; room < plan_.rooms.size(); ++room) {
      if (plan_.rooms[room].kind != HouseRoomKind::kStairwell) {
        continue;
      }
      const bool isBelow = plan_.rooms[room].storey == 0;
      const bool inWest = isBelow == stairs.risesEast;
      const HouseRectangle& area = stairs.area;
      const glm::vec3 place(inWest ? area.lower.x : area.upper.x, plan_.rooms[room].floor(), area.center().y);
      map_.portals.push_back({cellsOfRoom[room][inWest ? 1 : 2], flight,
                              uprightOpening(place, {inWest ? -1.0f : 1.0f, 0, 0}, kStairWidth / 2, kRoomHeight)});
    }
  }

  const HousePlan& plan_;
  WalkMap map_;
};

}  // namespace

WalkMap houseWalkMap(const HousePlan& plan) {
  return HouseWalks(plan).map();
}

std::vector<Portal> housePortals(const HousePlan& plan) {
  std::vector<Portal> portals;
  for (const HouseDoor& door : plan.doors) {
    for (const glm::vec3& normal : {door.normal, -door.normal}) {
      portals.push_back(uprightOpening(door.place, normal, door.halfWidth, door.height));
    }
  }
  return portals;
}

std::vector<glm::vec3> housePath(const HousePlan& plan) {
  const WalkMap map = houseWalkMap(plan);
  return lineOfWay(map, wayThroughCells(map, 0, farthestCell(map, 0)), kHouseEyes);
}

}  // namespace ocelli
