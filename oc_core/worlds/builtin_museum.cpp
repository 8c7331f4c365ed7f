// `builtin:museum`: two rooms with paintings and statues around a kiosk, 84 square metres: a place for a sea of images
// (section 3.5.4; its Table 3.3 has a museum of 900 square feet, 9,832 images 2.2 inches apart).
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

constexpr float kMuseumHeight = 3.6f;
constexpr glm::vec2 kKiosk{-2, 0};
constexpr float kMuseumDoorHalf = 0.9f;
constexpr float kMuseumDoorTop = 2.5f;

PlaceRoom museumHall(uint32_t seed) {
  PlaceRoom hall;
  hall.lower = {-6, -3.5f};
  hall.upper = {2, 3.5f};
  hall.height = kMuseumHeight;
  const SurfaceTexture wall = plasterTexture(palette::fromSrgbBytes(206, 200, 186), seed + 1);
  hall.sides[0].texture = wall;
  hall.sides[1].texture = plasterTexture(palette::fromSrgbBytes(198, 196, 188), seed + 2);
  hall.sides[2].texture = brickTexture(palette::fromSrgbBytes(170, 96, 70), seed + 3);
  hall.floor = parquetTexture(palette::fromSrgbBytes(176, 124, 76), seed + 4);
  hall.ceiling = plasterTexture(palette::fromSrgbBytes(232, 230, 222), seed + 5);
  return hall;
}

PlaceRoom museumCabinet(uint32_t seed) {
  PlaceRoom cabinet;
  cabinet.lower = {2.24f, -3.5f};
  cabinet.upper = {6.2f, 3.5f};
  cabinet.height = kMuseumHeight + 0.02f;
  const glm::vec3 red = palette::fromSrgbBytes(138, 58, 50);
  cabinet.sides[0].texture = plasterTexture(red, seed + 11);
  cabinet.sides[1].texture = plasterTexture(red * 0.95f, seed + 12);
  cabinet.sides[3].texture = plasterTexture(palette::fromSrgbBytes(60, 84, 78), seed + 13);
  cabinet.floor = marbleTilesTexture(palette::fromSrgbBytes(216, 210, 198), 0.6f, seed + 14);
  cabinet.ceiling = plasterTexture(palette::fromSrgbBytes(228, 222, 210), seed + 15);
  return cabinet;
}

/// The wall between the rooms, with the doorway, its lining and a threshold.
void addDoorway(PlaceBuilder& place, uint32_t seed) {
  PlaceWall wall;
  wall.size = {7.2f, kMuseumHeight + 0.1f};
  wall.thickness = 0.24f;
  wall.front = plasterTexture(palette::fromSrgbBytes(204, 198, 184), seed);
  wall.back = plasterTexture(palette::fromSrgbBytes(138, 58, 50), seed + 1);
  wall.rim = wall.front;
  wall.fineness = 1.45f;
  wall.openings = {
      {glm::vec2(3.6f - kMuseumDoorHalf, 0.03f), glm::vec2(3.6f + kMuseumDoorHalf, kMuseumDoorTop + 0.05f)}};
  place.addWall(wall, placedAt({2, -0.05f, -3.6f}, -90));
  const SurfaceTexture oak = uprightWoodTexture(palette::fromSrgbBytes(120, 78, 46), seed + 2);
  const SurfaceTexture across = woodTexture(palette::fromSrgbBytes(120, 78, 46), seed + 3);
  for (const float side : {-1.0f, 1.0f}) {
    place.addBox({0.32f, kMuseumDoorTop + 0.12f, 0.12f},
                 placedAt({2.12f, kMuseumDoorTop / 2 + 0.05f, side * (kMuseumDoorHalf + 0.04f)}),
                 BoxLook(oak).plain(BoxFace::kBottom));
  }
  place.addBox({0.3f, 0.12f, 2 * kMuseumDoorHalf + 0.16f}, placedAt({2.12f, kMuseumDoorTop + 0.04f, 0}),
               BoxLook(across));
  place.addBox(
      {0.28f, 0.02f, 2 * kMuseumDoorHalf}, placedAt({2.12f, -0.002f, 0}),
      BoxLook(metalTexture(palette::fromSrgbBytes(190, 156, 92), seed + 4)).plain(BoxFace::kBottom).noShadow());
}

