// `builtin:city`: blocks of houses and streets of different widths within a wall, from a seed.
#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <utility>

#include "oc_core/worlds/builtin_list.h"
#include "oc_core/worlds/builtin_object.h"
#include "oc_core/worlds/city_house.h"
#include "oc_core/worlds/city_plan.h"
#include "oc_core/worlds/dense_scene.h"
#include "oc_core/worlds/facade.h"
#include "oc_core/worlds/palette.h"
#include "oc_core/worlds/panels.h"
#include "oc_core/worlds/placement.h"
#include "oc_core/worlds/town_things.h"
#include "oc_core/worlds/wall_slab.h"

namespace ocelli {
namespace {

constexpr float kHouseCell = 0.8f;   // metres: of walls and roofs
constexpr float kGroundCell = 1.5f;  // of roads, pavements and the wall
constexpr float kUnderHouses = 2;    // a pavement ends as far within a block: behind every facade

/// A panel in the plane y = 0, which looks up; lines are those of x and of z.
void addRoad(Mesh& mesh, const std::vector<float>& xs, const std::vector<float>& zs,
             const std::function<glm::vec3(size_t, size_t)>& color) {
  const glm::mat4 worldFromPanel(glm::vec4(1, 0, 0, 0), glm::vec4(0, 0, -1, 0), glm::vec4(0, 1, 0, 0),
                                 glm::vec4(0, 0, 0, 1));
  std::vector<float> ys(zs.rbegin(), zs.rend());  // panel y is world -z
  for (float& y : ys) {
    y = -y;
  }
  addPanel(mesh, xs, ys, worldFromPanel, color);
}

void addCityRoads(Scene& scene, const CityPlan& plan, float maxCell) {
  constexpr float kHalfLine = 0.08f;
  Mesh roads;
  for (const CityStreet& street : plan.streets) {
    const CityRectangle& area = street.area;
    const glm::vec2 center = area.center();
    std::vector<float> xs{area.lower.x, area.upper.x};
    std::vector<float> zs{area.lower.y, area.upper.y};
    const bool hasLine = street.width() >= 6;
    if (hasLine) {
      std::vector<float>& across = street.isAlongX ? zs : xs;
      const float middle = street.isAlongX ? center.y : center.x;
      across = {across[0], middle - kHalfLine, middle + kHalfLine, across[1]};
    }
    xs = closerLines(xs, maxCell);
    zs = closerLines(zs, maxCell);
    const glm::vec3 asphalt =
        street.isAlley ? palette::fromSrgbBytes(150, 140, 128) : palette::fromSrgbBytes(108, 110, 120);
    addRoad(roads, xs, zs, [&](size_t i, size_t j) {
      const size_t k = zs.size() - 2 - j;  // the cell between lines k and k + 1 of z
      const float toMiddle =
          street.isAlongX ? std::abs((zs[k] + zs[k + 1]) / 2 - center.y) : std::abs((xs[i] + xs[i + 1]) / 2 - center.x);
      const size_t step = street.isAlongX ? i : k;
      const bool isDash = hasLine && toMiddle < kHalfLine && step % 4 < 2;
      return isDash ? palette::ivory() : asphalt * ((i + k) % 2 == 0 ? 1.0f : 0.96f);
    });
  }
  const float end = plan.gate.z + kCityWallThickness + kCityForecourt;
  addRoad(roads, closerLines({plan.gate.x - kCityGateHalfWidth, plan.gate.x + kCityGateHalfWidth}, maxCell),
          closerLines({plan.gate.z, end}, maxCell),
          [](size_t i, size_t j) { return palette::fromSrgbBytes(190, 160, 120) * ((i + j) % 2 == 0 ? 1.0f : 0.9f); });
  scene.add(std::move(roads));
}

/// Pavements around blocks, open where houses stand; squares are paved all over.
void addCityPavements(Scene& scene, const CityPlan& plan, float maxCell) {
  Mesh pavements;
  for (const CityBlock& block : plan.blocks) {
    std::array<float, 4> out{};     // of the edges of the block
    std::array<float, 4> within{};  // from there to the inner edge
    for (const CitySide side : kCitySides) {
      const auto s = static_cast<size_t>(side);
      out[s] = cityPavementWidth(block.streetWidth[s], block.streetWidth[s] == 0 || block.isOnAlley[s]);
      within[s] = block.streetWidth[s] > 0 ? kUnderHouses : 0;
    }
    // By CitySide: west, east, north, south.
    std::vector<float> xs{block.area.lower.x - out[0], block.area.lower.x + within[0], block.area.upper.x - within[1],
                          block.area.upper.x + out[1]};
    // Slab y is world -z.
    std::vector<float> ys{-(block.area.upper.y + out[3]), -(block.area.upper.y - within[3]),
                          -(block.area.lower.y + within[2]), -(block.area.lower.y - out[2])};
    const float left = xs[1];
    const float right = xs[2];
    const float bottom = ys[1];
    const float top = ys[2];
    const auto same = [](float a, float b) { return a == b; };
    xs.erase(std::unique(xs.begin(), xs.end(), same), xs.end());
    ys.erase(std::unique(ys.begin(), ys.end(), same), ys.end());
    WallSlab slab;
    slab.xs = closerLines(xs, maxCell);
    slab.ys = closerLines(ys, maxCell);
    slab.thickness = kCityKerb;
    slab.back = palette::mortar();
    slab.color = [&](size_t i, size_t j) {
      const bool isEven = (i + j) % 2 == 0;
      return block.isSquare ? palette::fromSrgbBytes(224, 190, 150) * (isEven ? 1.0f : 0.82f)
                            : palette::fromSrgbBytes(206, 200, 192) * (isEven ? 1.0f : 0.88f);
    };
    slab.isOpen = [&](size_t i, size_t j) {
      const float x = (slab.xs[i] + slab.xs[i + 1]) / 2;
      const float y = (slab.ys[j] + slab.ys[j + 1]) / 2;
      return !block.isSquare && left < x && x < right && bottom < y && y < top;
    };
    addSlab(pavements, slab, placedAt({0, kCityKerb, 0}, -90, {1, 0, 0}));
  }
  scene.add(std::move(pavements));
}

/// The wall around the city: its front looks into it; the gate is in the south.
void addCityWalls(Scene& scene, const CityPlan& plan, float maxCell) {
  Mesh walls;
  const float half = plan.inside.upper.x;
  for (int side = 0; side < 4; ++side) {
    const bool isSouth = side == 2;
    const bool isAlongX = side % 2 == 0;
    const float end = half + (isAlongX ? kCityWallThickness : 0);
    std::vector<float> xs{-end, end};
    std::vector<float> ys{0, kCityWallHeight};
    // Turned by 180 degrees, the x of the south side runs to the west.
    const float gate = -plan.gate.x;
    if (isSouth) {
      xs = {-end, gate - kCityGateHalfWidth, gate + kCityGateHalfWidth, end};
      ys = {0, kCityGateHeight, kCityWallHeight};
    }
    WallSlab wall;
    wall.xs = closerLines(xs, maxCell);
    wall.ys = closerLines(ys, maxCell / 2);
    wall.thickness = kCityWallThickness;
    wall.back = palette::brick();
    wall.color = [](size_t i, size_t j) { return palette::brick() * (1 + 0.25f * static_cast<float>((i + j) % 2)); };
    wall.isOpen = [&](size_t i, size_t j) {
      const float x = (wall.xs[i] + wall.xs[i + 1]) / 2;
      return isSouth && std::abs(x - gate) < kCityGateHalfWidth && wall.ys[j] < kCityGateHeight - 1e-3f;
    };
    addSlab(walls, wall, placedAt({0, 0, 0}, 90 * side) * placedAt({0, 0, -half}));
  }
  scene.add(std::move(walls));
}

Mesh makeCityThing(const CityThing& thing) {
  switch (thing.kind) {
    case CityThingKind::kRoundTree:
      return makeRoundTree(thing.color);
    case CityThingKind::kPointedTree:
      return makePointedTree(thing.color);
    case CityThingKind::kCar:
      return makeCar(thing.color);
    case CityThingKind::kLamp:
      return makeLamp();
    case CityThingKind::kBench:
      return makeBench();
    case CityThingKind::kBin:
      return makeBin(thing.color);
    case CityThingKind::kFountain:
      return makeFountain();
  }
  return {};
}

Scene buildCity(const BuiltinValues& values) {
  const CityPlan plan = planCity({values.count("seed"), static_cast<float>(values.number("size"))});
  Scene scene;
  addCityRoads(scene, plan, kGroundCell);
  addCityPavements(scene, plan, kGroundCell);
  addCityWalls(scene, plan, kGroundCell);
  uint32_t object = 0;
  for (const CityHouse& house : plan.houses) {
    scene.add(makeCityHouse(house, kHouseCell));
    scene.instances.back().object = ++object;
  }
  for (size_t i = 0; i < plan.things.size(); ++i) {
    const CityThing& thing = plan.things[i];
    const glm::mat4 worldFromThing = glm::scale(placedAt(thing.position, thing.turnDegrees), glm::vec3(thing.scale));
    scene.add(makeCityThing(thing), worldFromThing);
    scene.instances.back().object = ++object;
    if (i == plan.fountains.front()) {
      Box box = boundsOf(scene.meshes.back());
      box.lower += thing.position;
      box.upper += thing.position;
      scene.guides.target = {object, box};
    }
  }
  densifyScene(scene, values.count("triangles"));
  scene.guides.portals = cityPortals(plan);
  scene.guides.path = cityPath(plan);
  return scene;
}

}  // namespace

BuiltinScene cityScene() {
  return {"city",
          "streets of different widths, squares and alleys between houses, within a wall with a gate; in metres",
          {{"seed", "of the random numbers", BuiltinParameter::Kind::kInteger, "1", 0, 4294967295.0},
           {"size", "of the city along each side, metres", BuiltinParameter::Kind::kNumber, "152", kMinCitySize,
            kMaxCitySize},
           trianglesParameter()},
          buildCity};
}

}  // namespace ocelli
