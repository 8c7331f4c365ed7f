// `builtin:office`: a furnished office with a window: a place for a sea of images (section 3.5.4; its Table 3.3 has an
// office of 3,475 images 0.7 inches apart).
#include <cmath>

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

constexpr RoomOpening kOfficeWindow{1.1f, 4.5f, 0.95f, 2.25f};

PlaceRoom officeRoom(uint32_t seed) {
  PlaceRoom room;
  room.lower = {-2.8f, -2.5f};
  room.upper = {2.8f, 2.5f};
  room.height = 2.75f;
  room.sides[0] = {plasterTexture(palette::fromSrgbBytes(214, 212, 202), seed + 1), {kOfficeWindow}};
  room.sides[1].texture = plasterTexture(palette::fromSrgbBytes(150, 168, 176), seed + 2);
  room.sides[2].texture = plasterTexture(palette::fromSrgbBytes(216, 206, 184), seed + 3);
  room.sides[3].texture = plasterTexture(palette::fromSrgbBytes(210, 206, 196), seed + 4);
  room.floor = carpetTexture(palette::fromSrgbBytes(104, 112, 128), seed + 5);
  room.ceiling = ceilingTexture(palette::fromSrgbBytes(226, 224, 218), seed + 6);
  return room;
}

/// What the window shows, its frame, and blinds whose slats are half open.
void addWindowWithBlinds(PlaceBuilder& place, const PlaceRoom& room, uint32_t seed) {
  const glm::mat4 wall = worldFromSide(room, RoomSide::kNorth);
  const glm::vec2 size(kOfficeWindow.right - kOfficeWindow.left, kOfficeWindow.top - kOfficeWindow.bottom);
  const glm::vec2 middle(kOfficeWindow.left + size.x / 2, kOfficeWindow.bottom + size.y / 2);
  place.addBox({size.x + 0.06f, size.y + 0.06f, 0.03f}, wall * placedAt({middle.x, middle.y, -0.17f}),
               BoxLook(outdoorsTexture(size, seed)).plain(BoxFace::kBack).glowing(1).noShadow());
  const SurfaceTexture white = plasticTexture(glm::vec3(0.72f), seed + 1);
  for (const float t : {0.0f, 0.5f, 1.0f}) {
    place.addBox({0.07f, size.y + 0.04f, 0.06f}, wall * placedAt({kOfficeWindow.left + t * size.x, middle.y, -0.13f}),
                 BoxLook(white).noShadow());
  }
  for (const float t : {0.0f, 1.0f}) {
    place.addBox({size.x + 0.02f, 0.068f, 0.056f},
                 wall * placedAt({middle.x, kOfficeWindow.bottom + t * size.y, -0.13f}), BoxLook(white).noShadow());
  }
  place.addBox({size.x + 0.24f, 0.035f, 0.28f}, wall * placedAt({middle.x, kOfficeWindow.bottom - 0.01f, -0.0f}),
               BoxLook(marbleTexture(glm::vec3(0.66f), seed + 2)));
  Random random(seed);
  const auto slats = static_cast<int>(size.y * 0.78f / 0.045f);
  for (int k = 0; k < slats; ++k) {
    const float y = kOfficeWindow.top - 0.05f - 0.045f * static_cast<float>(k);
    place.addBox({size.x - 0.03f, 0.004f, 0.046f},
                 wall * placedAt({middle.x, y, -0.06f}, 32 + random.inRange(-5, 5), {1, 0, 0}),
                 BoxLook(plasticTexture(glm::vec3(0.74f, 0.72f, 0.66f), seed + 10 + static_cast<uint32_t>(k)))
                     .noShadow()
                     .stretched({2, 1, 1}));
  }
  place.addBox({size.x + 0.04f, 0.06f, 0.07f}, wall * placedAt({middle.x, kOfficeWindow.top - 0.01f, -0.055f}),
               BoxLook(white).noShadow());
  for (const float x : {0.12f, 0.5f, 0.88f}) {
    const glm::vec3 top(wall * glm::vec4(kOfficeWindow.left + x * size.x, kOfficeWindow.top - 0.03f, -0.03f, 1));
    place.addTube({top, top - glm::vec3(0, size.y * 0.8f, 0)}, 0.004f, clothTexture(glm::vec3(0.6f), seed + 3), 2);
  }
  place.light().addLamp({glm::vec3(wall * glm::vec4(middle.x, middle.y, -0.02f, 1)),
                         {size.x / 2, 0, 0},
                         {0, size.y / 2, 0},
                         {0, 0, 1},
                         glm::vec3(0.85f, 0.95f, 1.1f) * 0.55f});
}

