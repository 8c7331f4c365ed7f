#include "oc_core/worlds/house_furnishing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

#include "oc_core/worlds/palette.h"

namespace ocelli {
namespace {

constexpr float kGrid = 0.1f;            // metres
constexpr float kDoorZone = 1.0f;        // depth of what stays free before a doorway
constexpr float kDoorStep = 0.5f;        // from the face of a wall to where one stands in a doorway
constexpr float kBetweenPieces = 0.05f;  // gap
constexpr int kTries = 24;

/// What is put into a room, in order; a piece that finds no place is left out.
std::vector<FurnitureKind> piecesOf(HouseRoomKind kind) {
  using enum FurnitureKind;
  switch (kind) {
    case HouseRoomKind::kHall:
      return {kWardrobe, kPlant};
    case HouseRoomKind::kCorridor:
    case HouseRoomKind::kStairwell:
      return {};
    case HouseRoomKind::kLiving:
      return {kSofa, kShelf, kSofa, kTable, kPlant};
    case HouseRoomKind::kDining:
      return {kTable, kShelf, kPlant};
    case HouseRoomKind::kKitchen:
      return {kCounter, kCounter, kTable, kChair};
    case HouseRoomKind::kBedroom:
      return {kBed, kWardrobe, kDesk, kChair};
    case HouseRoomKind::kStudy:
      return {kDesk, kShelf, kShelf, kSofa, kPlant};
    case HouseRoomKind::kBathroom:
      return {kBathtub, kToilet};
  }
  return {};
}

/// A door as one of its two rooms has it.
struct RoomDoor {
  glm::vec2 face;  ///< the middle of its opening in the face of the wall
  glm::vec2 into;  ///< unit
  float halfWidth;
};

std::vector<RoomDoor> doorsOf(const HousePlan& plan, size_t room) {
  std::vector<RoomDoor> doors;
  for (const HouseDoor& door : plan.doors) {
    if (door.from != room && door.to != room) {
      continue;
    }
    const glm::vec2 into = glm::vec2(door.normal.x, door.normal.z) * (door.from == room ? 1.0f : -1.0f);
    doors.push_back({glm::vec2(door.place.x, door.place.z) + into * (door.wall / 2), into, door.halfWidth});
  }
  return doors;
}

HouseRectangle grown(const HouseRectangle& area, float by) {
  return {area.lower - by, area.upper + by};
}

/// What stays free before a doorway.
HouseRectangle zoneOf(const RoomDoor& door) {
  const glm::vec2 beside(std::abs(door.into.y), std::abs(door.into.x));
  const glm::vec2 end = door.face + door.into * kDoorZone;
  const glm::vec2 half = beside * (door.halfWidth + 0.1f);
  return {glm::min(door.face, end) - half, glm::max(door.face, end) + half};
}

/// What stands in a room.
std::vector<HouseRectangle> obstaclesOf(const HousePlan& plan, size_t room) {
  std::vector<HouseRectangle> obstacles;
  for (const HouseFurniture& piece : plan.furniture) {
    if (piece.room == room) {
      obstacles.push_back(piece.area);
    }
  }
  for (const HouseDoor& door : plan.doors) {
    if (door.hasLeaf && door.from == room) {
      obstacles.push_back(door.leaf);
    }
  }
  return obstacles;
}

/// A piece against a wall of the room, which its back meets; nothing where it is too wide.
std::optional<HouseFurniture> againstWall(FurnitureKind kind, const HouseRectangle& room, Random& random) {
  const glm::vec2 size = furnitureSize(kind);
  const size_t side = random.below(4);  // its front looks to the south, east, north, west
  const bool isTurned = side % 2 == 1;
  const float along = isTurned ? room.size().y : room.size().x;
  if (along < size.x || (isTurned ? room.size().x : room.size().y) < size.y) {
    return {};
  }
  // Often in a corner.
  const size_t where = random.below(4);
  const float slack = along - size.x;
  const float offset = where == 0 ? 0 : where == 1 ? slack : random.inRange(0, slack);
  HouseFurniture piece;
  piece.kind = kind;
  piece.turnDegrees = 90 * static_cast<float>(side);
  constexpr float kGap = 0.02f;  // to the wall
  const float depth = size.y + kGap;
  switch (side) {
    case 0:
      piece.area = {{room.lower.x + offset, room.lower.y + kGap},
                    {room.lower.x + offset + size.x, room.lower.y + depth}};
      break;
    case 1:
      piece.area = {{room.lower.x + kGap, room.lower.y + offset},
                    {room.lower.x + depth, room.lower.y + offset + size.x}};
      break;
    case 2:
      piece.area = {{room.lower.x + offset, room.upper.y - depth},
                    {room.lower.x + offset + size.x, room.upper.y - kGap}};
      break;
    default:
      piece.area = {{room.upper.x - depth, room.lower.y + offset},
                    {room.upper.x - kGap, room.lower.y + offset + size.x}};
      break;
  }
  return piece;
}

std::optional<HouseFurniture> inMiddle(FurnitureKind kind, const HouseRectangle& room, Random& random) {
  const glm::vec2 size = furnitureSize(kind);
  const bool isTurned = room.size().y > room.size().x;
  const glm::vec2 half = (isTurned ? glm::vec2(size.y, size.x) : size) * 0.5f;
  const glm::vec2 space = room.size() * 0.5f - half - 0.8f;
  if (space.x < 0 || space.y < 0) {
    return {};
  }
  const glm::vec2 center = room.center() + glm::vec2(random.inRange(-0.3f, 0.3f), random.inRange(-0.3f, 0.3f)) *
                                               glm::min(space, glm::vec2(1));
  HouseFurniture piece;
  piece.kind = kind;
  piece.turnDegrees = isTurned ? 90.0f : 0.0f;
  piece.area = {center - half, center + half};
  return piece;
}

}  // namespace

glm::vec2 furnitureSize(FurnitureKind kind) {
  switch (kind) {
    case FurnitureKind::kBed:
      return {1.6f, 2.05f};
    case FurnitureKind::kWardrobe:
      return {1.4f, 0.6f};
    case FurnitureKind::kDesk:
      return {1.3f, 0.65f};
    case FurnitureKind::kChair:
      return {0.46f, 0.48f};
    case FurnitureKind::kSofa:
      return {1.9f, 0.85f};
    case FurnitureKind::kShelf:
      return {1.1f, 0.34f};
    case FurnitureKind::kCounter:
      return {1.8f, 0.62f};
    case FurnitureKind::kTable:
      return {1.6f, 0.9f};
    case FurnitureKind::kBathtub:
      return {1.65f, 0.75f};
    case FurnitureKind::kToilet:
      return {0.42f, 0.62f};
    case FurnitureKind::kPlant:
      return {0.5f, 0.5f};
  }
  return {1, 1};
}

bool isRoomWalkable(const HousePlan& plan, size_t room) {
  const HouseRectangle& area = plan.rooms[room].area;
  const auto columns = static_cast<size_t>(area.size().x / kGrid);
  const auto rows = static_cast<size_t>(area.size().y / kGrid);
  std::vector<HouseRectangle> obstacles = obstaclesOf(plan, room);
  for (HouseRectangle& obstacle : obstacles) {
    obstacle = grown(obstacle, kWalkerRadius);
  }
  const HouseRectangle free = grown(area, -kWalkerRadius);
  const auto placeOf = [&](size_t column, size_t row) {
    return area.lower +
           glm::vec2((static_cast<float>(column) + 0.5f) * kGrid, (static_cast<float>(row) + 0.5f) * kGrid);
  };
  const auto holds = [](const HouseRectangle& r, const glm::vec2& p) {
    return r.lower.x <= p.x && p.x <= r.upper.x && r.lower.y <= p.y && p.y <= r.upper.y;
  };
  std::vector<bool> isOpen(columns * rows);
  size_t open = 0;
  for (size_t row = 0; row < rows; ++row) {
    for (size_t column = 0; column < columns; ++column) {
      const glm::vec2 place = placeOf(column, row);
      isOpen[row * columns + column] =
          holds(free, place) &&
          std::none_of(obstacles.begin(), obstacles.end(), [&](const auto& o) { return holds(o, place); });
      open += isOpen[row * columns + column] ? 1 : 0;
    }
  }
  const std::vector<RoomDoor> doors = doorsOf(plan, room);
  const auto cellOf = [&](const RoomDoor& door) {
    const glm::vec2 place = (door.face + door.into * kDoorStep - area.lower) / kGrid;
    return static_cast<size_t>(place.y) * columns + static_cast<size_t>(place.x);
  };
  std::vector<size_t> front{cellOf(doors.front())};
  if (!isOpen[front[0]]) {
    return false;
  }
  size_t reached = 0;
  std::vector<bool> isReached(isOpen.size());
  isReached[front[0]] = true;
  while (!front.empty()) {
    const size_t cell = front.back();
    front.pop_back();
    ++reached;
    const size_t column = cell % columns;
    const size_t row = cell / columns;
    const auto visit = [&](bool isInside, size_t next) {
      if (isInside && isOpen[next] && !isReached[next]) {
        isReached[next] = true;
        front.push_back(next);
      }
    };
    visit(column > 0, cell - 1);
    visit(column + 1 < columns, cell + 1);
    visit(row > 0, cell - columns);
    visit(row + 1 < rows, cell + columns);
  }
  return reached == open &&
         std::all_of(doors.begin(), doors.end(), [&](const RoomDoor& door) { return isReached[cellOf(door)]; });
}

void furnishRoom(HousePlan& plan, size_t room, Random& random) {
  static const std::array colors{palette::vermilion(), palette::blue(),   palette::green(),
                                 palette::yellow(),    palette::purple(), palette::orange()};
  const HouseRoom& where = plan.rooms[room];
  // Open leaves that stand in one another's way are taken off.
  for (HouseDoor& door : plan.doors) {
    if (door.from == room && door.hasLeaf && !isRoomWalkable(plan, room)) {
      door.hasLeaf = false;
    }
  }
  const std::vector<RoomDoor> doors = doorsOf(plan, room);
  for (const FurnitureKind kind : piecesOf(where.kind)) {
    for (int attempt = 0; attempt < kTries; ++attempt) {
      std::optional<HouseFurniture> piece =
          kind == FurnitureKind::kTable ? inMiddle(kind, where.area, random) : againstWall(kind, where.area, random);
      if (!piece) {
        continue;
      }
      const bool meetsDoor = std::any_of(doors.begin(), doors.end(),
                                         [&](const RoomDoor& door) { return zoneOf(door).meets(piece->area); });
      const std::vector<HouseRectangle> others = obstaclesOf(plan, room);
      const HouseRectangle around = grown(piece->area, kBetweenPieces);
      if (meetsDoor || std::any_of(others.begin(), others.end(), [&](const auto& o) { return o.meets(around); })) {
        continue;
      }
      piece->room = room;
      piece->color = colors[random.below(colors.size())];
      const glm::vec2 center = piece->area.center();
      piece->position = {center.x, where.floor(), center.y};
      plan.furniture.push_back(*piece);
      if (isRoomWalkable(plan, room)) {
        break;
      }
      plan.furniture.pop_back();
    }
  }
}

}  // namespace ocelli
