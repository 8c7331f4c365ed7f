#include "oc_core/worlds/town_house.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/ext/matrix_transform.hpp>

#include "oc_core/base/conventions.h"
#include "oc_core/scene/scene.h"
#include "oc_core/worlds/palette.h"
#include "oc_core/worlds/panels.h"
#include "oc_core/worlds/placement.h"
#include "oc_core/worlds/solids.h"
#include "oc_core/worlds/wall_slab.h"

namespace ocelli {
namespace {

constexpr float kPitch = 0.75f;     // height of a gable, of half its width
constexpr float kOverhang = 0.45f;  // of the roof
constexpr float kParapet = 0.7f;    // of a flat one
constexpr float kRoofThickness = 0.18f;

void addBox(Mesh& mesh, const glm::vec3& size, const glm::mat4& worldFromBox, const glm::vec3& color) {
  Mesh box = makeBox(size * 0.5f);
  paint(box, color);
  append(mesh, box, worldFromBox);
}

/// Lines with `parts` cells between each two neighbours.
std::vector<float> refined(const std::vector<float>& lines, size_t parts) {
  std::vector<float> all;
  for (size_t i = 0; i + 1 < lines.size(); ++i) {
    const std::vector<float> between = evenLines(lines[i], lines[i + 1], parts);
    all.insert(all.end(), between.begin(), between.end() - 1);
  }
  all.push_back(lines.back());
  return all;
}

class HouseBuilder {
 public:
  HouseBuilder(const House& house, size_t detail) : house_(house), detail_(detail), wallEnd_(house.wallTop()) {
    if (house.roof == RoofKind::kFlat) {
      wallEnd_ += kParapet;
    }
  }

  Mesh build() {
    const float w = house_.width;
    const float d = house_.depth;
    addWall(w, {0, 0, d / 2}, 0, true);
    addWall(w, {0, 0, -d / 2}, 180, false);
    addWall(d - 2 * kHouseWall, {w / 2, 0, 0}, 90, false);
    addWall(d - 2 * kHouseWall, {-w / 2, 0, 0}, 270, false);
    addFloors();
    switch (house_.roof) {
      case RoofKind::kFlat:
        break;
      case RoofKind::kFrontGable:
        addGableRoof(w, d, 0);
        break;
      case RoofKind::kSideGable:
        addGableRoof(d, w, 90);
        break;
    }
    addDoor();
    addFurniture();
    return std::move(mesh_);
  }

 private:
  /// A wall whose outer face stands at `place` and looks to +z, turned about the vertical.
  void addWall(float width, const glm::vec3& place, double turnDegrees, bool isFront) {
    const int bays = bayCount(width);
    std::vector<float> xs{-width / 2};
    for (int bay = 0; bay < bays; ++bay) {
      xs.push_back(bayCenter(width, bay) - kOpeningHalfWidth);
      xs.push_back(bayCenter(width, bay) + kOpeningHalfWidth);
    }
    xs.push_back(width / 2);
    std::vector<float> ys{0};
    for (int storey = 0; storey < house_.storeys; ++storey) {
      const float floor = kStoreyHeight * static_cast<float>(storey);
      ys.push_back(floor + kSillHeight);
      ys.push_back(floor + kLintelHeight);
    }
    ys.push_back(wallEnd_);
    WallSlab wall;
    wall.xs = refined(xs, detail_);
    wall.ys = refined(ys, detail_);
    wall.thickness = kHouseWall;
    wall.back = mix(house_.wallColor, palette::ivory(), 0.6f);
    wall.color = [&](size_t i, size_t j) {
      if (j == 0 || j + 2 == wall.ys.size()) {
        return house_.wallColor * 0.6f;  // plinth and cornice
      }
      return house_.wallColor * ((i + j) % 2 == 0 ? 1.0f : 0.94f);
    };
    wall.isOpen = [&](size_t i, size_t j) {
      const size_t column = i / detail_;
      const size_t row = j / detail_;
      const bool isDoor = isFront && row == 0 && column == 2 * static_cast<size_t>(house_.doorBay) + 1;
      return isDoor || (column % 2 == 1 && row % 2 == 1);
    };
    const glm::mat4 houseFromWall = placedAt(place, turnDegrees);
    addSlab(mesh_, wall, houseFromWall);
    for (int storey = 0; storey < house_.storeys; ++storey) {
      for (int bay = 0; bay < bays; ++bay) {
        const bool isShop = isFront && storey == 0;
        const glm::vec3 foot(bayCenter(width, bay), kStoreyHeight * static_cast<float>(storey), 0);
        addFrame(houseFromWall * placedAt(foot), isShop && bay == house_.doorBay, !isShop);
      }
    }
  }