void addDesks(PlaceBuilder& place, uint32_t seed) {
  struct Desk {
    glm::vec2 place;
    double turn;
    float width;
    glm::vec2 chair;  ///< in the frame of the desk
    double chairTurn;
  };
  const Desk desks[] = {{{-1.35f, -2.06f}, 0, 1.6f, {0.1f, 0.62f}, 170},
                        {{0.85f, -2.06f}, 0, 1.6f, {-0.15f, 0.66f}, 200},
                        {{-2.36f, 0.9f}, 90, 1.7f, {0.1f, 0.6f}, 165}};
  for (const Desk& desk : desks) {
    seed += 40;
    const glm::mat4 m = placedAt({desk.place.x, 0, desk.place.y}, desk.turn);
    place.beginObject();
    addTable(place, {desk.width, 0.74f, 0.78f}, palette::fromSrgbBytes(196, 164, 122), m, seed);
    place.addBox({0.38f, 0.6f, 0.55f}, m * placedAt({desk.width / 2 - 0.32f, 0.298f, -0.05f}),
                 BoxLook(metalTexture(glm::vec3(0.42f, 0.43f, 0.45f), seed + 1)).plain(BoxFace::kBottom));
    for (const float y : {0.12f, 0.3f, 0.48f}) {
      place.addBox({0.35f, 0.165f, 0.02f}, m * placedAt({desk.width / 2 - 0.32f, y, 0.228f}),
                   BoxLook(metalTexture(glm::vec3(0.5f, 0.51f, 0.54f), seed + 2 + static_cast<uint32_t>(y * 50)))
                       .plain(BoxFace::kBack)
                       .noShadow());
    }
    place.beginObject();
    addDeskThings(place, desk.width, 0.74f, m, seed + 10);
    addDeskLamp(place, bindingColor(seed) + 0.2f, m * placedAt({-desk.width / 2 + 0.45f, 0.74f, -0.2f}), seed + 11);
    // Cables from the screen to the wall and along the floor.
    const auto at = [&](float x, float y, float z) { return glm::vec3(m * glm::vec4(x, y, z, 1)); };
    for (int k = 0; k < 4; ++k) {
      const float x = -0.25f + 0.17f * static_cast<float>(k);
      std::vector<glm::vec3> cable{at(x, 0.9f, -0.2f), at(x + 0.03f, 0.76f, -0.33f), at(x + 0.02f, 0.72f, -0.403f)};
      for (int s = 1; s <= 10; ++s) {
        const float t = static_cast<float>(s) / 10;
        cable.push_back(at(x + 0.02f + 0.25f * t * t, 0.72f - 0.7f * t, -0.405f + 0.03f * std::sin(3.1f * t)));
      }
      cable.push_back(at(x + 0.5f, 0.012f, -0.36f + 0.02f * static_cast<float>(k)));
      place.addTube(cable, 0.0055f, plasticTexture(k == 2 ? glm::vec3(0.4f, 0.4f, 0.1f) : glm::vec3(0.05f), seed),
                    1.2f);
    }
    place.beginObject();
    addOfficeChair(place, bindingColor(seed + 5), m * placedAt({desk.chair.x, 0, desk.chair.y}, desk.chairTurn),
                   seed + 12);
    place.beginStructure();
  }
}

