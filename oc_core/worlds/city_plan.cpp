#include "oc_core/worlds/city_plan.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "oc_core/base/check.h"
#include "oc_core/base/random.h"
#include "oc_core/worlds/palette.h"

namespace ocelli {
namespace {

constexpr float kMinBlock = 15;       // side of a block that streets leave, metres
constexpr float kMinAlleyBlock = 30;  // of a block that an alley enters, across and along it
constexpr float kTwoRows = 17;        // depth of a block from which on it has houses back to back
constexpr float kMinHouseFront = 6;
constexpr float kMaxHouseFront = 10;
constexpr float kMaxSetback = 1.6f;  // of a facade behind the edge of its lot
constexpr float kMaxAlleySetback = 0.5f;

constexpr size_t at(CitySide side) {
  return static_cast<size_t>(side);
}

const glm::vec3& anyOfColors(const std::vector<glm::vec3>& colors, Random& random) {
  return colors[random.below(colors.size())];
}

const std::vector<glm::vec3>& cityWallColors() {
  static const std::vector<glm::vec3> colors{
      palette::fromSrgbBytes(236, 206, 160), palette::fromSrgbBytes(226, 160, 138),
      palette::fromSrgbBytes(160, 200, 214), palette::fromSrgbBytes(178, 206, 150),
      palette::fromSrgbBytes(240, 228, 196), palette::fromSrgbBytes(204, 172, 208),
      palette::fromSrgbBytes(244, 214, 116), palette::fromSrgbBytes(206, 128, 98)};
  return colors;
}

const std::vector<glm::vec3>& cityRoofColors() {
  static const std::vector<glm::vec3> colors{palette::fromSrgbBytes(182, 74, 58), palette::fromSrgbBytes(98, 110, 134),
                                             palette::fromSrgbBytes(134, 92, 70), palette::fromSrgbBytes(64, 128, 122)};
  return colors;
}

const std::vector<glm::vec3>& cityBrightColors() {
  static const std::vector<glm::vec3> colors{palette::vermilion(), palette::blue(),    palette::green(),
                                             palette::yellow(),    palette::skyBlue(), palette::orange(),
                                             palette::ivory(),     palette::purple()};
  return colors;
}

/// A rectangle whose x is along and whose y is across a row of houses or a street, which runs along x or along z.
CityRectangle turnedRow(bool isAlongX, float along0, float along1, float across0, float across1) {
  return isAlongX ? CityRectangle{{along0, across0}, {along1, across1}}
                  : CityRectangle{{across0, along0}, {across1, along1}};
}

class CityPlanner {
 public:
  explicit CityPlanner(const CityOptions& options) : random_(options.seed) {
    plan_.inside = {glm::vec2(-options.size / 2), glm::vec2(options.size / 2)};
  }

  CityPlan plan() {
    CityBlock whole;
    whole.area = plan_.inside;
    cut(whole, 0);
    const CityStreet& main = plan_.streets.front();
    plan_.gate = {main.area.center().x, 0, plan_.inside.upper.y};
    chooseSquares();
    enterByAlleys();
    for (const CityBlock& block : plan_.blocks) {
      if (block.isSquare) {
        furnishSquare(block);
      } else {
        build(block);
      }
    }
    for (const CityStreet& street : plan_.streets) {
      furnishStreet(street);
    }
    return std::move(plan_);
  }

 private:
  float newStreetWidth(int depth) {
    switch (depth) {
      case 0:
        return 14;
      case 1:
        return random_.inRange(9, 12);
      case 2:
        return random_.inRange(7, 10);
      default:
        return random_.inRange(5, 7.5f);
    }
  }

  /// Cuts a part of the city in two by a street across it, again and again, until blocks are left. The first street
  /// runs along z.
  void cut(const CityBlock& part, int depth) {
    const glm::vec2 size = part.area.size();
    const bool isAlongX = depth > 0 && size.y > size.x;  // of the street: it halves the longer side
    const float length = isAlongX ? size.y : size.x;
    const float width = newStreetWidth(depth);
    if (length < random_.inRange(34, 52) || length < 2 * kMinBlock + width) {
      plan_.blocks.push_back(part);
      return;
    }
    const float share = depth == 0 ? random_.inRange(0.42f, 0.58f) : random_.inRange(0.32f, 0.68f);
    const float from = isAlongX ? part.area.lower.y : part.area.lower.x;
    const float first = from + std::clamp(length * share - width / 2, kMinBlock, length - kMinBlock - width);
    const float second = first + width;
    CityStreet street;
    street.isAlongX = isAlongX;
    CityBlock before = part;
    CityBlock behind = part;
    if (isAlongX) {
      street.area = {{part.area.lower.x, first}, {part.area.upper.x, second}};
      before.area.upper.y = first;
      behind.area.lower.y = second;
      before.streetWidth[at(CitySide::kSouth)] = width;
      behind.streetWidth[at(CitySide::kNorth)] = width;
    } else {
      street.area = {{first, part.area.lower.y}, {second, part.area.upper.y}};
      before.area.upper.x = first;
      behind.area.lower.x = second;
      before.streetWidth[at(CitySide::kEast)] = width;
      behind.streetWidth[at(CitySide::kWest)] = width;
    }
    plan_.streets.push_back(street);
    cut(before, depth + 1);
    cut(behind, depth + 1);
  }

