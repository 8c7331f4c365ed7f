#include "tests/constructor/walk_maps.h"

#include <algorithm>
#include <array>
#include <glm/ext/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

namespace ocelli::test {
namespace {

glm::vec3 vectorTo(glm::vec2 direction) {
  return {direction.x, 0, direction.y};
}

/// Where a door lies between two boxes, and the direction in which one goes through.
struct DoorPlace {
  glm::vec2 middle{0};
  glm::vec2 direction{0};
};

DoorPlace placeOf(const PlanCell& from, const PlanCell& to, const PlanDoor& door) {
  if (from.eastSouth.x <= to.westNorth.x) {
    return {{(from.eastSouth.x + to.westNorth.x) / 2, door.along}, {1, 0}};
  }
  if (to.eastSouth.x <= from.westNorth.x) {
    return {{(to.eastSouth.x + from.westNorth.x) / 2, door.along}, {-1, 0}};
  }
  if (from.eastSouth.y <= to.westNorth.y) {
    return {{door.along, (from.eastSouth.y + to.westNorth.y) / 2}, {0, 1}};
  }
  return {{door.along, (to.eastSouth.y + from.westNorth.y) / 2}, {0, -1}};
}

bool isAlongX(const PlanCell& cell) {
  const glm::vec2 size = cell.eastSouth - cell.westNorth;
  return size.x >= size.y;
}

float floorAt(const PlanCell& cell, glm::vec2 point) {
  const glm::vec2 share = (point - cell.westNorth) / (cell.eastSouth - cell.westNorth) - 0.5f;
  return cell.floor + cell.floorRise * (isAlongX(cell) ? share.x : share.y);
}

class HouseMesh {
 public:
  /// A quadrilateral in pieces of half a metre, so that its colours tell places apart.
  void quad(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& d, const glm::vec3& color) {
    const int across = std::max(1, static_cast<int>(glm::distance(a, b) / 0.5f));
    const int down = std::max(1, static_cast<int>(glm::distance(a, d) / 0.5f));
    for (int row = 0; row < down; ++row) {
      for (int column = 0; column < across; ++column) {
        const auto at = [&](int u, int v) {
          const float s = static_cast<float>(u) / static_cast<float>(across);
          const float t = static_cast<float>(v) / static_cast<float>(down);
          return (a * (1 - s) + b * s) * (1 - t) + (d * (1 - s) + c * s) * t;
        };
        const auto index = static_cast<uint32_t>(mesh.positions.size());
        for (const glm::vec3& point :
             {at(column, row), at(column + 1, row), at(column + 1, row + 1), at(column, row + 1)}) {
          mesh.positions.push_back(point);
          mesh.colors.push_back(color * ((row + column) % 2 == 0 ? 1.0f : 0.7f));
        }
        mesh.triangles.push_back({index, index + 1, index + 2});
        mesh.triangles.push_back({index, index + 2, index + 3});
      }
    }
  }

