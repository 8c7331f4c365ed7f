// `builtin:parking`: rows of cars, or of another object, on a car park. `builtin:barrels`: barrels that stand close
// together. One mesh each, placed many times: what relief tiles are for (section 3.5.2.3.2; Figures 3.26 and 3.31).
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>

#include "oc_core/base/conventions.h"
#include "oc_core/worlds/builtin_list.h"
#include "oc_core/worlds/builtin_object.h"
#include "oc_core/worlds/palette.h"
#include "oc_core/worlds/panels.h"
#include "oc_core/worlds/parked_things.h"
#include "oc_core/worlds/placement.h"

namespace ocelli {
namespace {

constexpr double kMaxTiles = 400;
constexpr uint32_t kTileObject = 1;  ///< all of them together
/// The default view is level: it sees the ground at this angle.
constexpr double kTiltDegrees = 32;

constexpr std::array<glm::vec3 (*)(), 8> kTints{palette::vermilion, palette::skyBlue, palette::ivory, palette::green,
                                                palette::yellow,    palette::blue,    palette::brick, palette::purple};

float jitter(uint32_t tile, uint32_t what) {
  uint32_t h = tile * 0x9e3779b1u ^ what * 0x85ebca6bu;
  h = (h ^ (h >> 15)) * 0x2c1b3c6du;
  h = (h ^ (h >> 12)) * 0x297a2d39u;
  return static_cast<float>((h ^ (h >> 15)) >> 8) / 8388608.0f - 1;
}

/// Of paint: its strongest channel is 1, so that dark parts stay visible.
glm::vec3 paintTint(uint32_t tile) {
  const auto number = static_cast<size_t>((jitter(tile, 7) + 1) / 2 * static_cast<float>(kTints.size()));
  const glm::vec3 color = kTints[std::min(number, kTints.size() - 1)]();
  return color / std::max({color.x, color.y, color.z});
}

struct TilePlace {
  float x, z;
  double turnDegrees;
};

/// The object of `mesh=`, as large as `other` in its largest side, or `other`.
Mesh tileObject(const BuiltinValues& values, Mesh other, float side, std::vector<std::string>& warnings) {
  if (values.path("mesh").empty()) {
    return other;
  }
  Mesh object = readObject(values, warnings);
  const glm::vec3 size = boundsOf(object).size();
  transform(object, glm::scale(glm::mat4(1), glm::vec3(side / std::max({size.x, size.y, size.z}))));
  return object;
}

Scene tiledScene(Mesh ground, Mesh object, bool tinted, const std::vector<TilePlace>& places,
                 std::vector<std::string> warnings) {
  Scene scene;
  scene.warnings = std::move(warnings);
  scene.add(std::move(ground));
  scene.meshes.push_back(std::move(object));
  const size_t mesh = scene.meshes.size() - 1;
  for (uint32_t i = 0; i < places.size(); ++i) {
    const TilePlace& place = places[i];
    scene.instances.push_back(
        {mesh, placedAt({place.x, 0, place.z}, place.turnDegrees), tinted ? paintTint(i) : glm::vec3(1), kTileObject});
  }
  const glm::mat4 tilt =
      glm::rotate(glm::mat4(1), static_cast<float>(radiansFromDegrees(kTiltDegrees)), glm::vec3(1, 0, 0));
  for (Instance& instance : scene.instances) {
    instance.worldFromMesh = tilt * instance.worldFromMesh;
  }
  return scene;
}

/// Columns and rows of `count` places, about `wide` times as many columns.
size_t columnsFor(size_t count, double wide) {
  return std::max<size_t>(1, static_cast<size_t>(std::lround(std::sqrt(static_cast<double>(count) * wide))));
}

/// From the middle.
float centred(size_t i, size_t count) {
  return static_cast<float>(i) - (static_cast<float>(count) - 1) / 2;
}

constexpr float kBayWidth = 2.7f;
constexpr float kBayLength = 5.2f;
constexpr float kLane = 4.4f;

/// The middle of a row of bays: two rows between lanes stand nose to nose.
float rowMiddle(size_t row, size_t rows) {
  const auto pairs = static_cast<float>((rows + 1) / 2);
  const float pair = kBayLength * 2 + kLane;
  return (static_cast<float>(row / 2) - (pairs - 1) / 2) * pair + (row % 2 == 0 ? -0.5f : 0.5f) * kBayLength;
}

Mesh makeCarPark(size_t columns, size_t rows) {
  const float halfWidth = kBayWidth * (static_cast<float>(columns) / 2 + 0.5f);
  const float halfDepth = rowMiddle(rows - 1, rows) + (rows % 2 == 1 ? 1.5f : 0.5f) * kBayLength + kLane / 2;
  const glm::vec3 asphalt(0.085f, 0.09f, 0.10f);
  const glm::vec3 paint(0.75f, 0.75f, 0.70f);
  // Lines at both sides of each bay; cells between are asphalt.
  constexpr float kHalfLine = 0.06f;
  std::vector<float> xs{-halfWidth};
  for (size_t i = 0; i <= columns; ++i) {
    const float x = (static_cast<float>(i) - static_cast<float>(columns) / 2) * kBayWidth;
    xs.push_back(x - kHalfLine);
    xs.push_back(x + kHalfLine);
  }
  xs.push_back(halfWidth);
  std::vector<float> zs{-halfDepth};
  for (size_t row = 0; row < rows; ++row) {
    zs.push_back(rowMiddle(row, rows) - 0.48f * kBayLength);
    zs.push_back(rowMiddle(row, rows) + 0.48f * kBayLength);
  }
  zs.push_back(halfDepth);
  Mesh ground;
  // The panel's y is -z, so that its front is up.
  std::vector<float> ys;
  for (auto z = zs.rbegin(); z != zs.rend(); ++z) {
    ys.push_back(-*z);
  }
  const glm::mat4 lying = glm::rotate(glm::mat4(1), static_cast<float>(radiansFromDegrees(-90.0)), glm::vec3(1, 0, 0));
  addPanel(ground, xs, ys, lying, [&](size_t i, size_t j) { return i % 2 == 1 && j % 2 == 1 ? paint : asphalt; });
  return ground;
}

Scene buildParking(const BuiltinValues& values) {
  const size_t count = values.count("tiles");
  const size_t columns = columnsFor(count, 2.4);
  const size_t rows = (count + columns - 1) / columns;
  std::vector<TilePlace> places;
  for (size_t i = 0; i < count; ++i) {
    const auto tile = static_cast<uint32_t>(i);
    const size_t row = i / columns;
    const bool backwards = jitter(tile, 3) > 0.4f;
    // Noses towards the other row of the pair, some the other way round.
    const double turn =
        (row % 2 == 0 ? -90.0 : 90.0) + (backwards ? 180 : 0) + 3 * static_cast<double>(jitter(tile, 4));
    places.push_back({centred(i % columns, columns) * kBayWidth + 0.15f * jitter(tile, 1),
                      rowMiddle(row, rows) + 0.2f * jitter(tile, 2), turn});
  }
  std::vector<std::string> warnings;
  constexpr float kObjectSide = 2.2f;
  Mesh object = tileObject(values, makeCar(), kObjectSide, warnings);
  return tiledScene(makeCarPark(columns, rows), std::move(object), true, places, std::move(warnings));
}

Scene buildBarrels(const BuiltinValues& values) {
  const size_t count = values.count("tiles");
  const size_t columns = columnsFor(count, 1.67);
  const size_t rows = (count + columns - 1) / columns;
  constexpr float kSpacing = 1.0f;
  std::vector<TilePlace> places;
  for (size_t i = 0; i < count; ++i) {
    const auto tile = static_cast<uint32_t>(i);
    places.push_back({(centred(i % columns, columns) + 0.11f * jitter(tile, 1)) * kSpacing,
                      (centred(i / columns, rows) + 0.11f * jitter(tile, 2)) * kSpacing,
                      180 * static_cast<double>(jitter(tile, 3))});
  }
  std::vector<std::string> warnings;
  constexpr float kObjectSide = 0.9f;
  Mesh object = tileObject(values, makeBarrel(), kObjectSide, warnings);
  Mesh ground;
  const glm::vec2 half(kSpacing * (static_cast<float>(columns) / 2 + 0.3f),
                       kSpacing * (static_cast<float>(rows) / 2 + 0.3f));
  addCheckerFloor(ground, -half, half, 0, columns + 1, rows + 1, palette::slate(), palette::ivory());
  return tiledScene(std::move(ground), std::move(object), !values.path("mesh").empty(), places, std::move(warnings));
}

BuiltinParameter tilesParameter(const char* otherwise) {
  return {"tiles", "how many stand there", BuiltinParameter::Kind::kInteger, otherwise, 1, kMaxTiles};
}

BuiltinParameter tileMeshParameter(const char* summary) {
  return {"mesh", summary, BuiltinParameter::Kind::kFile, "", 0, 0};
}

std::vector<RoledObject> tileRoles() {
  return {{.object = 0, .roles = kIsBillboard | kReceives},
          {.object = kTileObject, .roles = kIsRelief | kCasts | kReceives}};
}

}  // namespace

BuiltinScene parkingScene() {
  return {
      .name = "parking",
      .summary = "a car park with 40 cars, which relief tiles stand for (ocelli shade --effect relief)",
      .parameters = {tilesParameter("40"), tileMeshParameter("scene file to show instead of a car"), turnParameter()},
      .build = buildParking,
      .roles = tileRoles()};
}

BuiltinScene barrelsScene() {
  return {.name = "barrels",
          .summary = "60 barrels close together, which relief tiles stand for (ocelli shade --effect relief)",
          .parameters = {tilesParameter("60"), tileMeshParameter("scene file to show instead of a barrel"),
                         turnParameter()},
          .build = buildBarrels,
          .roles = tileRoles()};
}

}  // namespace ocelli