  /// The block nearest to the middle, and in a larger city the one farthest from that which shares no street with it,
  /// of those that have streets on most sides.
  void chooseSquares() {
    const CityBlock* first = chooseSquare(plan_.inside.center(), 1, nullptr);
    if (plan_.blocks.size() >= 10) {
      chooseSquare(first->area.center(), -1, first);
    }
  }

  /// Near to `from` where `sign` is 1, far from it where that is -1.
  const CityBlock* chooseSquare(const glm::vec2& from, float sign, const CityBlock* other) {
    const auto rank = [&](const CityBlock& block) {
      const auto sides =
          std::count_if(block.streetWidth.begin(), block.streetWidth.end(), [](float w) { return w > 0; });
      // A side more on a street counts as much as 40 m of distance.
      return 40.0f * static_cast<float>(sides) - sign * glm::length(block.area.center() - from);
    };
    CityBlock* best = nullptr;
    for (CityBlock& block : plan_.blocks) {
      const bool isApart = other == nullptr || !block.withStreets().meets(other->withStreets());
      if (isApart && (best == nullptr || rank(block) > rank(*best))) {
        best = &block;
      }
    }
    if (best != nullptr) {
      best->isSquare = true;
    }
    return best;
  }

  /// An alley from a street into about half of the blocks that are large enough; it leaves three blocks of one.
  void enterByAlleys() {
    std::vector<CityBlock> blocks;
    for (const CityBlock& block : plan_.blocks) {
      const CitySide side = kCitySides[random_.below(4)];
      const bool isAlongX = side == CitySide::kWest || side == CitySide::kEast;
      const float along = isAlongX ? block.area.size().x : block.area.size().y;
      const float across = isAlongX ? block.area.size().y : block.area.size().x;
      const bool enters =
          block.streetWidth[at(side)] > 0 && across >= kMinAlleyBlock && along >= 0.75f * kMinAlleyBlock;
      if (block.isSquare || !enters) {
        blocks.push_back(block);
        continue;
      }
      addAlley(block, side, blocks);
    }
    plan_.blocks = std::move(blocks);
  }

  void addAlley(const CityBlock& block, CitySide side, std::vector<CityBlock>& blocks) {
    const bool isAlongX = side == CitySide::kWest || side == CitySide::kEast;
    const bool fromUpper = side == CitySide::kEast || side == CitySide::kSouth;
    const glm::vec2 lower = block.area.lower;
    const glm::vec2 upper = block.area.upper;
    const float along0 = isAlongX ? lower.x : lower.y;
    const float along1 = isAlongX ? upper.x : upper.y;
    const float across0 = isAlongX ? lower.y : lower.x;
    const float across1 = isAlongX ? upper.y : upper.x;
    const float width = random_.inRange(3, 4.5f);
    const float length = (along1 - along0) * random_.inRange(0.45f, 0.6f);
    const float first = across0 + (across1 - across0) * random_.inRange(0.38f, 0.62f) - width / 2;
    const float end = fromUpper ? along1 - length : along0 + length;
    const float mouth = fromUpper ? along1 : along0;
    const auto area = [&](float from, float to, float a0, float a1) {
      return turnedRow(isAlongX, std::min(from, to), std::max(from, to), a0, a1);
    };
    plan_.streets.push_back({area(end, mouth, first, first + width), isAlongX, true});
    const CitySide inner =
        fromUpper ? (isAlongX ? CitySide::kWest : CitySide::kNorth) : (isAlongX ? CitySide::kEast : CitySide::kSouth);
    const CitySide low = isAlongX ? CitySide::kNorth : CitySide::kWest;
    const CitySide high = isAlongX ? CitySide::kSouth : CitySide::kEast;
    const auto add = [&](const CityRectangle& where, CitySide free, CitySide onAlley, bool hasAlley) {
      CityBlock part = block;
      part.area = where;
      part.streetWidth[at(free)] = 0;
      if (hasAlley) {
        part.streetWidth[at(onAlley)] = width;
        part.isOnAlley[at(onAlley)] = true;
      }
      blocks.push_back(part);
    };
    add(area(end, mouth, across0, first), inner, high, true);
    add(area(end, mouth, first + width, across1), inner, low, true);
    // The one at its end is bare towards it, and towards its neighbours.
    add(area(fromUpper ? along0 : along1, end, across0, across1), side, side, false);
  }

