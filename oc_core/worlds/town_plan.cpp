#include "oc_core/worlds/town_plan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>

#include "oc_core/base/conventions.h"
#include "oc_core/base/random.h"
#include "oc_core/worlds/palette.h"

namespace ocelli {
namespace {

constexpr int kBlocksX = 4;
constexpr int kBlocksZ = 3;
constexpr float kBlockWidth = 34;
constexpr float kBlockDepth = 28;
constexpr float kSidewalk = 2.5f;
constexpr int kSquareX = 1;
constexpr int kSquareZ = 1;

using Colors = std::vector<glm::vec3>;

const Colors& wallColors() {
  static const Colors colors{palette::fromSrgbBytes(247, 214, 160), palette::fromSrgbBytes(240, 170, 150),
                             palette::fromSrgbBytes(168, 212, 220), palette::fromSrgbBytes(186, 216, 158),
                             palette::fromSrgbBytes(244, 232, 200), palette::fromSrgbBytes(214, 178, 214),
                             palette::fromSrgbBytes(250, 222, 120), palette::fromSrgbBytes(226, 146, 110)};
  return colors;
}

const Colors& roofColors() {
  static const Colors colors{palette::fromSrgbBytes(182, 74, 58), palette::fromSrgbBytes(98, 110, 134),
                             palette::fromSrgbBytes(134, 92, 70), palette::fromSrgbBytes(64, 128, 122),
                             palette::fromSrgbBytes(150, 60, 84)};
  return colors;
}

const Colors& brightColors() {
  static const Colors colors{palette::vermilion(), palette::blue(),   palette::green(), palette::yellow(),
                             palette::skyBlue(),   palette::orange(), palette::ivory(), palette::purple()};
  return colors;
}

glm::vec3 anyOf(const Colors& colors, Random& random) {
  return colors[random.below(colors.size())];
}

class Planner {
 public:
  explicit Planner(uint64_t seed) : random_(seed) {}

  TownPlan plan() {
    const float pitchX = kBlockWidth + plan_.streetWidth;
    const float pitchZ = kBlockDepth + plan_.streetWidth;
    for (int i = 0; i <= kBlocksX; ++i) {
      plan_.streetsNorthSouth.push_back(pitchX * (static_cast<float>(i) - kBlocksX / 2.0f));
    }
    for (int i = 0; i <= kBlocksZ; ++i) {
      plan_.streetsEastWest.push_back(pitchZ * (static_cast<float>(i) - kBlocksZ / 2.0f));
    }
    for (int j = 0; j < kBlocksZ; ++j) {
      for (int i = 0; i < kBlocksX; ++i) {
        const glm::vec2 lower(plan_.streetsNorthSouth[static_cast<size_t>(i)] + plan_.streetWidth / 2,
                              plan_.streetsEastWest[static_cast<size_t>(j)] + plan_.streetWidth / 2);
        plan_.blocks.push_back({lower, lower + glm::vec2(kBlockWidth, kBlockDepth), i == kSquareX && j == kSquareZ});
        if (plan_.blocks.back().isSquare) {
          fillSquare(plan_.blocks.back());
        } else {
          addHouses(plan_.blocks.back());
        }
        addLampsAndTrees(plan_.blocks.back());
      }
    }
    addCars();
    return std::move(plan_);
  }

 private:
  /// A row of houses along each of the two long sides, and trees in the yard between them.
  void addHouses(const TownBlock& block) {
    for (const bool south : {true, false}) {
      float x = block.lower.x + kSidewalk;
      const float end = block.upper.x - kSidewalk;
      while (end - x >= 7) {
        // What would be left after this one has room for another, or is taken too.
        float width = random_.inRange(7, 11);
        width = end - x - width < 7.5f ? std::min(end - x, 11.0f) : width;
        addHouse(block, x + width / 2, width - 0.7f, south);
        x += width;
      }
    }
    const float z = (block.lower.y + block.upper.y) / 2;
    for (int i = 0; i < 4; ++i) {
      const float x = block.lower.x + kBlockWidth * (static_cast<float>(i) + 0.5f + random_.inRange(-0.2f, 0.2f)) / 4;
      addTree({x, kPavementHeight, z + random_.inRange(-1, 1)}, random_.inRange(0.8f, 1.1f));
    }
  }

  void addHouse(const TownBlock& block, float x, float width, bool south) {
    House house;
    house.width = width;
    house.depth = random_.inRange(7, 9);
    house.storeys = 1 + static_cast<int>(random_.below(3));
    house.roof = house.storeys == 3 ? RoofKind::kFlat : static_cast<RoofKind>(1 + random_.below(2));
    house.turnDegrees = south ? 0 : 180;
    house.doorBay = static_cast<int>(random_.below(static_cast<size_t>(bayCount(width))));
    house.wallColor = anyOf(wallColors(), random_);
    house.roofColor = anyOf(roofColors(), random_);
    house.doorColor = anyOf(brightColors(), random_);
    const float front = south ? block.upper.y - kSidewalk : block.lower.y + kSidewalk;
    house.position = {x, kPavementHeight, front + (south ? -house.depth / 2 : house.depth / 2)};
    plan_.houses.push_back(house);
  }

