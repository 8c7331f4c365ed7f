#include "oc_core/worlds/city_house.h"

#include <glm/ext/matrix_transform.hpp>
#include <utility>

#include "oc_core/worlds/facade.h"
#include "oc_core/worlds/palette.h"
#include "oc_core/worlds/panels.h"
#include "oc_core/worlds/placement.h"
#include "oc_core/worlds/solids.h"
#include "oc_core/worlds/wall_slab.h"

namespace ocelli {
namespace {

constexpr float kCityShell = 0.25f;   // thickness of the outer shell of a house
constexpr float kCityParapet = 0.8f;  // of a flat roof
constexpr float kEaves = 0.35f;       // of a roof over a facade
constexpr float kBay = 2.3f;          // width of a bay of windows, about
constexpr float kHalfWindow = 0.55f;
constexpr float kSill = 0.95f;  // over the floor of a storey
constexpr float kLintel = 2.45f;
constexpr float kHalfDoor = 0.6f;

/// Counter-clockwise seen from above, of a wall whose outside looks to the south when it is not turned.
double turnOf(CitySide side) {
  switch (side) {
    case CitySide::kSouth:
      return 0;
    case CitySide::kEast:
      return 90;
    case CitySide::kNorth:
      return 180;
    case CitySide::kWest:
      return 270;
  }
  return 0;
}

class CityHouseBuilder {
 public:
  CityHouseBuilder(const CityHouse& house, float maxCell)
      : house_(house),
        maxCell_(maxCell),
        size_(house.area.size()),
        wallEnd_(house.wallTop() + (house.roof == CityRoof::kFlat ? kCityParapet : 0)) {}

  Mesh build() {
    for (const CitySide side : kCitySides) {
      addCityWall(side);
    }
    // What is behind the openings of the shell: panes that nobody looks through.
    const float inner = kCityShell - 0.03f;
    const float top = house_.wallTop();
    addPaintedBox(mesh_, {size_.x - 2 * inner, top, size_.y - 2 * inner}, placedAt({0, top / 2, 0}),
                  palette::fromSrgbBytes(92, 142, 178));
    switch (house_.roof) {
      case CityRoof::kFlat:
        addFlatRoof();
        break;
      case CityRoof::kAlongX:
        addRoof(size_.y, size_.x, 90, CitySide::kNorth, CitySide::kSouth);
        break;
      case CityRoof::kAlongZ:
        addRoof(size_.x, size_.y, 0, CitySide::kEast, CitySide::kWest);
        break;
    }
    Mesh placed;
    const glm::vec2 center = house_.area.center();
    append(placed, mesh_, placedAt({center.x, 0, center.y}));
    return placed;
  }

 private:
  bool hasFacade(CitySide side) const { return house_.hasFacade[static_cast<size_t>(side)]; }

