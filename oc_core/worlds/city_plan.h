// The plan of `builtin:city`: what stands where, in metres. x runs to the east, z to the south, y up; the middle of the
// city is the origin, and roadways lie at y = 0. Rectangles are given by their corners in (x, z).
//
// A wall with one gate closes the city in. Within it streets of different widths cut rectangles in two until blocks are
// left (a random guillotine partition, so that streets meet with offsets); some blocks are left open as squares, and
// some have an alley that ends within them. Houses fill the other blocks side by side, each with a facade of its own
// distance from the street.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "oc_core/scene/portal.h"
#include "oc_core/scene/walk_map.h"

namespace ocelli {

struct CityOptions {
  uint64_t seed = 1;
  float size = 152;  ///< of the inside of its wall along each side, kMinCitySize to kMaxCitySize
};

inline constexpr float kMinCitySize = 60;
inline constexpr float kMaxCitySize = 400;

inline constexpr float kCityKerb = 0.12f;       ///< height of pavements over the roadway
inline constexpr float kCityStorey = 3.2f;      ///< height
inline constexpr float kCityWallHeight = 6;     ///< of the wall around the city
inline constexpr float kCityWallThickness = 1;  ///< it stands outside of the size
inline constexpr float kCityGateHalfWidth = 2.5f;
inline constexpr float kCityGateHeight = 4;
inline constexpr float kCityForecourt = 10;  ///< length of the road outside of the gate

/// A side of a rectangle of the plan, and where it looks.
enum class CitySide : uint8_t { kWest, kEast, kNorth, kSouth };
inline constexpr std::array kCitySides{CitySide::kWest, CitySide::kEast, CitySide::kNorth, CitySide::kSouth};

struct CityRectangle {
  glm::vec2 lower{0};
  glm::vec2 upper{0};

  glm::vec2 size() const { return upper - lower; }
  glm::vec2 center() const { return (lower + upper) * 0.5f; }
  /// Whether they share some area.
  bool meets(const CityRectangle& other) const {
    return lower.x < other.upper.x && other.lower.x < upper.x && lower.y < other.upper.y && other.lower.y < upper.y;
  }
};

/// From lot to lot; facades stand behind its edges or at them.
struct CityStreet {
  CityRectangle area;
  bool isAlongX = true;
  bool isAlley = false;  ///< without pavements, and with an end within a block
  float width() const { return isAlongX ? area.size().y : area.size().x; }
};

struct CityBlock {
  CityRectangle area;
  /// By CitySide: of the street before it; 0 where it stands against a neighbour or the wall of the city.
  std::array<float, 4> streetWidth{};
  std::array<bool, 4> isOnAlley{};  ///< by CitySide, of those with a street
  bool isSquare = false;            ///< open, and paved

  /// The block with the streets before it, which nothing parts from a square.
  CityRectangle withStreets() const;
};

enum class CityRoof : uint8_t {
  kFlat,
  kAlongX,  ///< pitched; the direction of the ridge
  kAlongZ,
};

struct CityHouse {
  CityRectangle area;
  std::array<bool, 4> hasFacade{};  ///< by CitySide: windows, and doors where `door` says so; the others are bare walls
  CitySide door = CitySide::kSouth;
  int storeys = 3;
  CityRoof roof = CityRoof::kFlat;
  glm::vec3 wallColor{1};
  glm::vec3 roofColor{1};
  glm::vec3 doorColor{1};

  float wallTop() const { return kCityStorey * static_cast<float>(storeys); }
};

enum class CityThingKind : uint8_t { kRoundTree, kPointedTree, kCar, kLamp, kBench, kBin, kFountain };

struct CityThing {
  CityThingKind kind = CityThingKind::kLamp;
  glm::vec3 position{0};
  float turnDegrees = 0;
  float scale = 1;
  glm::vec3 color{1};  ///< of a tree or car
};

struct CityPlan {
  CityRectangle inside;             ///< of its wall
  std::vector<CityStreet> streets;  ///< the widest first; the gate stands at the south end of the first
  std::vector<CityBlock> blocks;
  std::vector<CityHouse> houses;
  std::vector<CityThing> things;
  glm::vec3 gate{0};              ///< on the ground, in the middle of the inner face of the wall
  std::vector<size_t> fountains;  ///< of `things`: one in each square; there is at least one
};

/// Of one side of a street: half of what is no roadway. 0 of alleys.
float cityPavementWidth(float streetWidth, bool isAlley);

/// Only for options in their ranges.
CityPlan planCity(const CityOptions& options);

/// Where one can walk: first the road before the gate, then squares and crossings as rooms, the streets between them as
/// tunnels with a ring at each change of the facades along them. This is the truth that what is found from the mesh is
/// compared with; guides do not give it. Things that stand in streets are not left out.
WalkMap cityWalkMap(const CityPlan& plan);

/// The mouths of streets at crossings and squares, as high as the tallest houses, and the gate; each as seen from
/// either side.
std::vector<Portal> cityPortals(const CityPlan& plan);

/// A walk at the height of eyes from before the gate to the first square, by the middles of cells and openings.
std::vector<glm::vec3> cityPath(const CityPlan& plan);

}  // namespace ocelli