  void fillSquare(const TownBlock& block) {
    const glm::vec2 center = (block.lower + block.upper) * 0.5f;
    plan_.towerPosition = {center.x, kPavementHeight, center.y};
    for (int i = 0; i < 12; ++i) {
      const double angle = 2 * kPi * (i + 0.5) / 12;
      addTree({center.x + 12 * std::sin(angle), kPavementHeight, center.y + 9.5 * std::cos(angle)},
              random_.inRange(0.7f, 0.9f));
    }
  }

  void addTree(const glm::vec3& position, float scale) {
    TownThing tree;
    tree.kind = random_.below(3) == 0 ? TownThing::Kind::kPointedTree : TownThing::Kind::kRoundTree;
    tree.position = position;
    tree.turnDegrees = random_.inRange(0, 360);
    tree.scale = scale;
    const float age = random_.inRange(0, 1);
    tree.color = palette::fromSrgbBytes(static_cast<int>(70 + 60 * age), static_cast<int>(150 + 30 * age), 70);
    plan_.things.push_back(tree);
  }

  /// At the kerb, along the long sides.
  void addLampsAndTrees(const TownBlock& block) {
    for (const bool south : {true, false}) {
      const float z = south ? block.upper.y - 0.7f : block.lower.y + 0.7f;
      for (int i = 0; i < 4; ++i) {
        const glm::vec3 position(block.lower.x + kBlockWidth * (static_cast<float>(i) + 0.5f) / 4, kPavementHeight, z);
        if (i % 2 == 0) {
          plan_.things.push_back({TownThing::Kind::kLamp, position, south ? 0.0f : 180.0f});
        } else {
          addTree(position, random_.inRange(0.45f, 0.6f));
        }
      }
    }
  }

  void addCars() {
    const float lane = plan_.streetWidth / 4;
    for (const float z : plan_.streetsEastWest) {
      for (int i = 0; i < kBlocksX; ++i) {
        const float x = plan_.blocks[static_cast<size_t>(i)].lower.x + random_.inRange(4, kBlockWidth - 4);
        const bool eastward = random_.below(2) == 0;
        addCar({x, 0, z + (eastward ? lane : -lane)}, eastward ? 0.0f : 180.0f);
      }
    }
    for (const float x : plan_.streetsNorthSouth) {
      for (int j = 0; j < kBlocksZ; ++j) {
        const float z = plan_.blocks[static_cast<size_t>(j) * kBlocksX].lower.y + random_.inRange(4, kBlockDepth - 4);
        const bool northward = random_.below(2) == 0;
        addCar({x + (northward ? lane : -lane), 0, z}, northward ? 90.0f : 270.0f);
      }
    }
  }

  void addCar(const glm::vec3& position, float turnDegrees) {
    plan_.things.push_back({TownThing::Kind::kCar, position, turnDegrees, 1, anyOf(brightColors(), random_)});
  }

  Random random_;
  TownPlan plan_;
};

}  // namespace

glm::mat4 House::worldFromHouse() const {
  return glm::rotate(glm::translate(glm::mat4(1), position), static_cast<float>(radiansFromDegrees(turnDegrees)),
                     glm::vec3(0, 1, 0));
}

int bayCount(float wallWidth) {
  return static_cast<int>(wallWidth / 2.2f);
}

float bayCenter(float wallWidth, int bay) {
  return wallWidth * ((static_cast<float>(bay) + 0.5f) / static_cast<float>(bayCount(wallWidth)) - 0.5f);
}

TownPlan planTown(uint64_t seed) {
  return Planner(seed).plan();
}

std::vector<Portal> townPortals(const TownPlan& plan) {
  std::vector<Portal> portals;
  for (const House& house : plan.houses) {
    const glm::mat4 worldFromHouse = house.worldFromHouse();
    for (int bay = 0; bay < bayCount(house.width); ++bay) {
      const float bottom = bay == house.doorBay ? 0 : kSillHeight;
      const auto turned = [&](const glm::vec3& v) { return glm::vec3(worldFromHouse * glm::vec4(v, 0)); };
      Portal portal;
      portal.center = glm::vec3(
          worldFromHouse * glm::vec4(bayCenter(house.width, bay), (bottom + kLintelHeight) / 2, house.depth / 2, 1));
      portal.normal = turned({0, 0, 1});
      portal.halfRight = turned({kOpeningHalfWidth, 0, 0});
      portal.halfUp = {0, (kLintelHeight - bottom) / 2, 0};
      portals.push_back(portal);
    }
  }
  return portals;
}

}  // namespace ocelli
