// `builtin:courtyard`: a court between arcades under the sky, with a gate to a lane: a place for a graph camera from
// video (section 4.3.3).
//
// The court is |x| < 4, z in [-9, 5]. Arcades run along both of its long sides, behind columns; the gate in the north
// wall, |x| < 1.2, leads to a lane along x at z in [-11.8, -9.2].
#include <array>

#include "oc_core/worlds/builtin_list.h"
#include "oc_core/worlds/corridor_parts.h"
#include "oc_core/worlds/palette.h"
#include "oc_core/worlds/place_furniture.h"
#include "oc_core/worlds/place_parameters.h"
#include "oc_core/worlds/place_room.h"
#include "oc_core/worlds/placement.h"
#include "oc_core/worlds/printed_textures.h"

namespace ocelli {
namespace {

constexpr float kCourtHalf = 4;        ///< |x| of the fronts over the columns
constexpr float kCourtArcade = 6.6f;   ///< |x| of the back walls of the arcades
constexpr float kCourtNorth = -9;      ///< z
constexpr float kCourtSouth = 5;       ///< z
constexpr float kCourtColumnStep = 2;  ///< from one column to the next
constexpr float kCourtLintel = 2.8f;   ///< height of the openings
constexpr float kCourtHeight = 6;      ///< of the walls around the court
constexpr float kCourtGateHalf = 1.2f;
constexpr float kCourtGateHeight = 2.9f;
constexpr float kCourtLaneBack = -11.8f;  ///< z
constexpr float kCourtLaneEnd = 7.2f;     ///< |x|
constexpr float kCourtLaneHeight = 4.4f;
constexpr float kCourtThick = kCorridorWallThickness;

glm::vec3 courtStone() {
  return palette::fromSrgbBytes(196, 184, 158);
}

void addColumn(PlaceBuilder& place, const glm::vec2& at, uint32_t seed) {
  place.beginObject();
  place.addTurned({{0, -0.02f},
                   {0.25f, -0.02f},
                   {0.25f, 0.14f},
                   {0.18f, 0.2f},
                   {0.165f, 1.4f},
                   {0.15f, kCourtLintel - 0.24f},
                   {0.2f, kCourtLintel - 0.18f},
                   {0.25f, kCourtLintel - 0.12f},
                   {0.25f, kCourtLintel + 0.02f},
                   {0, kCourtLintel + 0.02f}},
                  placedAt({at.x, 0, at.y}), marbleTexture(courtStone(), seed));
  place.beginStructure();
}

/// A window that looks dark from without, on the wall z = 0 of a frame.
void addCourtWindow(PlaceBuilder& place, const glm::mat4& wall, const glm::vec2& at, uint32_t seed) {
  const glm::vec2 size(0.9f, 1.4f);
  const glm::mat4 spot = wall * placedAt({at.x, at.y, 0});
  place.addBox({size.x, size.y, 0.04f}, spot, BoxLook(outdoorsTexture(size, seed)).plain(BoxFace::kBack).noShadow());
  const BoxLook frame(uprightWoodTexture(palette::fromSrgbBytes(96, 110, 100), seed + 1));
  for (const float x : {-0.5f, 0.0f, 0.5f}) {
    place.addBox({x == 0 ? 0.05f : 0.1f, size.y + 0.1f, 0.09f}, spot * placedAt({x * size.x, 0, 0}), frame);
  }
  for (const float y : {-0.5f, 0.5f}) {
    place.addBox({size.x + 0.2f, 0.1f, 0.11f}, spot * placedAt({0, y * (size.y + 0.1f), 0}), frame);
  }
}

/// The arcade at one side: columns, the wall that they carry, and the wall and ceiling behind.
void addArcade(PlaceBuilder& place, float side, const SurfaceTexture& upper, const SurfaceTexture& back,
               uint32_t seed) {
  for (float z = kCourtNorth; z <= kCourtSouth; z += kCourtColumnStep) {
    addColumn(place, {side * (kCourtHalf + 0.26f), z}, ++seed);
  }
  const float length = kCourtSouth - kCourtNorth;
  const float middle = (kCourtSouth + kCourtNorth) / 2;
  const float above = kCourtHeight - kCourtLintel;
  place.addBox({0.5f, above, length + 0.02f}, placedAt({side * (kCourtHalf + 0.25f), kCourtLintel + above / 2, middle}),
               BoxLook(upper));
  place.addBox({kCourtArcade - kCourtHalf - 0.2f, 0.2f, length + 0.1f},
               placedAt({side * (kCourtArcade + kCourtHalf + 0.4f) / 2, kCourtLintel + 0.25f, middle}),
               BoxLook(woodTexture(palette::fromSrgbBytes(120, 88, 60), ++seed)).plain(BoxFace::kTop));
  const glm::mat4 wall = addCorridorWall(place, {{side * kCourtArcade, side < 0 ? kCourtSouth : kCourtNorth},
                                                 side < 0 ? 90.0 : -90.0,
                                                 length,
                                                 kCourtLintel + 0.2f,
                                                 back});
  // From the north: along the wall the other way round at the left side.
  const auto along = [&](float fromNorth) { return side < 0 ? length - fromNorth : fromNorth; };
  addClosedDoor(place, wall, along(2.2f), palette::fromSrgbBytes(66, 92, 128), seed + 20);
  addClosedDoor(place, wall, along(7.4f), palette::fromSrgbBytes(150, 104, 64), seed + 21);
  hangOn(place, wall,
         {{along(0.8f), {0.6f, 0.85f}, false},
          {along(3.9f), {0.9f, 1.1f}, true},
          {along(5.7f), {0.6f, 0.85f}, false},
          {along(9.2f), {1.1f, 0.8f}, true}},
         seed + 30);
  const glm::mat4 front = placedAt({side * kCourtHalf, 0, side < 0 ? kCourtSouth : kCourtNorth}, side < 0 ? 90 : -90);
  for (const float fromNorth : {1.0f, 3.0f, 5.0f, 7.0f, 9.0f, 11.0f}) {
    addCourtWindow(place, front, {along(fromNorth), 4.4f}, ++seed * 7);
  }
}

void addNorthAndLane(PlaceBuilder& place, const SurfaceTexture& wall, const SurfaceTexture& lane, uint32_t seed) {
  // The north wall leaves the gate open.
  const float outer = kCourtLaneEnd + 0.1f;
  const float half = outer - kCourtGateHalf;
  for (const float left : {-outer, kCourtGateHalf}) {
    addCorridorWall(place, {{left, kCourtNorth}, 0, half, kCourtHeight, wall});
  }
  place.addBox({2 * kCourtGateHalf + 0.02f, kCourtHeight - kCourtGateHeight, kCourtThick + 0.03f},
               placedAt({0, (kCourtHeight + kCourtGateHeight) / 2, kCourtNorth - kCourtThick / 2}), BoxLook(wall));
  const glm::mat4 north = placedAt({-kCourtArcade, 0, kCourtNorth});
  for (const float x : {3.7f, 6.6f, 9.5f}) {
    addCourtWindow(place, north, {x, 4.4f}, ++seed * 11);
  }
  hangOn(place, north, {{4.2f, {0.9f, 1.1f}, true}, {9, {0.6f, 0.85f}, false}}, seed + 5);
  const glm::mat4 back =
      addCorridorWall(place, {{-kCourtLaneEnd, kCourtLaneBack}, 0, 2 * kCourtLaneEnd, kCourtLaneHeight, lane});
  for (const float end : {-kCourtLaneEnd, kCourtLaneEnd}) {
    const double turn = end < 0 ? 90 : -90;
    const glm::mat4 wallEnd = addCorridorWall(place, {{end, end < 0 ? kCourtNorth - kCourtThick : kCourtLaneBack},
                                                      turn,
                                                      kCourtNorth - kCourtThick - kCourtLaneBack,
                                                      kCourtLaneHeight,
                                                      wall});
    addClosedDoor(place, wallEnd, 1.3f, palette::fromSrgbBytes(90, 120, 96), seed + 6);
  }
  addClosedDoor(place, back, 9.4f, palette::fromSrgbBytes(150, 104, 64), seed + 7);
  hangOn(place, back,
         {{3, {0.9f, 1.1f}, true},
          {5.6f, {0.6f, 0.85f}, false},
          {7.9f, {0.9f, 0.7f}, true},
          {11.4f, {0.6f, 0.85f}, false},
          {13.2f, {0.9f, 0.7f}, true}},
         seed + 8);
}

void addCourtThings(PlaceBuilder& place, uint32_t seed) {
  for (const glm::vec2& at :
       {glm::vec2(-2.9f, -7.9f), glm::vec2(2.9f, -7.9f), glm::vec2(-2.9f, 0.2f), glm::vec2(2.9f, 0.2f)}) {
    place.beginObject();
    addPottedPlant(place, 1.2f, placedAt({at.x, 0, at.y}), ++seed);
  }
  for (const float side : {-1.0f, 1.0f}) {
    place.beginObject();
    addBench(place, 1.5f, placedAt({side * 6.25f, 0, -4.0f}, -90 * side), ++seed);
  }
  place.beginStructure();
}

/// Light from all of the sky over the court and the lane, and a little sun's warmth from the west.
void addSkyLight(PlaceBuilder& place) {
  place.light().setAmbient({0.36f, 0.38f, 0.42f});
  place.light().addLamp({{0, 9, -2}, {4, 0, 0}, {0, 0, 7}, {0, -1, 0}, glm::vec3(0.86f, 0.93f, 1) * 0.5f});
  place.light().addLamp({{0, 7.4f, -10.5f}, {7, 0, 0}, {0, 0, 1.2f}, {0, -1, 0}, glm::vec3(0.86f, 0.93f, 1) * 0.6f});
  place.light().addLamp({{-5, 11, 4}, {0.6f, 0, 0}, {0, 0, 0.6f}, {0, -1, 0}, glm::vec3(1, 0.9f, 0.72f) * 14.0f});
}

Scene buildCourtyard(const BuiltinValues& values) {
  PlaceBuilder place(static_cast<float>(values.number("texel")));
  const auto seed = static_cast<uint32_t>(values.count("seed")) * 1000003u + 47;
  const SurfaceTexture ochre = plasterTexture(palette::fromSrgbBytes(206, 172, 116), seed + 1);
  const SurfaceTexture cream = plasterTexture(palette::fromSrgbBytes(212, 204, 182), seed + 2);
  const SurfaceTexture rose = plasterTexture(palette::fromSrgbBytes(196, 146, 122), seed + 3);
  const SurfaceTexture red = brickTexture(palette::fromSrgbBytes(170, 104, 80), seed + 4);
  const float reach = kCourtArcade + kCourtThick;
  addCorridorSlab(place, {{-reach, kCourtNorth - 0.1f},
                          {reach, kCourtSouth + kCourtThick},
                          -0.1f,
                          marbleTilesTexture(palette::fromSrgbBytes(170, 160, 142), 0.7f, seed + 10)});
  addCorridorSlab(place, {{-7.4f, kCourtLaneBack - kCourtThick},
                          {7.4f, kCourtNorth - 0.1f},
                          -0.1f,
                          marbleTilesTexture(palette::fromSrgbBytes(140, 138, 134), 0.4f, seed + 11)});
  addSkyLight(place);
  addArcade(place, -1, ochre, cream, seed + 100);
  addArcade(place, 1, ochre, rose, seed + 200);
  addNorthAndLane(place, ochre, red, seed + 300);
  const glm::mat4 south =
      addCorridorWall(place, {{kCourtArcade, kCourtSouth}, 180, 2 * kCourtArcade, kCourtHeight, ochre});
  addClosedDoor(place, south, kCourtArcade, palette::fromSrgbBytes(120, 78, 46), seed + 400);
  addCourtThings(place, seed + 500);
  Scene scene = place.build();
  scene.guides.path = {{0, kPlaceEyeHeight, 3.5f}, {0, kPlaceEyeHeight, -6},     {-5.3f, kPlaceEyeHeight, -6},
                       {0, kPlaceEyeHeight, -6},   {0, kPlaceEyeHeight, -10.5f}, {5, kPlaceEyeHeight, -10.5f}};
  return scene;
}

}  // namespace

BuiltinScene courtyardScene() {
  std::vector<BuiltinParameter> parameters = placeParameters();
  parameters.front().otherwise = "0.04";
  return {"courtyard", "a court between arcades, with a gate to a lane, for graph cameras from video; in metres",
          parameters, buildCourtyard};
}

}  // namespace ocelli