  /// The frame around an opening whose foot, on the floor of its storey, is the origin.
  void addFrame(const glm::mat4& houseFromFoot, bool isDoor, bool hasPanes) {
    constexpr float kBoard = 0.13f;
    const float half = kOpeningHalfWidth;
    const float low = isDoor ? 0 : kSillHeight;
    const float middle = (low + kLintelHeight) / 2;
    WallSlab frame;
    frame.thickness = 0.12f;
    frame.back = palette::ivory();
    frame.color = [](size_t, size_t) { return palette::ivory(); };
    frame.xs = {-half - kBoard, -half, half, half + kBoard};
    frame.ys = isDoor ? std::vector<float>{low, kLintelHeight, kLintelHeight + kBoard}
                      : std::vector<float>{low - kBoard, low, kLintelHeight, kLintelHeight + kBoard};
    const size_t openRow = isDoor ? 0 : 1;
    frame.isOpen = [&](size_t i, size_t j) { return i == 1 && j == openRow; };
    if (hasPanes) {
      const float height = kLintelHeight - low;
      addBox(mesh_, {2 * half, height, 0.04f}, houseFromFoot * placedAt({0, middle, -0.12f}),
             palette::fromSrgbBytes(92, 142, 178));
      addBox(mesh_, {0.07f, height, 0.08f}, houseFromFoot * placedAt({0, middle, -0.07f}), palette::ivory());
      addBox(mesh_, {2 * half, 0.07f, 0.07f}, houseFromFoot * placedAt({0, middle, -0.07f}), palette::ivory());
    }
    addSlab(mesh_, frame, houseFromFoot * placedAt({0, 0, 0.06f}));
  }

  void addFloors() {
    const glm::vec2 inside(house_.width - 2 * kHouseWall, house_.depth - 2 * kHouseWall);
    for (int storey = 0; storey <= house_.storeys; ++storey) {
      const bool isRoof = storey == house_.storeys;
      const float top = storey == 0 ? 0.06f : kStoreyHeight * static_cast<float>(storey);
      WallSlab floor;
      floor.xs = evenLines(-inside.x / 2, inside.x / 2, 8);
      floor.ys = evenLines(-inside.y / 2, inside.y / 2, 8);
      floor.thickness = storey == 0 ? 0.06f : 0.25f;
      floor.back = palette::ivory();
      floor.color = [&](size_t i, size_t j) {
        return isRoof ? house_.roofColor * 0.8f
                      : palette::fromSrgbBytes(190, 140, 96) * ((i + j) % 2 == 0 ? 1.0f : 0.72f);
      };
      addSlab(mesh_, floor, placedAt({0, top, 0}, -90, {1, 0, 0}));
    }
  }