  /// One row of houses from street to street, or two back to back, along the longer side of the block.
  void build(const CityBlock& block) {
    const bool isAlongX = block.area.size().x >= block.area.size().y;
    const glm::vec2 lower = block.area.lower;
    const glm::vec2 upper = block.area.upper;
    const float along0 = isAlongX ? lower.x : lower.y;
    const float along1 = isAlongX ? upper.x : upper.y;
    const float across0 = isAlongX ? lower.y : lower.x;
    const float across1 = isAlongX ? upper.y : upper.x;
    if (across1 - across0 < kTwoRows) {
      buildRow(block, isAlongX, along0, along1, across0, across1);
      return;
    }
    const float middle = (across0 + across1) / 2;
    buildRow(block, isAlongX, along0, along1, across0, middle);
    buildRow(block, isAlongX, along0, along1, middle, across1);
  }

  void buildRow(const CityBlock& block, bool isAlongX, float along0, float along1, float across0, float across1) {
    float from = along0;
    while (from < along1) {
      const float left = along1 - from;
      float front = random_.inRange(kMinHouseFront, kMaxHouseFront);
      // What would be left after this one has room for another, or is taken too.
      if (left - front < kMinHouseFront) {
        front = left <= kMaxHouseFront + 2 ? left : left / 2;
      }
      const float to = front == left ? along1 : from + front;
      buildHouse(block, turnedRow(isAlongX, from, to, across0, across1));
      from = to;
    }
  }

  void buildHouse(const CityBlock& block, const CityRectangle& lot) {
    CityHouse house;
    house.area = lot;
    const std::array<bool, 4> isAtEdge{lot.lower.x == block.area.lower.x, lot.upper.x == block.area.upper.x,
                                       lot.lower.y == block.area.lower.y, lot.upper.y == block.area.upper.y};
    float widest = 0;
    for (const CitySide side : kCitySides) {
      const float width = block.streetWidth[at(side)];
      if (!isAtEdge[at(side)] || width == 0) {
        continue;
      }
      house.hasFacade[at(side)] = true;
      const float setback = random_.inRange(0, block.isOnAlley[at(side)] ? kMaxAlleySetback : kMaxSetback);
      switch (side) {
        case CitySide::kWest:
          house.area.lower.x += setback;
          break;
        case CitySide::kEast:
          house.area.upper.x -= setback;
          break;
        case CitySide::kNorth:
          house.area.lower.y += setback;
          break;
        case CitySide::kSouth:
          house.area.upper.y -= setback;
          break;
      }
      if (width > widest) {
        widest = width;
        house.door = side;
      }
    }
    house.storeys = 2 + static_cast<int>(random_.below(widest > 8.5f ? 4 : 3));
    const glm::vec2 size = house.area.size();
    const size_t roof = random_.below(3);
    house.roof = roof == 0 || std::max(size.x, size.y) > 14 ? CityRoof::kFlat
                 : roof == 1                                ? CityRoof::kAlongX
                                                            : CityRoof::kAlongZ;
    house.wallColor = anyOfColors(cityWallColors(), random_);
    house.roofColor = anyOfColors(cityRoofColors(), random_);
    house.doorColor = anyOfColors(cityBrightColors(), random_);
    plan_.houses.push_back(house);
  }

  void addTree(const glm::vec3& position, float scale) {
    const bool isPointed = random_.below(3) == 0;
    const float age = random_.inRange(0, 1);
    const glm::vec3 color =
        palette::fromSrgbBytes(static_cast<int>(70 + 60 * age), static_cast<int>(150 + 30 * age), 70);
    plan_.things.push_back({isPointed ? CityThingKind::kPointedTree : CityThingKind::kRoundTree, position,
                            random_.inRange(0, 360), scale, color});
  }

  /// A fountain off the middle, which stays free, trees along the edges, benches that look to the middle.
  void furnishSquare(const CityBlock& block) {
    const glm::vec2 center = block.area.center();
    const glm::vec2 half = block.area.size() * 0.5f;
    plan_.fountains.push_back(plan_.things.size());
    const float away = std::min(half.y - 3.5f, 6.0f);
    plan_.things.push_back({CityThingKind::kFountain, {center.x, kCityKerb, center.y - away}});
    for (const float sideX : {-1.0f, 1.0f}) {
      for (const float sideZ : {-1.0f, 1.0f}) {
        addTree({center.x + sideX * (half.x - 1.5f), kCityKerb, center.y + sideZ * (half.y - 1.5f)},
                random_.inRange(0.7f, 0.95f));
      }
      plan_.things.push_back(
          {CityThingKind::kBench, {center.x + sideX * (half.x - 1), kCityKerb, center.y}, sideX < 0 ? 90.0f : 270.0f});
    }
  }

