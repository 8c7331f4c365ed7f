#include "oc_core/worlds/house_mesh.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "oc_core/base/conventions.h"
#include "oc_core/worlds/facade.h"
#include "oc_core/worlds/palette.h"
#include "oc_core/worlds/panels.h"
#include "oc_core/worlds/placement.h"
#include "oc_core/worlds/wall_slab.h"

namespace ocelli {
namespace {

constexpr float kRailHeight = 0.95f;  // over the floor or the steps
constexpr float kRailPost = 0.035f;   // thickness
constexpr float kFloorThickness = kFloorToFloor - kRoomHeight;

void sortLines(std::vector<float>& lines) {
  std::sort(lines.begin(), lines.end());
  lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
}

class HouseShell {
 public:
  HouseShell(const HousePlan& plan, float maxCell) : plan_(plan), maxCell_(maxCell) {}

  Mesh build() {
    for (const HouseWall& wall : plan_.walls) {
      addHouseWall(wall);
    }
    for (int storey = 0; storey <= plan_.storeys; ++storey) {
      addFloor(storey);
    }
    if (plan_.stairs) {
      addFlight(*plan_.stairs);
      addGallery(*plan_.stairs);
    }
    addTerrace();
    addTop();
    return std::move(mesh_);
  }

 private:
  const glm::vec3& frameColor() const { return frameColor_; }

  void addHouseWall(const HouseWall& wall) {
    const float floor = kFloorToFloor * static_cast<float>(wall.storey);
    const float height = wall.isOuter ? kFloorToFloor : kRoomHeight;
    // Along x, the front of the slab looks to the south; along z, to the east, and slab x is world -z.
    const float sign = wall.isAlongX ? 1.0f : -1.0f;
    const glm::mat4 worldFromWall = wall.isAlongX ? placedAt({0, floor, wall.middle + wall.thickness / 2})
                                                  : placedAt({wall.middle + wall.thickness / 2, floor, 0}, 90);
    std::vector<float> xs{sign * wall.from, sign * wall.to};
    std::vector<float> ys{0, height};
    for (const HouseOpening& opening : wall.openings) {
      xs.insert(xs.end(), {sign * opening.from, sign * opening.to});
      ys.insert(ys.end(), {opening.bottom, opening.top});
    }
    sortLines(xs);
    sortLines(ys);
    WallSlab slab;
    slab.xs = closerLines(xs, maxCell_);
    slab.ys = closerLines(ys, maxCell_);
    slab.thickness = wall.thickness;
    const float inside = wall.isAlongX ? plan_.inside.center().y : plan_.inside.center().x;
    const bool frontIsOutside = wall.isOuter && wall.middle > inside;
    const glm::vec3 plaster = palette::ivory() * (wall.isAlongX ? 0.92f : 0.8f);
    const glm::vec3 front = frontIsOutside ? plan_.wallColor : plaster;
    slab.back = wall.isOuter && !frontIsOutside ? plan_.wallColor : plaster * 0.94f;
    slab.color = [&](size_t i, size_t j) {
      return slab.ys[j] < 0.1f && !frontIsOutside ? front * 0.9f : front * ((i + j) % 2 == 0 ? 1.0f : 0.95f);
    };
    slab.isOpen = [&](size_t i, size_t j) {
      const float along = sign * (slab.xs[i] + slab.xs[i + 1]) / 2;
      const float up = (slab.ys[j] + slab.ys[j + 1]) / 2;
      return std::any_of(wall.openings.begin(), wall.openings.end(), [&](const HouseOpening& o) {
        return o.from < along && along < o.to && o.bottom < up && up < o.top;
      });
    };
    addSlab(mesh_, slab, worldFromWall);
    for (const HouseOpening& opening : wall.openings) {
      const float left = std::min(sign * opening.from, sign * opening.to);
      const float right = std::max(sign * opening.from, sign * opening.to);
      if (!opening.isWindow) {
        addDoorFrame(mesh_, {left, right, opening.bottom, opening.top}, wall.thickness, worldFromWall, frameColor());
        continue;
      }
      addPaintedBox(
          mesh_, {right - left, opening.top - opening.bottom, 0.03f},
          worldFromWall * placedAt({(left + right) / 2, (opening.bottom + opening.top) / 2, -wall.thickness / 2}),
          palette::skyBlue());
      // On the outer face, then on the inner one.
      const glm::mat4 wallFromBack = placedAt({0, 0, -wall.thickness}, 180);
      addWindow(mesh_, {left, right, opening.bottom, opening.top}, worldFromWall, frameColor());
      addWindow(mesh_, {-right, -left, opening.bottom, opening.top}, worldFromWall * wallFromBack, frameColor());
    }
  }

