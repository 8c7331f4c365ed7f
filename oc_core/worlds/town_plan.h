// The plan of `builtin:town`: what stands where, in metres. x runs to the east, z to the south, y up, the middle of the
// town is the origin, and streets lie at y = 0.
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <vector>

#include "oc_core/scene/mesh.h"
#include "oc_core/scene/portal.h"

namespace ocelli {

inline constexpr float kPavementHeight = 0.15f;
inline constexpr float kStoreyHeight = 3.0f;
inline constexpr float kHouseWall = 0.25f;  ///< thickness

enum class RoofKind : uint8_t {
  kFlat,
  kFrontGable,  ///< the ridge runs from front to back
  kSideGable,   ///< the ridge runs along the front
};

/// In its own frame a house stands on y = 0 around the y axis, and its front looks to +z.
struct House {
  glm::vec3 position{0};
  float turnDegrees = 0;  ///< counter-clockwise seen from above: 0, 90, 180 or 270
  float width = 8;
  float depth = 8;
  int storeys = 2;
  RoofKind roof = RoofKind::kFrontGable;
  int doorBay = 0;
  glm::vec3 wallColor{1};
  glm::vec3 roofColor{1};
  glm::vec3 doorColor{1};

  glm::mat4 worldFromHouse() const;
  float wallTop() const { return kStoreyHeight * static_cast<float>(storeys); }
};

/// Windows and the door stand in bays of equal width.
int bayCount(float wallWidth);
/// x of the middle of a bay, from the middle of the wall.
float bayCenter(float wallWidth, int bay);

/// Of doors and windows.
inline constexpr float kOpeningHalfWidth = 0.6f;
inline constexpr float kSillHeight = 0.9f;
inline constexpr float kLintelHeight = 2.2f;

struct TownThing {
  enum class Kind : uint8_t { kRoundTree, kPointedTree, kCar, kLamp };
  Kind kind = Kind::kRoundTree;
  glm::vec3 position{0};
  float turnDegrees = 0;
  float scale = 1;
  glm::vec3 color{1};  ///< of a tree or car
};

/// A rectangle of pavement between streets, its corners in (x, z).
struct TownBlock {
  glm::vec2 lower{0};
  glm::vec2 upper{0};
  bool isSquare = false;  ///< the one with the clock tower
};

struct TownPlan {
  std::vector<TownBlock> blocks;
  std::vector<float> streetsEastWest;    ///< z of the middle of each
  std::vector<float> streetsNorthSouth;  ///< x of the middle of each
  float streetWidth = 8;
  std::vector<House> houses;
  std::vector<TownThing> things;
  glm::vec3 towerPosition{0};
};

TownPlan planTown(uint64_t seed);

/// The doorways and the open windows on the ground floor of all houses, seen from the street.
std::vector<Portal> townPortals(const TownPlan& plan);
inline std::vector<Portal> townPortals(uint64_t seed = 1) {
  return townPortals(planTown(seed));
}

}  // namespace ocelli