  /// The ridge runs along z of a frame that is turned about the vertical; `span` across it, `length` along it.
  void addGableRoof(float span, float length, double turnDegrees) {
    const glm::mat4 houseFromRoof = placedAt({0, wallEnd_, 0}, turnDegrees);
    const float rise = kPitch * span / 2;
    Mesh gable = makePrism({{-span / 2, 0}, {span / 2, 0}, {0, rise}}, length / 2);
    paint(gable, house_.wallColor);
    append(mesh_, gable, houseFromRoof);
    const float slope = std::hypot(span / 2, rise);
    const float below = kOverhang * slope / (span / 2);  // along the slope
    const double angle = degreesFromRadians(std::atan2(rise, span / 2));
    for (const double side : {0.0, 180.0}) {
      WallSlab tiles;
      tiles.xs = evenLines(-length / 2 - kOverhang, length / 2 + kOverhang, 16);
      tiles.ys = evenLines(-below, slope + 0.05f, 10);
      tiles.thickness = kRoofThickness;
      tiles.back = palette::ivory() * 0.7f;
      tiles.color = [&](size_t i, size_t j) {
        return house_.roofColor * ((i + j % 2 * 2) % 4 < 2 ? 1.0f : 0.82f) * (j == 0 ? 0.75f : 1.0f);
      };
      // From the eaves at +x up to the ridge: slab x runs along -z, slab y up the slope, its front looks out.
      const glm::mat4 roofFromSide = placedAt({0, 0, 0}, side) * placedAt({span / 2, 0.02f, 0}, 90) *
                                     placedAt({0, 0, 0}, angle - 90, {1, 0, 0}) * placedAt({0, 0, kRoofThickness});
      addSlab(mesh_, tiles, houseFromRoof * roofFromSide);
    }
    addBox(mesh_, {0.7f, rise + 0.9f, 0.7f}, houseFromRoof * placedAt({span * 0.22f, (rise + 0.9f) / 2, length * 0.2f}),
           palette::brick());
  }

  void addDoor() {
    const float x = bayCenter(house_.width, house_.doorBay);
    // The leaf hangs at the left side of the doorway and opens inwards.
    const float height = kLintelHeight - 0.06f;
    addBox(mesh_, {2 * kOpeningHalfWidth - 0.06f, height, 0.06f},
           placedAt({x - kOpeningHalfWidth + 0.03f, 0, house_.depth / 2 - kHouseWall}, 80) *
               placedAt({kOpeningHalfWidth, height / 2 + 0.06f, 0}),
           house_.doorColor);
    addBox(mesh_, {2 * kOpeningHalfWidth + 0.5f, 0.1f, 0.7f}, placedAt({x, 0.05f, house_.depth / 2 + 0.35f}),
           palette::mortar());
    // An awning over the doorway.
    addBox(mesh_, {2 * kOpeningHalfWidth + 0.7f, 0.08f, 1.0f},
           placedAt({x, kLintelHeight + 0.3f, house_.depth / 2 + 0.45f}, 14, {1, 0, 0}), house_.doorColor);
  }

  void addFurniture() {
    addBox(mesh_, {1.6f, 0.08f, 1.0f}, placedAt({0, 0.8f, -house_.depth * 0.15f}), palette::fromSrgbBytes(150, 98, 60));
    addBox(mesh_, {0.3f, 0.7f, 0.3f}, placedAt({0, 0.41f, -house_.depth * 0.15f}), palette::fromSrgbBytes(120, 78, 48));
    Mesh vase = makeTurned({{0, 0}, {0.14f, 0}, {0.22f, 0.2f}, {0.08f, 0.42f}, {0.12f, 0.5f}, {0, 0.5f}}, 16);
    paint(vase, house_.doorColor);
    append(mesh_, vase, placedAt({0.3f, 0.84f, -house_.depth * 0.15f}));
    addBox(mesh_, {1.4f, 1.9f, 0.4f}, placedAt({-house_.width * 0.25f, 1.01f, -house_.depth / 2 + kHouseWall + 0.25f}),
           house_.roofColor);
  }

  const House& house_;
  size_t detail_;
  float wallEnd_;
  Mesh mesh_;
};

}  // namespace

Mesh makeHouse(const House& house, size_t detail) {
  return HouseBuilder(house, detail).build();
}

}  // namespace ocelli
