// `builtin:library`: rows of shelves with some thousands of books, and tables: a place for a sea of images (section
// 3.5.4; its Table 3.3 has a library of 1,947 images 1.6 inches apart).
#include "oc_core/base/random.h"
#include "oc_core/worlds/builtin_list.h"
#include "oc_core/worlds/palette.h"
#include "oc_core/worlds/place_furniture.h"
#include "oc_core/worlds/place_parameters.h"
#include "oc_core/worlds/place_room.h"
#include "oc_core/worlds/place_walk.h"
#include "oc_core/worlds/placement.h"
#include "oc_core/worlds/printed_textures.h"

namespace ocelli {
namespace {

constexpr float kCaseStep = 1.003f;  // from one case to the next: a gap of 3 mm

PlaceRoom readingRoom(uint32_t seed) {
  PlaceRoom room;
  room.lower = {-4.5f, -3.5f};
  room.upper = {4.5f, 3.5f};
  room.height = 3.1f;
  room.sides[0].texture = plasterTexture(palette::fromSrgbBytes(200, 192, 166), seed + 1);
  room.sides[1].texture = plasterTexture(palette::fromSrgbBytes(196, 186, 158), seed + 2);
  room.sides[2].texture = plasterTexture(palette::fromSrgbBytes(92, 112, 92), seed + 3);
  room.sides[3].texture = brickTexture(palette::fromSrgbBytes(166, 100, 74), seed + 4);
  room.floor = carpetTexture(palette::fromSrgbBytes(116, 78, 66), seed + 5);
  room.ceiling = plasterTexture(palette::fromSrgbBytes(226, 220, 204), seed + 6);
  return room;
}

/// Cases side by side along x, their middle at `place`.
void addCases(PlaceBuilder& place, int count, const glm::vec2& middle, double turn, const Bookcase& shelf,
              uint32_t& seed) {
  const glm::mat4 row = placedAt({middle.x, 0, middle.y}, turn);
  for (int k = 0; k < count; ++k) {
    Bookcase one = shelf;
    one.seed = ++seed * 977;
    place.beginObject();
    addBookcase(place, one,
                row * placedAt({kCaseStep * (static_cast<float>(k) - 0.5f * static_cast<float>(count - 1)), 0, 0}));
  }
  place.beginStructure();
}

void addShelves(PlaceBuilder& place, uint32_t seed) {
  Bookcase tall;
  tall.size = {1, 2.25f, 0.3f};
  tall.shelves = 6;
  tall.wood = palette::fromSrgbBytes(132, 88, 52);
  addCases(place, 8, {0, -3.335f}, 0, tall, seed);
  tall.wood = palette::fromSrgbBytes(126, 84, 50);
  addCases(place, 4, {-2.2f, 3.335f}, 180, tall, seed);
  Bookcase low = tall;
  low.size = {1, 1.85f, 0.29f};
  low.shelves = 5;
  for (const float z : {-1.25f, 1.25f}) {
    const float x = -1.1f;
    addCases(place, 4, {x, z + 0.147f}, 0, low, seed);
    addCases(place, 4, {x, z - 0.147f}, 180, low, seed);
    // Ends of a row, with a sign.
    for (const float side : {-1.0f, 1.0f}) {
      const glm::mat4 end = placedAt({x + side * (2 * kCaseStep + 0.012f), 0, z}, 90 * side);
      place.addBox({0.64f, 1.9f, 0.026f}, end * placedAt({0, 0.946f, 0}),
                   BoxLook(uprightWoodTexture(low.wood * 1.1f, ++seed)).plain(BoxFace::kBottom));
      const glm::vec2 sign(0.36f, 0.26f);
      addSheet(place, sign, posterTexture(sign, ++seed), end * placedAt({0, 1.5f, 0.013f}), 0.6f);
    }
    Random random(seed);
    for (int k = 0; k < 7; ++k) {  // what lies on top
      addBookPile(place, 1 + random.below(4),
                  placedAt({x + random.inRange(-1.8f, 1.8f), 1.85f, z + (k % 2 == 0 ? 0.15f : -0.15f)},
                           random.inRange(-20, 20) + (k % 2 == 0 ? 0 : 180)),
                  ++seed);
    }
  }
}

void addReading(PlaceBuilder& place, uint32_t seed) {
  const glm::vec2 rug(2.1f, 4.6f);
  place.addBox({rug.x, 0.02f, rug.y}, placedAt({3.05f, 0.003f, 0.35f}),
               BoxLook(rugTexture(rug, palette::fromSrgbBytes(128, 40, 40), palette::fromSrgbBytes(40, 52, 88), seed))
                   .plain(BoxFace::kBottom)
                   .noShadow());
  Random random(seed);
  for (const float z : {-0.75f, 1.45f}) {
    const glm::mat4 table = placedAt({3.05f, 0.012f, z}, random.inRange(-2, 2));
    place.beginObject();
    addTable(place, {1.0f, 0.75f, 1.7f}, palette::fromSrgbBytes(126, 78, 44), table, ++seed);
    for (const float along : {-0.42f, 0.42f}) {
      addDeskLamp(place, palette::fromSrgbBytes(62, 128, 84), table * placedAt({0, 0.75f, along}), ++seed);
      for (const float side : {-1.0f, 1.0f}) {
        addBookPile(place, 1 + random.below(5),
                    table * placedAt({side * 0.28f, 0.75f, along + random.inRange(-0.2f, 0.2f)},
                                     90 * side + random.inRange(-30, 30)),
                    ++seed);
        const glm::vec2 sheet(0.21f, 0.297f);
        place.addBox({sheet.x, 0.008f, sheet.y},
                     table * placedAt({side * 0.3f, 0.7515f, along - side * 0.28f}, random.inRange(-40, 40)),
                     BoxLook(paperTexture(sheet, ++seed)).plain(BoxFace::kBottom).finer(0.6f).noShadow());
      }
    }
    for (const float side : {-1.0f, 1.0f}) {
      for (const float along : {-0.45f, 0.42f}) {
        place.beginObject();
        addChair(place, palette::fromSrgbBytes(110, 70, 42),
                 table * placedAt({side * random.inRange(0.66f, 0.8f), 0, along}, -90 * side + random.inRange(-15, 15)),
                 ++seed);
      }
    }
  }
  place.beginObject();
  addPottedPlant(place, 1.6f, placedAt({4.05f, 0, -2.7f}), ++seed);
  place.beginObject();
  addPottedPlant(place, 1.3f, placedAt({4.05f, 0, 3.05f}), ++seed);
  place.beginObject();
  const SurfaceTexture stone = marbleTexture(palette::fromSrgbBytes(150, 146, 138), ++seed);
  addVase(place, 1.05f, stone, ++seed, placedAt({-4.15f, 0, 0}));
  place.beginObject();
  addBench(place, 1.3f, placedAt({-4.2f, 0, -1.4f}, 90), ++seed);
  place.beginStructure();
}

void addReadingWalls(PlaceBuilder& place, const PlaceRoom& room, uint32_t seed) {
  const auto picture = [&](RoomSide side, float along, float up, const glm::vec2& size) {
    ++seed;
    place.beginObject();
    addFramedPicture(
        place, {size, 0.06f, paintingTexture(size, seed * 91), woodTexture(palette::fromSrgbBytes(110, 72, 42), seed)},
        worldFromSide(room, side) * placedAt({along, up, 0}));
  };
  picture(RoomSide::kEast, 1.5f, 1.75f, {0.9f, 0.7f});
  picture(RoomSide::kEast, 3.3f, 1.8f, {1.3f, 0.9f});
  picture(RoomSide::kEast, 5.3f, 1.75f, {0.8f, 1.0f});
  picture(RoomSide::kWest, 2.0f, 1.7f, {0.8f, 0.6f});
  picture(RoomSide::kWest, 4.6f, 1.75f, {0.9f, 1.1f});
  picture(RoomSide::kSouth, 1.0f, 1.7f, {0.7f, 0.9f});
  place.beginStructure();
  for (int k = 0; k < 5; ++k) {
    const glm::vec2 size(0.42f, 0.6f);
    addSheet(place, size, posterTexture(size, seed * 13 + static_cast<uint32_t>(k)),
             worldFromSide(room, RoomSide::kNorth) * placedAt({1.1f + 1.7f * static_cast<float>(k), 2.66f, 0}), 0.8f);
  }
  addClosedDoor(place, worldFromSide(room, RoomSide::kSouth), 2.3f, palette::fromSrgbBytes(120, 78, 46), seed + 30);
  const SurfaceTexture boards = woodTexture(palette::fromSrgbBytes(112, 74, 46), seed + 31);
  addSkirting(place, room, RoomSide::kNorth, {}, boards);
  addSkirting(place, room, RoomSide::kSouth, {{1.77f, 2.83f}}, boards);
  addSkirting(place, room, RoomSide::kWest, {}, boards);
  addSkirting(place, room, RoomSide::kEast, {}, boards);
  for (int k = 0; k < 4; ++k) {  // beams
    place.addBox({0.16f, 0.22f, 7.1f}, placedAt({-3.4f + 2.27f * static_cast<float>(k), 3.02f, 0}),
                 BoxLook(uprightWoodTexture(palette::fromSrgbBytes(104, 70, 44), seed + 40 + static_cast<uint32_t>(k)))
                     .with(BoxFace::kLeft, woodTexture(palette::fromSrgbBytes(104, 70, 44), seed + 50))
                     .with(BoxFace::kRight, woodTexture(palette::fromSrgbBytes(104, 70, 44), seed + 51))
                     .plain(BoxFace::kTop)
                     .finer(1.6f));
  }
}

Scene buildLibrary(const BuiltinValues& values) {
  PlaceBuilder place(static_cast<float>(values.number("texel")));
  const auto seed = static_cast<uint32_t>(values.count("seed")) * 1000003u + 31;
  const PlaceRoom room = readingRoom(seed);
  addRoom(place, room);
  place.light().setAmbient({0.58f, 0.56f, 0.52f});
  addCeilingLamps(
      place, room.height,
      {{-2.25f, -2.3f}, {0, -2.3f}, {-2.25f, 0}, {0, 0}, {-2.25f, 2.3f}, {0, 2.3f}, {2.5f, -0.75f}, {2.5f, 1.45f}},
      {1.2f, 0.32f}, glm::vec3(1, 0.93f, 0.8f) * 4.0f);
  addShelves(place, seed + 100);
  addReading(place, seed + 5000);
  addReadingWalls(place, room, seed + 6000);
  Scene scene = place.build();
  const SeaWalk sea{1947, 1.6f * kInch};
  scene.guides.sea = sea;
  scene.guides.path = laneWalk({{{-2.6f, -0.5f}, {0.9f, 0.5f}, true}}, sea, kPlaceEyeHeight);
  return scene;
}

}  // namespace

BuiltinScene libraryScene() {
  return {"library", "rows of shelves with thousands of books, and reading tables, for seas of images; in metres",
          placeParameters(), buildLibrary};
}

}  // namespace ocelli