  /// The floor of a storey, which is the ceiling of the one below: open over the stairs.
  void addFloor(int storey) {
    const auto has = [&](const HouseRoom& room) { return room.storey == std::min(storey, plan_.storeys - 1); };
    const bool hasHole = storey == 1 && plan_.stairs.has_value();
    // Slab y is world -z.
    std::vector<float> xs{plan_.inside.lower.x, plan_.inside.upper.x};
    std::vector<float> ys{-plan_.inside.upper.y, -plan_.inside.lower.y};
    const auto addEdges = [&](const HouseRectangle& area) {
      xs.insert(xs.end(), {area.lower.x, area.upper.x});
      ys.insert(ys.end(), {-area.lower.y, -area.upper.y});
    };
    for (const HouseRoom& room : plan_.rooms) {
      if (has(room)) {
        addEdges(room.area);
      }
    }
    if (hasHole) {
      addEdges(plan_.stairs->area);
    }
    sortLines(xs);
    sortLines(ys);
    WallSlab slab;
    slab.xs = closerLines(xs, maxCell_);
    slab.ys = closerLines(ys, maxCell_);
    slab.thickness = kFloorThickness;
    slab.back = palette::ivory();
    const auto isIn = [&](const HouseRectangle& area, size_t i, size_t j) {
      const float x = (slab.xs[i] + slab.xs[i + 1]) / 2;
      const float z = -(slab.ys[j] + slab.ys[j + 1]) / 2;
      return area.lower.x < x && x < area.upper.x && area.lower.y < z && z < area.upper.y;
    };
    slab.color = [&](size_t i, size_t j) {
      const float shade = (i + j) % 2 == 0 ? 1.0f : 0.84f;
      for (const HouseRoom& room : plan_.rooms) {
        if (storey < plan_.storeys && has(room) && isIn(room.area, i, j)) {
          return room.floorColor * shade;
        }
      }
      return palette::mortar() * shade;
    };
    slab.isOpen = [&](size_t i, size_t j) { return hasHole && isIn(plan_.stairs->area, i, j); };
    addSlab(mesh_, slab, placedAt({0, kFloorToFloor * static_cast<float>(storey), 0}, -90, {1, 0, 0}));
  }

  /// Along x from the first step to the last: `k` steps from the bottom.
  static float stepEdge(const HouseStairs& stairs, float k) {
    return stairs.risesEast ? stairs.area.lower.x + k * kStairTread : stairs.area.upper.x - k * kStairTread;
  }

  void addFlight(const HouseStairs& stairs) {
    constexpr float kRise = kFloorToFloor / kStairSteps;
    const float middle = stairs.area.center().y;
    const float rail = stairs.area.upper.y - 0.04f;
    for (int step = 0; step < kStairSteps; ++step) {
      const auto k = static_cast<float>(step);
      const float x = stepEdge(stairs, k + 0.5f);
      const float height = kRise * (k + 1);
      addPaintedBox(mesh_, {kStairTread, height, kStairWidth}, placedAt({x, height / 2, middle}),
                    palette::fromSrgbBytes(176, 122, 80) * (step % 2 == 0 ? 1.0f : 0.85f));
      addPaintedBox(mesh_, {kRailPost, kRailHeight, kRailPost}, placedAt({x, height + kRailHeight / 2, rail}),
                    frameColor());
    }
    const float run = kStairTread * kStairSteps;
    const double slope = degreesFromRadians(std::atan2(kFloorToFloor, run));
    addPaintedBox(mesh_, {std::hypot(run, kFloorToFloor), 0.06f, 0.06f},
                  placedAt({stepEdge(stairs, kStairSteps / 2.0f), kFloorToFloor / 2 + kRise / 2 + kRailHeight, rail},
                           stairs.risesEast ? slope : -slope, {0, 0, 1}),
                  palette::brick());
  }