  void addCityWall(CitySide side) {
    const bool isAlongX = side == CitySide::kSouth || side == CitySide::kNorth;
    // Those along x have the corners.
    const float width = isAlongX ? size_.x : size_.y - 2 * kCityShell;
    const glm::mat4 houseFromWall =
        placedAt({0, 0, 0}, turnOf(side)) * placedAt({0, 0, (isAlongX ? size_.y : size_.x) / 2});
    const int bays = hasFacade(side) ? static_cast<int>(width / kBay) : 0;
    const auto center = [&](int bay) {
      return width * ((static_cast<float>(bay) + 0.5f) / static_cast<float>(bays) - 0.5f);
    };
    const int doorBay = side == house_.door && bays > 0 ? bays / 2 : -1;
    std::vector<float> xs{-width / 2};
    for (int bay = 0; bay < bays; ++bay) {
      xs.push_back(center(bay) - kHalfWindow);
      xs.push_back(center(bay) + kHalfWindow);
    }
    xs.push_back(width / 2);
    std::vector<float> ys{0, kCityKerb};
    for (int storey = 0; storey < house_.storeys; ++storey) {
      ys.push_back(kCityStorey * static_cast<float>(storey) + kSill);
      ys.push_back(kCityStorey * static_cast<float>(storey) + kLintel);
    }
    ys.push_back(house_.wallTop() - 0.25f);
    ys.push_back(wallEnd_);
    WallSlab wall;
    wall.xs = closerLines(xs, maxCell_);
    wall.ys = closerLines(ys, maxCell_);
    const std::vector<size_t> columns = cellsOfLines(xs, wall.xs);
    const std::vector<size_t> rows = cellsOfLines(ys, wall.ys);
    wall.thickness = kCityShell;
    wall.back = house_.wallColor;
    wall.color = [&](size_t i, size_t j) {
      if (rows[j] == 0 || rows[j] + 2 == ys.size()) {
        return house_.wallColor * 0.62f;  // plinth and cornice
      }
      return house_.wallColor * ((i + j) % 2 == 0 ? 1.0f : 0.93f);
    };
    // Rows: the plinth, up to the sill, the windows of the ground floor, ...
    wall.isOpen = [&](size_t i, size_t j) {
      const bool isBay = columns[i] % 2 == 1 && bays > 0;
      const bool isDoor = doorBay >= 0 && columns[i] == 2 * static_cast<size_t>(doorBay) + 1 && rows[j] == 1;
      return isDoor || (isBay && rows[j] >= 2 && rows[j] % 2 == 0 && rows[j] + 2 < ys.size());
    };
    addSlab(mesh_, wall, houseFromWall);
    for (int storey = 0; storey < house_.storeys; ++storey) {
      for (int bay = 0; bay < bays; ++bay) {
        const float floor = kCityStorey * static_cast<float>(storey);
        if (storey == 0 && bay == doorBay) {
          addCityDoor(houseFromWall * placedAt({center(bay), 0, 0}));
        } else {
          addWindow(mesh_, {center(bay) - kHalfWindow, center(bay) + kHalfWindow, floor + kSill, floor + kLintel},
                    houseFromWall, palette::ivory());
        }
      }
    }
  }

  /// A closed door in the doorway whose foot is the origin, and an awning over it.
  void addCityDoor(const glm::mat4& houseFromFoot) {
    const float height = kLintel - kCityKerb;
    addPaintedBox(mesh_, {2 * kHalfWindow, height, 0.08f},
                  houseFromFoot * placedAt({0, kCityKerb + height / 2, -0.16f}), house_.doorColor);
    addPaintedBox(mesh_, {0.06f, 0.12f, 0.06f}, houseFromFoot * placedAt({0.4f, 1.1f, -0.1f}), palette::ivory());
    addDoorFrame(mesh_, {-kHalfWindow, kHalfWindow, kCityKerb, kLintel}, 0.05f, houseFromFoot, palette::ivory());
    addPaintedBox(mesh_, {2 * kHalfDoor + 0.6f, 0.08f, 0.8f},
                  houseFromFoot * placedAt({0, kLintel + 0.35f, 0.35f}, 14, {1, 0, 0}), house_.doorColor);
  }

  void addFlatRoof() {
    WallSlab roof;
    roof.xs = closerLines({-size_.x / 2 + kCityShell, size_.x / 2 - kCityShell}, 2 * maxCell_);
    roof.ys = closerLines({-size_.y / 2 + kCityShell, size_.y / 2 - kCityShell}, 2 * maxCell_);
    roof.thickness = 0.2f;
    roof.back = house_.roofColor;
    roof.color = [&](size_t i, size_t j) { return house_.roofColor * ((i + j) % 2 == 0 ? 0.9f : 0.8f); };
    addSlab(mesh_, roof, placedAt({0, house_.wallTop() + 0.1f, 0}, -90, {1, 0, 0}));
    addPaintedBox(mesh_, {1.6f, 1.2f, 1.2f}, placedAt({size_.x * 0.2f, house_.wallTop() + 0.7f, size_.y * 0.15f}),
                  palette::mortar());
  }