struct Hanging {
  RoomSide side;
  float along;  ///< from the left corner of the side to the middle of the picture
  glm::vec2 size;
};

void hang(PlaceBuilder& place, const PlaceRoom& room, const std::vector<Hanging>& hangings, uint32_t seed) {
  for (const Hanging& hanging : hangings) {
    ++seed;
    place.beginObject();
    const glm::vec3 gold = seed % 3 == 0 ? palette::fromSrgbBytes(92, 58, 36) : palette::fromSrgbBytes(196, 152, 78);
    const glm::mat4 side = worldFromSide(room, hanging.side);
    addFramedPicture(
        place,
        {hanging.size, 0.06f + 0.02f * static_cast<float>(seed % 3), paintingTexture(hanging.size, seed * 77),
         seed % 3 == 0 ? woodTexture(gold, seed) : metalTexture(gold, seed)},
        side * placedAt({hanging.along, 1.62f, 0}));
    const glm::vec2 label(0.16f, 0.11f);
    addSheet(place, label, paperTexture(label, seed + 500),
             side * placedAt({hanging.along + hanging.size.x / 2 + 0.22f, 1.25f, 0}), 0.6f);
  }
  place.beginStructure();
}

void addKiosk(PlaceBuilder& place, uint32_t seed) {
  place.beginObject();
  const glm::mat4 m = placedAt({kKiosk.x, 0, kKiosk.y});
  const glm::vec3 oak = palette::fromSrgbBytes(140, 96, 58);
  place.addBox({1.34f, 1.02f, 1.34f}, m * placedAt({0, 0.505f, 0}),
               BoxLook(uprightWoodTexture(oak, seed)).plain(BoxFace::kBottom).plain(BoxFace::kTop));
  place.addBox({1.38f, 0.1f, 1.38f}, m * placedAt({0, 0.045f, 0}),
               BoxLook(metalTexture(glm::vec3(0.16f), seed + 1)).plain(BoxFace::kBottom).noShadow());
  place.addBox({1.5f, 0.05f, 1.5f}, m * placedAt({0, 1.035f, 0}),
               BoxLook(marbleTexture(palette::fromSrgbBytes(206, 202, 192), seed + 2)).plain(BoxFace::kBottom));
  place.addBox({0.56f, 1.4f, 0.56f}, m * placedAt({0, 1.75f, 0}),
               BoxLook(plasterTexture(palette::fromSrgbBytes(58, 74, 92), seed + 3)).plain(BoxFace::kBottom));
  place.addBox({0.7f, 0.12f, 0.7f}, m * placedAt({0, 2.47f, 0}), BoxLook(woodTexture(oak * 0.7f, seed + 4)).noShadow());
  for (int side = 0; side < 4; ++side) {
    const glm::mat4 face = m * placedAt({0, 0, 0}, 90.0 * side) * placedAt({0, 0, 0.28f});
    const glm::vec2 poster(0.42f, 0.72f);
    addSheet(place, poster, posterTexture(poster, seed + 20 + static_cast<uint32_t>(side)),
             face * placedAt({0, 1.95f, 0}), 0.62f);
    const glm::vec2 front(1.0f, 0.62f);
    addSheet(place, front, posterTexture(front, seed + 30 + static_cast<uint32_t>(side)),
             m * placedAt({0, 0, 0}, 90.0 * side) * placedAt({0, 0.58f, 0.67f}), 0.8f);
  }
  Random random(seed);
  for (int k = 0; k < 8; ++k) {  // what lies on it
    const double turn = 45.0 * k + static_cast<double>(random.inRange(-8, 8));
    const glm::mat4 spot = m * placedAt({0, 1.06f, 0}, turn) * placedAt({0, 0, k % 2 == 0 ? 0.53f : 0.66f});
    addBookPile(place, 1 + random.below(5), spot * placedAt({0, 0, 0}, random.inRange(-40, 40)),
                seed + 60 + static_cast<uint32_t>(k));
  }
}