void addOfficeWalls(PlaceBuilder& place, const PlaceRoom& room, uint32_t seed) {
  const glm::mat4 south = worldFromSide(room, RoomSide::kSouth);
  const glm::mat4 east = worldFromSide(room, RoomSide::kEast);
  const glm::mat4 west = worldFromSide(room, RoomSide::kWest);
  const glm::vec2 board(1.9f, 1.1f);
  place.beginObject();
  addFramedPicture(place, {board, 0.03f, whiteboardTexture(board, seed), metalTexture(glm::vec3(0.5f), seed + 1)},
                   south * placedAt({3.4f, 1.5f, 0}));
  place.addBox({1.2f, 0.025f, 0.09f}, south * placedAt({3.4f, 0.9f, 0.04f}),
               BoxLook(metalTexture(glm::vec3(0.45f), seed + 2)).plain(BoxFace::kBack));
  for (int k = 0; k < 3; ++k) {
    const float x = 3.1f + 0.2f * static_cast<float>(k);
    const glm::vec3 from(south * glm::vec4(x, 0.92f, 0.045f, 1));
    const glm::vec3 to(south * glm::vec4(x + 0.13f, 0.92f, 0.05f, 1));
    place.addTube({from, to}, 0.01f, plasticTexture(bindingColor(seed + static_cast<uint32_t>(k)), seed), 0.7f);
  }
  const auto poster = [&](const glm::mat4& side, float along, float up, const glm::vec2& size) {
    ++seed;
    addSheet(place, size, posterTexture(size, seed * 31), side * placedAt({along, up, 0}, 0), 0.75f);
  };
  poster(west, 1.5f, 1.6f, {0.6f, 0.85f});
  poster(west, 2.4f, 1.72f, {0.45f, 0.62f});
  poster(west, 3.6f, 1.65f, {0.84f, 0.6f});
  poster(east, 0.5f, 1.6f, {0.5f, 0.7f});
  poster(east, 4.5f, 1.55f, {0.6f, 0.85f});
  poster(south, 5.1f, 1.5f, {0.5f, 0.7f});
  addClosedDoor(place, south, 1.1f, palette::fromSrgbBytes(186, 150, 104), seed + 20);
  Random random(seed);
  for (int k = 0; k < 14; ++k) {  // notes beside the desk
    const glm::vec2 size(0.09f + 0.12f * random.inRange(0, 1), 0.12f);
    addSheet(place, size, paperTexture(size, seed + 30 + static_cast<uint32_t>(k)),
             west * placedAt({4.3f + 0.19f * static_cast<float>(k % 4), 1.35f + 0.17f * static_cast<float>(k / 4), 0}) *
                 placedAt({0, 0, 0}, random.inRange(-6, 6), {0, 0, 1}),
             0.6f);
  }
  // A clock, and switches beside the door.
  const glm::mat4 clock = south * placedAt({1.1f, 2.42f, 0}) * placedAt({0, 0, 0}, 90, {1, 0, 0});
  place.addTurned({{0, -0.01f}, {0.15f, -0.01f}, {0.16f, 0.035f}, {0.135f, 0.04f}, {0.13f, 0.02f}, {0, 0.022f}}, clock,
                  plasticTexture(glm::vec3(0.6f, 0.58f, 0.55f), seed + 50));
  place.addBox({0.08f, 0.14f, 0.02f}, south * placedAt({1.85f, 1.1f, 0.005f}),
               BoxLook(plasticTexture(glm::vec3(0.7f), seed + 51)).plain(BoxFace::kBack).noShadow());
  const SurfaceTexture boards = woodTexture(palette::fromSrgbBytes(150, 120, 88), seed + 52);
  addSkirting(place, room, RoomSide::kNorth, {}, boards);
  addSkirting(place, room, RoomSide::kSouth, {{0.57f, 1.63f}}, boards);
  addSkirting(place, room, RoomSide::kWest, {}, boards);
  addSkirting(place, room, RoomSide::kEast, {}, boards);
}