  /// Lamps, trees, benches and bins at the kerbs of both sides in turns, and parked cars where the roadway is wide.
  void furnishStreet(const CityStreet& street) {
    const float width = street.width();
    const float pavement = cityPavementWidth(width, street.isAlley);
    const CityRectangle& area = street.area;
    const float along0 = street.isAlongX ? area.lower.x : area.lower.y;
    const float along1 = street.isAlongX ? area.upper.x : area.upper.y;
    const float middle = street.isAlongX ? area.center().y : area.center().x;
    const auto place = [&](float along, float across, float y) {
      return street.isAlongX ? glm::vec3(along, y, middle + across) : glm::vec3(middle + across, y, along);
    };
    // Of a thing that looks along +z when it is not turned, so that it looks to the middle of the street.
    const auto inwards = [&](float side) {
      return street.isAlongX ? (side < 0 ? 0.0f : 180.0f) : (side < 0 ? 90.0f : 270.0f);
    };
    const float kerb = width / 2 - pavement + 0.35f;
    size_t next = random_.below(4);
    for (const float side : {-1.0f, 1.0f}) {
      float along = along0 + random_.inRange(2, 6);
      while (pavement > 0 && along < along1 - 2) {
        const glm::vec3 where = place(along, side * kerb, kCityKerb);
        if (isBesideBlocks(street, along, side)) {
          if (next % 4 == 0) {
            plan_.things.push_back({CityThingKind::kLamp, where, inwards(side)});
          } else if (next % 4 == 1 && width >= 9) {
            addTree(where, random_.inRange(0.45f, 0.6f));
          } else if (next % 4 == 2 && pavement >= 1.8f) {
            plan_.things.push_back({CityThingKind::kBench, where, inwards(side)});
          } else if (next % 4 == 3) {
            plan_.things.push_back({CityThingKind::kBin, where, 0, 1, anyOfColors(cityBrightColors(), random_)});
          }
          ++next;
        }
        along += random_.inRange(4, 8);
      }
      along = along0 + random_.inRange(5, 14);
      while (width >= 8.5f && along < along1 - 5) {
        if (isBesideBlocks(street, along - 3, side) && isBesideBlocks(street, along + 3, side)) {
          const float lane = width / 2 - pavement - 1.1f;
          plan_.things.push_back({CityThingKind::kCar, place(along, side * lane, 0),
                                  (street.isAlongX ? 0.0f : 90.0f) + (random_.below(2) == 0 ? 0.0f : 180.0f), 1,
                                  anyOfColors(cityBrightColors(), random_)});
        }
        along += random_.inRange(7, 22);
      }
    }
  }

  /// Whether the pavement of one side of a street is there, a metre to either side of a place: no other street ends.
  bool isBesideBlocks(const CityStreet& street, float along, float side) const {
    const float middle = street.isAlongX ? street.area.center().y : street.area.center().x;
    const float across = middle + side * (street.width() / 2 + 0.1f);
    const CityRectangle probe = turnedRow(street.isAlongX, along - 1, along + 1, across - 0.05f, across + 0.05f);
    return std::none_of(plan_.streets.begin(), plan_.streets.end(),
                        [&](const CityStreet& other) { return other.area.meets(probe); });
  }

  Random random_;
  CityPlan plan_;
};

}  // namespace

CityRectangle CityBlock::withStreets() const {
  CityRectangle all = area;
  all.lower.x -= streetWidth[at(CitySide::kWest)];
  all.upper.x += streetWidth[at(CitySide::kEast)];
  all.lower.y -= streetWidth[at(CitySide::kNorth)];
  all.upper.y += streetWidth[at(CitySide::kSouth)];
  return all;
}

float cityPavementWidth(float streetWidth, bool isAlley) {
  if (isAlley) {
    return 0;
  }
  return streetWidth >= 8.5f ? 2.0f : streetWidth >= 6.5f ? 1.4f : 1.0f;
}

CityPlan planCity(const CityOptions& options) {
  OC_CHECK(options.size >= kMinCitySize && options.size <= kMaxCitySize, "sizes of cities are checked by their reader");
  return CityPlanner(options).plan();
}

}  // namespace ocelli