  /// The ridge runs along z of a frame that is turned about the vertical; `upper` is the side of the house at +x of
  /// that frame, `lower` the other.
  void addRoof(float span, float length, double turnDegrees, CitySide upper, CitySide lower) {
    PitchedRoof roof;
    roof.span = span;
    roof.length = length;
    // Over a bare wall, which a neighbour stands against, the roof ends with the wall.
    roof.eavesAtUpperX = hasFacade(upper) ? kEaves : 0;
    roof.eavesAtLowerX = hasFacade(lower) ? kEaves : 0;
    roof.maxCell = maxCell_;
    roof.wallColor = house_.wallColor;
    roof.roofColor = house_.roofColor;
    const glm::mat4 houseFromRoof = placedAt({0, wallEnd_, 0}, turnDegrees);
    addPitchedRoof(mesh_, roof, houseFromRoof);
    const float rise = roof.pitch * span / 2;
    addPaintedBox(mesh_, {0.7f, rise * 0.6f + 0.9f, 0.7f},
                  houseFromRoof * placedAt({span * 0.2f, rise * 0.45f + 0.4f, length * 0.2f}), palette::brick());
  }

  const CityHouse& house_;
  float maxCell_;
  glm::vec2 size_;
  float wallEnd_;
  Mesh mesh_;
};

void addCityPiece(Mesh& mesh, Mesh part, const glm::mat4& worldFromPart, const glm::vec3& color) {
  paint(part, color);
  append(mesh, part, worldFromPart);
}

}  // namespace

Mesh makeCityHouse(const CityHouse& house, float maxCell) {
  return CityHouseBuilder(house, maxCell).build();
}

Mesh makeFountain() {
  Mesh fountain;
  addCityPiece(fountain, makeTurned({{0, 0}, {2.2f, 0}, {2.2f, 0.5f}, {1.9f, 0.5f}, {1.9f, 0.3f}, {0, 0.3f}}, 48),
               glm::mat4(1), palette::mortar());
  addCityPiece(fountain, makeTurned({{0, 0.28f}, {1.89f, 0.28f}, {1.89f, 0.38f}, {0, 0.38f}}, 48), glm::mat4(1),
               palette::skyBlue());
  addCityPiece(
      fountain,
      makeTurned(
          {{0, 0.3f}, {0.4f, 0.3f}, {0.25f, 1.2f}, {0.3f, 1.5f}, {1, 1.7f}, {1, 1.8f}, {0.3f, 1.65f}, {0, 1.65f}}, 32),
      glm::mat4(1), palette::ivory());
  addCityPiece(fountain, makeTurned({{0, 1.6f}, {0.15f, 1.6f}, {0.1f, 2.2f}, {0, 2.2f}}, 24), glm::mat4(1),
               palette::ivory() * 0.9f);
  addCityPiece(fountain, makeSphere(24), glm::scale(placedAt({0, 2.4f, 0}), glm::vec3(0.28f)), palette::vermilion());
  return fountain;
}

Mesh makeBench() {
  Mesh bench;
  const glm::vec3 wood = palette::fromSrgbBytes(150, 98, 60);
  for (int i = 0; i < 3; ++i) {
    const auto step = static_cast<float>(i);
    addPaintedBox(bench, {1.6f, 0.05f, 0.11f}, placedAt({0, 0.44f, -0.1f + 0.14f * step}), wood);
    addPaintedBox(bench, {1.6f, 0.11f, 0.04f}, placedAt({0, 0.56f + 0.15f * step, -0.2f}), wood * 0.9f);
  }
  for (const float x : {-0.65f, 0.65f}) {
    addPaintedBox(bench, {0.07f, 0.415f, 0.38f}, placedAt({x, 0.2075f, 0.02f}), palette::slate());
    addPaintedBox(bench, {0.07f, 0.5f, 0.05f}, placedAt({x, 0.66f, -0.245f}), palette::slate());
  }
  return bench;
}

Mesh makeBin(const glm::vec3& color) {
  Mesh bin;
  addCityPiece(bin, makeTurned({{0, 0}, {0.2f, 0}, {0.26f, 0.8f}, {0.22f, 0.8f}, {0.17f, 0.2f}, {0, 0.2f}}, 20),
               glm::mat4(1), color);
  addCityPiece(bin, makeTurned({{0, 0.78f}, {0.28f, 0.78f}, {0.28f, 0.86f}, {0.1f, 0.95f}, {0, 0.95f}}, 20),
               glm::mat4(1), palette::slate());
  return bin;
}

}  // namespace ocelli