void addOfficeShelves(PlaceBuilder& place, uint32_t seed) {
  for (int k = 0; k < 3; ++k) {
    place.beginObject();
    addBookcase(place,
                {{0.9f, k == 2 ? 1.25f : 2.05f, 0.34f},
                 k == 2 ? 3 : 5,
                 palette::fromSrgbBytes(198, 170, 130),
                 k != 1,
                 0.3f,
                 seed + static_cast<uint32_t>(k)},
                placedAt({2.6f, 0, -0.85f + 0.905f * static_cast<float>(k)}, -90));
  }
  place.beginObject();
  addBookPile(place, 6, placedAt({2.6f, 1.25f, 0.75f}, -70), seed + 9);
  addPottedPlant(place, 0.5f, placedAt({2.6f, 1.25f, 1.15f}), seed + 10);
  place.beginObject();
  addPottedPlant(place, 1.4f, placedAt({2.35f, 0, 2.05f}), seed + 11);
  place.beginObject();
  addPottedPlant(place, 0.45f, placedAt({1.5f, 0.955f, -2.43f}), seed + 12);
  place.beginObject();  // a bin with paper
  place.addTurned({{0, -0.004f}, {0.11f, -0.004f}, {0.14f, 0.31f}, {0.13f, 0.312f}, {0.105f, 0.03f}, {0, 0.03f}},
                  placedAt({-2.45f, 0, -0.35f}), metalTexture(glm::vec3(0.2f, 0.22f, 0.26f), seed + 13));
  for (int k = 0; k < 5; ++k) {
    const float turn = 1.3f * static_cast<float>(k);
    place.addBall(glm::vec3(0.045f),
                  placedAt({-2.45f + 0.06f * std::sin(turn), 0.2f + 0.025f * static_cast<float>(k),
                            -0.35f + 0.06f * std::cos(turn)}),
                  paperTexture({0.28f, 0.14f}, seed + 20 + static_cast<uint32_t>(k)), 0.7f);
  }
  place.beginObject();  // boxes of things
  place.addBox({0.42f, 0.3f, 0.34f}, placedAt({-2.42f, 0.147f, 2.2f}, 12),
               BoxLook(paperTexture({0.42f, 0.3f}, seed + 30))
                   .with(BoxFace::kTop, plasterTexture({0.3f, 0.2f, 0.11f}, seed + 31)));
  place.addBox({0.36f, 0.24f, 0.3f}, placedAt({-2.4f, 0.413f, 2.2f}, -9),
               BoxLook(plasterTexture({0.34f, 0.22f, 0.12f}, seed + 32))
                   .with(BoxFace::kFront, posterTexture({0.36f, 0.24f}, seed + 33)));
  place.beginStructure();
}

Scene buildOffice(const BuiltinValues& values) {
  PlaceBuilder place(static_cast<float>(values.number("texel")));
  const auto seed = static_cast<uint32_t>(values.count("seed")) * 1000003u + 17;
  const PlaceRoom room = officeRoom(seed);
  addRoom(place, room);
  place.light().setAmbient({0.52f, 0.54f, 0.57f});
  addCeilingLamps(place, room.height, {{-1.5f, -0.6f}, {1.2f, -0.6f}, {-1.5f, 1.2f}, {1.2f, 1.2f}}, {1.2f, 0.3f},
                  glm::vec3(1, 0.97f, 0.9f) * 3.2f);
  addWindowWithBlinds(place, room, seed + 20);
  addOfficeWalls(place, room, seed + 100);
  addDesks(place, seed + 300);
  addOfficeShelves(place, seed + 600);
  Scene scene = place.build();
  const SeaWalk sea{3475, 0.7f * kInch};
  scene.guides.sea = sea;
  scene.guides.path = laneWalk({{{-0.35f, -0.1f}, {0.8f, 1.1f}, true}}, sea, kPlaceEyeHeight);
  return scene;
}

}  // namespace

BuiltinScene officeScene() {
  return {"office", "an office with desks, shelves, a window with blinds, and plants, for seas of images; in metres",
          placeParameters(), buildOffice};
}

}  // namespace ocelli