  Mesh mesh;
};

struct Hole {
  float from, to, floor, top;
};

/// A wall from a to b, from the floor to the ceiling, with holes by their distance from a.
void addWall(HouseMesh& house, const PlanCell& cell, glm::vec2 a, glm::vec2 b, std::vector<Hole> holes,
             const glm::vec3& color) {
  std::sort(holes.begin(), holes.end(), [](const Hole& one, const Hole& other) { return one.from < other.from; });
  const float length = glm::distance(a, b);
  const glm::vec2 along = (b - a) / length;
  const auto panel = [&](float from, float to, float low, float high) {
    const glm::vec2 p = a + along * from;
    const glm::vec2 q = a + along * to;
    house.quad({p.x, low, p.y}, {q.x, low, q.y}, {q.x, high, q.y}, {p.x, high, p.y}, color);
  };
  const float low = std::min(floorAt(cell, a), floorAt(cell, b)) - 0.01f;
  const float high = std::max(floorAt(cell, a), floorAt(cell, b)) + cell.height;
  float last = 0;
  for (const Hole& hole : holes) {
    panel(last, hole.from, low, high);
    panel(hole.from, hole.to, low, hole.floor);
    panel(hole.from, hole.to, hole.top, high);
    last = hole.to;
  }
  panel(last, length, low, high);
}

}  // namespace

WalkMap PlannedHouse::map(float degrees) const {
  const glm::mat4 turn = glm::rotate(glm::mat4(1), glm::radians(degrees), glm::vec3(0, 1, 0));
  const auto turned = [&](const glm::vec3& v, float w) { return glm::vec3(turn * glm::vec4(v, w)); };
  WalkMap map;
  for (const PlanCell& plan : cells) {
    const glm::vec2 size = plan.eastSouth - plan.westNorth;
    const glm::vec2 middle = (plan.westNorth + plan.eastSouth) / 2.0f;
    WalkCell cell;
    cell.kind = plan.tunnel ? WalkCellKind::kTunnel : WalkCellKind::kRoom;
    cell.center = turned({middle.x, plan.floor, middle.y}, 1);
    cell.axis = turned(isAlongX(plan) ? glm::vec3(1, 0, 0) : glm::vec3(0, 0, 1), 0);
    cell.halfLength = std::max(size.x, size.y) / 2;
    cell.halfWidth = std::min(size.x, size.y) / 2;
    cell.height = plan.height;
    cell.floorRise = plan.floorRise;
    if (plan.tunnel) {
      cell.rings = {{0, cell.halfWidth, cell.halfWidth, plan.height},
                    {2 * cell.halfLength, cell.halfWidth, cell.halfWidth, plan.height}};
    }
    map.cells.push_back(cell);
  }
  for (const PlanDoor& door : doors) {
    const DoorPlace place = placeOf(cells[door.from], cells[door.to], door);
    const glm::vec3 normal = vectorTo(-place.direction);
    Portal opening;
    opening.center = turned({place.middle.x, door.floor + door.height / 2, place.middle.y}, 1);
    opening.normal = turned(normal, 0);
    opening.halfUp = {0, door.height / 2, 0};
    opening.halfRight = glm::cross(glm::vec3(0, 1, 0), opening.normal) * (door.width / 2);
    map.portals.push_back({door.from, door.to, opening});
  }
  numberCells(map);
  return map;
}

GuidedScene PlannedHouse::scene(float degrees, bool ceilings) const {
  HouseMesh house;
  for (size_t i = 0; i < cells.size(); ++i) {
    const PlanCell& cell = cells[i];
    const glm::vec2 wn = cell.westNorth;
    const glm::vec2 es = cell.eastSouth;
    const std::array<glm::vec2, 4> corners{wn, glm::vec2(es.x, wn.y), es, glm::vec2(wn.x, es.y)};
    const glm::vec3 color(0.3f + 0.13f * static_cast<float>(i % 5), 0.4f + 0.1f * static_cast<float>(i / 2 % 5),
                          0.35f + 0.15f * static_cast<float>(i / 3 % 4));
    const auto up = [&](size_t k, float height) {
      return glm::vec3(corners[k].x, floorAt(cell, corners[k]) + height, corners[k].y);
    };
    house.quad(up(0, 0), up(1, 0), up(2, 0), up(3, 0), color);
    if (ceilings) {
      house.quad(up(0, cell.height), up(1, cell.height), up(2, cell.height), up(3, cell.height), glm::vec3(0.9f));
    }
    for (size_t k = 0; k < 4; ++k) {
      const glm::vec2 a = corners[k];
      const glm::vec2 b = corners[(k + 1) % 4];
      const glm::vec2 along = glm::normalize(b - a);
      const glm::vec2 out(along.y, -along.x);
      std::vector<Hole> holes;
      for (const PlanDoor& door : doors) {
        if (door.from != i && door.to != i) {
          continue;
        }
        DoorPlace place = placeOf(cells[door.from], cells[door.to], door);
        place.direction *= door.to == i ? -1.0f : 1.0f;
        if (glm::dot(place.direction, out) < 0.5f) {
          continue;
        }
        const float at = glm::dot(place.middle - a, along);
        holes.push_back({at - door.width / 2, at + door.width / 2, door.floor, door.floor + door.height});
        // Threshold, jambs and lintel, to the middle of the wall.
        const float depth = glm::dot(place.middle - a, out);
        const glm::vec2 one = a + along * (at - door.width / 2);
        const glm::vec2 other = a + along * (at + door.width / 2);
        const float top = door.floor + door.height;
        const auto in = [&](glm::vec2 p, float y) { return glm::vec3(p.x, y, p.y); };
        const auto beyond = [&](glm::vec2 p, float y) { return in(p + out * depth, y); };
        house.quad(in(one, door.floor), in(other, door.floor), beyond(other, door.floor), beyond(one, door.floor),
                   color);
        house.quad(in(one, top), in(other, top), beyond(other, top), beyond(one, top), color);
        house.quad(in(one, door.floor), beyond(one, door.floor), beyond(one, top), in(one, top), color);
        house.quad(in(other, door.floor), beyond(other, door.floor), beyond(other, top), in(other, top), color);
      }
      addWall(house, cell, a, b, holes, color * 0.8f);
    }
  }
  GuidedScene scene;
  append(scene.mesh, house.mesh, glm::rotate(glm::mat4(1), glm::radians(degrees), glm::vec3(0, 1, 0)));
  scene.objectOfTriangle.assign(scene.mesh.triangles.size(), 0);
  scene.guides.walk = map(degrees);
  return scene;
}

PlannedHouse smallHouse() {
  PlannedHouse house;
  house.cells = {
      {{0, 0}, {8, 6}},                              // 0: the hall
      {{2, 6.2f}, {3.6f, 18}, true},                 // 1: the corridor, to the south
      {{-4, 7}, {1.8f, 11}},                         // 2: to its west
      {{-4, 11.2f}, {1.8f, 17}},                     // 3: beyond, joined by two doors
      {{3.8f, 6.4f}, {9, 9}},                        // 4: to its east
      {{3.8f, 9.2f}, {7, 15}, false, 3.5f},          // 5: a tall one
      {{0.5f, 18.2f}, {5, 22}},                      // 6: at the end of the corridor
      {{8.2f, 1}, {13, 2.4f}, true, 2.4f, 1.5f, 3},  // 7: stairs up to the east
      {{13.2f, -1}, {17, 5}, false, 2.4f, 3},        // 8: at their top
      {{-5, 0}, {-0.2f, 3}},                         // 9: to the west of the hall
  };
  house.doors = {{0, 1, 2.8f, 1.2f}, {1, 2, 8, 0.9f},          {1, 3, 15, 0.9f}, {2, 3, -3, 0.9f},
                 {2, 3, 0.5f, 0.9f}, {1, 4, 7.5f, 0.9f},       {1, 5, 12, 0.9f}, {1, 6, 2.8f, 1.2f},
                 {0, 7, 1.7f, 1.2f}, {7, 8, 1.7f, 1.2f, 2, 3}, {0, 9, 1.5f, 1}};
  return house;
}

}  // namespace ocelli::test