void addExhibits(PlaceBuilder& place, uint32_t seed) {
  const SurfaceTexture stone = marbleTexture(palette::fromSrgbBytes(150, 146, 138), seed);
  const SurfaceTexture white = marbleTexture(palette::fromSrgbBytes(226, 220, 208), seed + 1);
  const SurfaceTexture bronze = metalTexture(palette::fromSrgbBytes(112, 92, 62), seed + 2);
  const auto statue = [&](const glm::vec2& p, double turn, const SurfaceTexture& figure, float plinth) {
    place.beginObject();
    addStatue(place, plinth, stone, figure, ++seed, placedAt({p.x, 0, p.y}, turn));
  };
  statue({-5.5f, -3.08f}, 35, white, 0.62f);
  statue({-5.5f, 3.08f}, 145, bronze, 0.7f);
  statue({1.55f, -3.1f}, -35, bronze, 0.66f);
  statue({5.65f, 0}, -90, white, 0.75f);
  statue({5.6f, -3.05f}, -45, bronze, 0.6f);
  const auto vase = [&](const glm::vec2& p, float plinth) {
    place.beginObject();
    addVase(place, plinth, stone, ++seed, placedAt({p.x, 0, p.y}));
  };
  vase({-5.6f, 1.2f}, 1.02f);
  vase({-5.6f, -1.2f}, 1.1f);
  vase({1.62f, 3.1f}, 1.0f);
  vase({5.7f, 2.0f}, 1.05f);
  vase({5.7f, -1.6f}, 0.95f);
  vase({2.66f, 3.1f}, 1.08f);
  const auto bench = [&](const glm::vec2& p, double turn, float length) {
    place.beginObject();
    addBench(place, length, placedAt({p.x, 0, p.y}, turn), ++seed);
  };
  bench({-0.95f, 3.14f}, 0, 1.6f);
  bench({-5.5f, 0}, 90, 1.4f);
  bench({1.76f, 2.05f}, 90, 1.2f);
  bench({4, -3.12f}, 0, 1.3f);
  place.beginObject();
  addPottedPlant(place, 1.5f, placedAt({5.6f, 0, 3.05f}), ++seed);
  place.beginObject();
  addPottedPlant(place, 1.1f, placedAt({-5.55f, 0, 2.2f}), ++seed);
  // A rope before the north wall's pictures.
  std::vector<glm::vec3> rope;
  place.beginObject();
  for (int k = 0; k < 5; ++k) {
    const glm::vec3 foot(-4.4f + 1.15f * static_cast<float>(k), 0, -3.02f);
    addBarrierPost(place, placedAt(foot), ++seed);
    for (int s = 0; k > 0 && s <= 12; ++s) {
      const float t = static_cast<float>(s) / 12;
      rope.push_back(foot + glm::vec3(1.15f * (t - 1), 0.86f - 0.9f * t * (1 - t), 0));
    }
    if (k > 0) {
      place.addTube(rope, 0.017f, clothTexture(palette::fromSrgbBytes(132, 30, 36), ++seed));
      rope.clear();
    }
  }
  place.beginStructure();
}