  void addRail(const glm::vec3& from, const glm::vec3& to) {
    const glm::vec3 along = to - from;
    const float length = std::abs(along.x) + std::abs(along.z);
    const auto posts = static_cast<int>(length / 0.14f);
    for (int i = 0; i <= posts; ++i) {
      const glm::vec3 foot = from + along * (static_cast<float>(i) / static_cast<float>(posts));
      addPaintedBox(mesh_, {kRailPost, kRailHeight, kRailPost}, placedAt(foot + glm::vec3(0, kRailHeight / 2, 0)),
                    frameColor());
    }
    addPaintedBox(mesh_, {std::abs(along.x) + 0.06f, 0.06f, std::abs(along.z) + 0.06f},
                  placedAt((from + to) * 0.5f + glm::vec3(0, kRailHeight, 0)), palette::brick());
  }

  /// Railings around the hole in the floor above, but for the end where one arrives.
  void addGallery(const HouseStairs& stairs) {
    const HouseRectangle& hole = stairs.area;
    const float side = hole.upper.y + 0.04f;
    const float end = stairs.risesEast ? hole.lower.x - 0.04f : hole.upper.x + 0.04f;
    addRail({hole.lower.x, kFloorToFloor, side}, {hole.upper.x, kFloorToFloor, side});
    addRail({end, kFloorToFloor, hole.lower.y + 0.05f}, {end, kFloorToFloor, side});
  }

  void addTerrace() {
    WallSlab slab;
    slab.xs = closerLines({plan_.terrace.lower.x, plan_.terrace.upper.x}, 0.5f);
    // Under the front door too.
    slab.ys = closerLines({-plan_.terrace.upper.y, -plan_.inside.upper.y}, 0.5f);
    slab.thickness = 0.15f;
    slab.back = palette::mortar();
    slab.color = [](size_t i, size_t j) {
      return palette::fromSrgbBytes(206, 200, 192) * ((i + j) % 2 == 0 ? 1.0f : 0.85f);
    };
    addSlab(mesh_, slab, placedAt({0, 0, 0}, -90, {1, 0, 0}));
  }

  void addTop() {
    const glm::vec2 size = plan_.inside.size() + 2 * kOuterWall;
    PitchedRoof roof;
    roof.span = size.y;
    roof.length = size.x;
    roof.pitch = 0.7f;
    roof.eavesAtLowerX = roof.eavesAtUpperX = 0.4f;
    roof.overGables = 0.35f;
    roof.maxCell = maxCell_;
    roof.wallColor = plan_.wallColor;
    roof.roofColor = plan_.roofColor;
    const float top = kFloorToFloor * static_cast<float>(plan_.storeys);
    addPitchedRoof(mesh_, roof, placedAt({0, top, 0}, 90));
    addPaintedBox(mesh_, {0.8f, 3, 0.8f}, placedAt({size.x * 0.25f, top + 2.2f, -size.y * 0.2f}), palette::brick());
  }

  const HousePlan& plan_;
  float maxCell_;
  glm::vec3 frameColor_ = palette::fromSrgbBytes(250, 246, 236);
  Mesh mesh_;
};

}  // namespace

Mesh makeHouseShell(const HousePlan& plan, float maxCell) {
  return HouseShell(plan, maxCell).build();
}

Mesh makeDoorLeaf(const HouseDoor& door, const glm::vec3& color) {
  constexpr float kClearance = 0.02f;  // over the floor
  const float height = door.height - 3 * kClearance;
  const glm::vec2 size = door.leaf.size();
  const glm::vec2 center = door.leaf.center();
  Mesh leaf;
  addPaintedBox(leaf, {size.x, height, size.y}, placedAt({center.x, door.place.y + kClearance + height / 2, center.y}),
                color);
  return leaf;
}

}  // namespace ocelli
