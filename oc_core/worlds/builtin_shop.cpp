// `builtin:shop`: a shop with shelves along its aisles: a place for a graph camera from video (section 4.3.3).
//
// The main aisle runs along z, |x| < 1.6, from the entrance at z = 8.6 to the cross aisle at z in [-3.2, -1]; side
// aisles at z in [2.4, 4.6] go off to both sides. Boards with the names of aisles hang over the openings.
#include "oc_core/worlds/builtin_list.h"
#include "oc_core/worlds/corridor_parts.h"
#include "oc_core/worlds/palette.h"
#include "oc_core/worlds/place_furniture.h"
#include "oc_core/worlds/place_parameters.h"
#include "oc_core/worlds/place_room.h"
#include "oc_core/worlds/placement.h"
#include "oc_core/worlds/printed_textures.h"
#include "oc_core/worlds/shop_shelf.h"

namespace ocelli {
namespace {

constexpr float kShopMainHalf = 1.6f;
constexpr float kShopSide = 7.6f;       ///< |x| of the walls
constexpr float kShopEntrance = 8.6f;   ///< z
constexpr float kShopBack = -3.2f;      ///< z of the fronts of the shelves at the back
constexpr float kShopCrossFront = -1;   ///< z of the shelves across from these
constexpr float kShopAisleFrom = 2.4f;  ///< z of the side aisles
constexpr float kShopAisleTo = 4.6f;
constexpr float kShopHeight = 3.2f;
constexpr float kShopBoardBottom = 2.4f;  ///< of boards over openings

PlaceRoom shopRoom(uint32_t seed) {
  PlaceRoom room;
  room.lower = {-kShopSide, kShopBack - kShopShelfDepth - 0.02f};
  room.upper = {kShopSide, kShopEntrance};
  room.height = kShopHeight;
  for (RoomSideLook& side : room.sides) {
    side.texture = plasterTexture(palette::fromSrgbBytes(206, 204, 192), ++seed);
  }
  room.floor = marbleTilesTexture(palette::fromSrgbBytes(176, 172, 160), 0.5f, seed + 5);
  room.ceiling = ceilingTexture(palette::fromSrgbBytes(224, 224, 220), seed + 6);
  return room;
}

/// A block of shelves: those along the main aisle, and those along the aisles before and behind it. It stands at the
/// right of the main aisle; `side` -1 mirrors it to the left.
void addBlock(PlaceBuilder& place, float side, float from, float to, bool hasAisleBehind, bool hasAisleBefore,
              uint32_t seed) {
  const float depth = kShopShelfDepth;
  const float middle = (from + to) / 2;
  const float inner = kShopMainHalf + depth;
  place.addBox({kShopSide - inner + 0.01f, kShopShelfHeight - 0.03f, to - from - 2 * depth - 0.01f},
               placedAt({side * (inner + kShopSide) / 2, kShopShelfHeight / 2 - 0.02f, middle}),
               BoxLook(plasticTexture(palette::fromSrgbBytes(168, 160, 146), seed)).plain(BoxFace::kBottom));
  const float length = to - from;
  const float across = kShopSide - kShopMainHalf;
  const float corner = 0.012f;  // so that no two shelves share a plane
  addShopShelf(
      place, length - 2 * corner,
      side > 0 ? placedAt({kShopMainHalf, 0, from + corner}, -90) : placedAt({-kShopMainHalf, 0, to - corner}, 90),
      seed + 10);
  if (hasAisleBefore) {
    addShopShelf(place, across - depth - corner, placedAt({side > 0 ? inner + corner : -kShopSide, 0, to}), seed + 20);
  }
  if (hasAisleBehind) {
    addShopShelf(place, across - depth - corner, placedAt({side > 0 ? kShopSide : -inner - corner, 0, from}, 180),
                 seed + 30);
  }
}

/// A board with the name of an aisle; its middle at a place, facing along the turn.
void addAisleBoard(PlaceBuilder& place, float length, const glm::vec3& middle, double turn, const glm::vec3& color,
                   uint32_t seed) {
  const glm::mat4 board = placedAt(middle, turn);
  place.beginObject();
  place.addBox({length, 0.5f, 0.05f}, board, BoxLook(plasticTexture(color, seed)));
  for (const double around : {0.0, 180.0}) {
    const glm::vec2 sheet(0.9f, 0.4f);
    addSheet(place, sheet, posterTexture(sheet, seed + 3),
             board * placedAt({0, 0, 0}, around) * placedAt({0, 0, 0.025f}), 0.6f);
  }
  place.beginStructure();
}

void addAisleEnds(PlaceBuilder& place, const PlaceRoom& room, uint32_t seed) {
  const glm::mat4 west = worldFromSide(room, RoomSide::kWest);
  const glm::mat4 east = worldFromSide(room, RoomSide::kEast);
  const float aisle = (kShopAisleFrom + kShopAisleTo) / 2;
  addClosedDoor(place, west, kShopEntrance - aisle, palette::fromSrgbBytes(66, 92, 128), seed);
  addClosedDoor(place, east, aisle - room.lower.y, palette::fromSrgbBytes(150, 104, 64), seed + 1);
  hangOn(place, east, {{(kShopBack + kShopCrossFront) / 2 - room.lower.y, {1.2f, 0.9f}, true}}, seed + 2);
  hangOn(place, west, {{kShopEntrance - (kShopBack + kShopCrossFront) / 2, {1.2f, 0.9f}, true}}, seed + 3);
  addClosedDoor(place, worldFromSide(room, RoomSide::kSouth), kShopSide, palette::fromSrgbBytes(90, 120, 96), seed + 4);
}

Scene buildShop(const BuiltinValues& values) {
  PlaceBuilder place(static_cast<float>(values.number("texel")));
  const auto seed = static_cast<uint32_t>(values.count("seed")) * 1000003u + 43;
  const PlaceRoom room = shopRoom(seed);
  addRoom(place, room);
  place.light().setAmbient({0.52f, 0.52f, 0.52f});
  addCeilingLamps(
      place, kShopHeight,
      {{-4.6f, -2.1f}, {0, -2.1f}, {4.6f, -2.1f}, {-4.6f, 3.5f}, {0, 3.5f}, {4.6f, 3.5f}, {0, 0.8f}, {0, 8}},
      {1.8f, 0.4f}, glm::vec3(1, 0.98f, 0.94f) * 4.2f);
  for (const float side : {-1.0f, 1.0f}) {
    const uint32_t of = seed + (side > 0 ? 100 : 200);
    addBlock(place, side, kShopAisleTo, kShopEntrance - 0.3f, true, false, of);
    addBlock(place, side, kShopCrossFront, kShopAisleFrom, true, true, of + 50);
    addAisleBoard(place, kShopAisleTo - kShopAisleFrom - 0.02f,
                  {side * (kShopMainHalf + 0.03f), kShopBoardBottom + 0.25f, (kShopAisleFrom + kShopAisleTo) / 2}, 90,
                  side > 0 ? palette::fromSrgbBytes(176, 84, 60) : palette::fromSrgbBytes(52, 96, 150), of + 90);
  }
  addAisleBoard(place, 2 * kShopMainHalf - 0.02f, {0, kShopBoardBottom + 0.25f, kShopCrossFront - 0.03f}, 0,
                palette::fromSrgbBytes(60, 128, 98), seed + 300);
  addShopShelf(place, 2 * kShopSide - 0.02f, placedAt({-kShopSide + 0.01f, 0, kShopBack}), seed + 310);
  addAisleEnds(place, room, seed + 320);
  Scene scene = place.build();
  scene.guides.path = {{0, kPlaceEyeHeight, 7.5f}, {0, kPlaceEyeHeight, 3.5f},  {6.5f, kPlaceEyeHeight, 3.5f},
                       {0, kPlaceEyeHeight, 3.5f}, {0, kPlaceEyeHeight, -2.1f}, {6.5f, kPlaceEyeHeight, -2.1f}};
  return scene;
}

}  // namespace

BuiltinScene shopScene() {
  std::vector<BuiltinParameter> parameters = placeParameters();
  parameters.front().otherwise = "0.03";
  return {"shop", "shelves along aisles of a shop, for graph cameras from video; in metres", parameters, buildShop};
}

}  // namespace ocelli