Scene buildMuseum(const BuiltinValues& values) {
  PlaceBuilder place(static_cast<float>(values.number("texel")));
  const auto seed = static_cast<uint32_t>(values.count("seed")) * 1000003u;
  const PlaceRoom hall = museumHall(seed);
  const PlaceRoom cabinet = museumCabinet(seed);
  addRoom(place, hall);
  addRoom(place, cabinet);
  addDoorway(place, seed + 30);
  place.light().setAmbient({0.55f, 0.55f, 0.57f});
  const glm::vec3 warm = glm::vec3(1.0f, 0.94f, 0.84f) * 4.4f;
  addCeilingLamps(place, hall.height,
                  {{-4.7f, -1.7f}, {-2, -1.9f}, {0.6f, -1.7f}, {-4.7f, 1.7f}, {-2, 1.9f}, {0.6f, 1.7f}}, {1.3f, 0.5f},
                  warm);
  addCeilingLamps(place, cabinet.height, {{4.1f, -1.9f}, {4.1f, 0}, {4.1f, 1.9f}}, {1.3f, 0.5f}, warm);
  const SurfaceTexture board = woodTexture(palette::fromSrgbBytes(104, 70, 44), seed + 40);
  addSkirting(place, hall, RoomSide::kNorth, {}, board);
  addSkirting(place, hall, RoomSide::kSouth, {{4.2f, 5.3f}}, board);
  addSkirting(place, hall, RoomSide::kWest, {}, board);
  addSkirting(place, hall, RoomSide::kEast, {{3.5f - kMuseumDoorHalf - 0.05f, 3.5f + kMuseumDoorHalf + 0.05f}}, board);
  addSkirting(place, cabinet, RoomSide::kNorth, {}, board);
  addSkirting(place, cabinet, RoomSide::kSouth, {}, board);
  addSkirting(place, cabinet, RoomSide::kEast, {}, board);
  addClosedDoor(place, worldFromSide(hall, RoomSide::kSouth), 4.75f, palette::fromSrgbBytes(96, 66, 44), seed + 41);
  hang(place, hall,
       {{RoomSide::kNorth, 1.75f, {0.8f, 1.05f}},
        {RoomSide::kNorth, 3.35f, {1.3f, 0.95f}},
        {RoomSide::kNorth, 4.95f, {0.7f, 0.9f}},
        {RoomSide::kNorth, 6.45f, {1.1f, 0.8f}},
        {RoomSide::kSouth, 1.05f, {0.9f, 0.7f}},
        {RoomSide::kSouth, 2.95f, {1.7f, 1.15f}},
        {RoomSide::kSouth, 6.3f, {0.75f, 0.95f}},
        {RoomSide::kWest, 1.55f, {0.8f, 0.6f}},
        {RoomSide::kWest, 3.5f, {1.5f, 1.1f}},
        {RoomSide::kWest, 5.45f, {0.7f, 0.9f}},
        {RoomSide::kEast, 1.6f, {0.9f, 0.9f}},
        {RoomSide::kEast, 5.55f, {1.0f, 1.2f}}},
       seed + 50);
  hang(place, cabinet,
       {{RoomSide::kNorth, 0.9f, {0.7f, 0.9f}},
        {RoomSide::kNorth, 2.2f, {1.0f, 0.75f}},
        {RoomSide::kSouth, 1.2f, {0.8f, 1.0f}},
        {RoomSide::kSouth, 2.75f, {0.9f, 0.7f}},
        {RoomSide::kEast, 1.15f, {0.8f, 0.6f}},
        {RoomSide::kEast, 2.5f, {0.7f, 0.95f}},
        {RoomSide::kEast, 4.6f, {0.8f, 1.0f}},
        {RoomSide::kEast, 6.2f, {0.9f, 0.65f}}},
       seed + 80);
  addKiosk(place, seed + 100);
  addExhibits(place, seed + 200);
  Scene scene = place.build();
  const SeaWalk sea{9832, 2.2f * kInch};
  scene.guides.sea = sea;
  scene.guides.path = laneWalk({{{-0.95f, -2.5f}, {-3.12f, -1.12f}, false},
                                {{-3.12f, -2.5f}, {-4.5f, 2.5f}, true},
                                {{-3.1f, 2.5f}, {-0.95f, 1.12f}, false},
                                {{-0.88f, 2.5f}, {1.15f, -2.5f}, true},
                                {{1.15f, 0}, {2.7f, 0}, true},
                                {{2.65f, -2.45f}, {4.55f, 2.5f}, true}},
                               sea, kPlaceEyeHeight);
  return scene;
}

}  // namespace

BuiltinScene museumScene() {
  return {"museum", "two rooms with paintings and statues around a kiosk, for seas of images; in metres",
          placeParameters(), buildMuseum};
}

}  // namespace ocelli
