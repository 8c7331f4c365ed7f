// `builtin:town`: a small cartoon town: streets in a grid, houses that one can look into, a clock tower on its square.
#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <utility>

#include "oc_core/base/conventions.h"
#include "oc_core/worlds/builtin_list.h"
#include "oc_core/worlds/palette.h"
#include "oc_core/worlds/panels.h"
#include "oc_core/worlds/town_house.h"
#include "oc_core/worlds/town_plan.h"
#include "oc_core/worlds/town_things.h"
#include "oc_core/worlds/wall_slab.h"

namespace ocelli {
namespace {

constexpr float kMarking = 0.12f;  // half the width of a line on a street

/// Lines along one axis of the streets: their middle lines, and marks on them about every two metres.
std::vector<float> streetLines(const std::vector<float>& middles, float streetWidth) {
  std::vector<float> lines;
  for (size_t i = 0; i < middles.size(); ++i) {
    const float half = streetWidth / 2;
    if (i > 0) {
      const std::vector<float> between = evenLines(middles[i - 1] + half, middles[i] - half, 14);
      lines.insert(lines.end(), between.begin() + 1, between.end() - 1);
    }
    for (const float offset : {-half, -half / 2, -kMarking, kMarking, half / 2, half}) {
      lines.push_back(middles[i] + offset);
    }
  }
  return lines;
}

void addStreets(Scene& scene, const TownPlan& plan) {
  const std::vector<float> xs = streetLines(plan.streetsNorthSouth, plan.streetWidth);
  std::vector<float> ys = streetLines(plan.streetsEastWest, plan.streetWidth);  // panel y is world -z: the town is even
  const auto distanceTo = [](const std::vector<float>& middles, float x) {
    float least = 1e9f;
    for (const float middle : middles) {
      least = std::min(least, std::abs(x - middle));
    }
    return least;
  };
  Mesh streets;
  const glm::mat4 worldFromPanel(glm::vec4(1, 0, 0, 0), glm::vec4(0, 0, -1, 0), glm::vec4(0, 1, 0, 0),
                                 glm::vec4(0, 0, 0, 1));
  addPanel(streets, xs, ys, worldFromPanel, [&](size_t i, size_t j) {
    const float acrossX = distanceTo(plan.streetsNorthSouth, (xs[i] + xs[i + 1]) / 2);
    const float acrossZ = distanceTo(plan.streetsEastWest, (ys[j] + ys[j + 1]) / 2);
    const bool dashAlongZ = acrossX < kMarking && acrossZ > plan.streetWidth / 2 && j % 2 == 0;
    const bool dashAlongX = acrossZ < kMarking && acrossX > plan.streetWidth / 2 && i % 2 == 0;
    return dashAlongX || dashAlongZ ? palette::ivory() : palette::fromSrgbBytes(108, 110, 120);
  });
  scene.add(std::move(streets));
}

void addBlocks(Scene& scene, const TownPlan& plan) {
  Mesh blocks;
  for (const TownBlock& block : plan.blocks) {
    const glm::vec2 half = (block.upper - block.lower) * 0.5f;
    const glm::vec2 center = (block.upper + block.lower) * 0.5f;
    WallSlab slab;
    slab.xs = evenLines(-half.x, half.x, 28);
    slab.ys = evenLines(-half.y, half.y, 24);
    slab.thickness = kPavementHeight;
    slab.back = palette::mortar();
    slab.color = [&](size_t i, size_t j) {
      const size_t toEdge = std::min({i, j, slab.xs.size() - 2 - i, slab.ys.size() - 2 - j});
      const bool even = (i + j) % 2 == 0;
      if (toEdge < 2) {
        return palette::fromSrgbBytes(206, 200, 192) * (even ? 1.0f : 0.88f);
      }
      return block.isSquare ? palette::fromSrgbBytes(224, 190, 150) * (even ? 1.0f : 0.8f)
                            : palette::fromSrgbBytes(140, 184, 96) * (even ? 1.0f : 0.93f);
    };
    addSlab(blocks, slab,
            glm::rotate(glm::translate(glm::mat4(1), {center.x, kPavementHeight, center.y}),
                        static_cast<float>(-kPi / 2), glm::vec3(1, 0, 0)));
  }
  scene.add(std::move(blocks));
}

Mesh makeThing(const TownThing& thing) {
  switch (thing.kind) {
    case TownThing::Kind::kRoundTree:
      return makeRoundTree(thing.color);
    case TownThing::Kind::kPointedTree:
      return makePointedTree(thing.color);
    case TownThing::Kind::kCar:
      return makeCar(thing.color);
    case TownThing::Kind::kLamp:
      return makeLamp();
  }
  return {};
}

Scene buildTown(const BuiltinValues& values) {
  const TownPlan plan = planTown(values.count("seed"));
  Scene scene;
  addStreets(scene, plan);
  addBlocks(scene, plan);
  uint32_t object = 0;
  const auto addObject = [&](Mesh mesh, const glm::mat4& worldFromMesh) {
    scene.add(std::move(mesh), worldFromMesh);
    scene.instances.back().object = ++object;
  };
  for (const House& house : plan.houses) {
    addObject(makeHouse(house, values.count("detail")), house.worldFromHouse());
  }
  Mesh tower = makeClockTower();
  Box towerBox = boundsOf(tower);
  towerBox.lower += plan.towerPosition;
  towerBox.upper += plan.towerPosition;
  addObject(std::move(tower), glm::translate(glm::mat4(1), plan.towerPosition));
  scene.guides.target = {object, towerBox};
  for (const TownThing& thing : plan.things) {
    const glm::mat4 turned = glm::rotate(glm::translate(glm::mat4(1), thing.position),
                                         static_cast<float>(radiansFromDegrees(thing.turnDegrees)), glm::vec3(0, 1, 0));
    addObject(makeThing(thing), glm::scale(turned, glm::vec3(thing.scale)));
  }
  scene.guides.portals = townPortals(plan);
  return scene;
}

}  // namespace

BuiltinScene townScene() {
  return {"town",
          "a cartoon town of streets, houses that one can look into, and a clock tower; in metres",
          {{"seed", "of the random numbers", BuiltinParameter::Kind::kInteger, "1", 0, 4294967295.0},
           {"detail", "cells of a wall between openings; 4 makes a million triangles of the town",
            BuiltinParameter::Kind::kInteger, "1", 1, 8}},
          buildTown};
}

}  // namespace ocelli
