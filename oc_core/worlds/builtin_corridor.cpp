// `builtin:corridor`: a corridor with two corners, as a Z, each with a niche to wait in: a place for a graph camera
// from video (section 4.3.3).
//
// The first part runs along z, from the corner at z in [-2.4, 0] towards +z; the second along +x from there to the
// corner at x in [4.4, 6.8]; the third from there towards -z. Niches go on behind both corners.
#include "oc_core/worlds/builtin_list.h"
#include "oc_core/worlds/corridor_parts.h"
#include "oc_core/worlds/palette.h"
#include "oc_core/worlds/place_furniture.h"
#include "oc_core/worlds/place_parameters.h"
#include "oc_core/worlds/place_room.h"
#include "oc_core/worlds/placement.h"

namespace ocelli {
namespace {

constexpr float kZHalf = 1.2f;
constexpr float kZFirstEnd = 8;       ///< z
constexpr float kZNicheEnd = -4.6f;   ///< x
constexpr float kZCorner = 4.4f;      ///< x of the inner side of the second corner
constexpr float kZThirdEnd = -10;     ///< z
constexpr float kZNicheDepth = 3.8f;  ///< z, of the second niche
constexpr float kZHeight = 2.8f;
constexpr float kZThick = kCorridorWallThickness;

void addSlabs(PlaceBuilder& place, float middle, const SurfaceTexture& texture, bool isFloor) {
  const float far = kZCorner + 2 * kZHalf + kZThick;
  const float back = -2 * kZHalf - kZThick;
  for (const auto& [lower, upper] : {std::pair<glm::vec2, glm::vec2>{{kZNicheEnd - kZThick, back}, {far, 0}},
                                     {{-kZHalf - kZThick, 0}, {kZHalf + kZThick, kZFirstEnd + kZThick}},
                                     {{kZCorner - kZThick, 0}, {far, kZNicheDepth + kZThick}},
                                     {{kZCorner - kZThick, kZThirdEnd - kZThick}, {far, back}}}) {
    addCorridorSlab(place, {lower, upper, middle, texture, isFloor});
  }
}

void addNicheThings(PlaceBuilder& place, uint32_t seed) {
  place.beginObject();
  addBench(place, 1.4f, placedAt({-3.1f, 0, -2.1f}), seed);
  place.beginObject();
  addPottedPlant(place, 1.3f, placedAt({-4.2f, 0, -0.4f}), seed + 1);
  place.beginObject();
  addBench(place, 1.4f, placedAt({6.5f, 0, 1.9f}, -90), seed + 2);
  place.beginObject();
  addPottedPlant(place, 1.4f, placedAt({4.8f, 0, 3.4f}), seed + 3);
  place.beginStructure();
}

Scene buildCorridor(const BuiltinValues& values) {
  PlaceBuilder place(static_cast<float>(values.number("texel")));
  const auto seed = static_cast<uint32_t>(values.count("seed")) * 1000003u + 41;
  const SurfaceTexture cream = plasterTexture(palette::fromSrgbBytes(210, 200, 176), seed + 1);
  const SurfaceTexture blue = plasterTexture(palette::fromSrgbBytes(140, 162, 182), seed + 2);
  const SurfaceTexture ochre = plasterTexture(palette::fromSrgbBytes(204, 168, 104), seed + 3);
  const SurfaceTexture red = brickTexture(palette::fromSrgbBytes(170, 104, 80), seed + 4);
  addSlabs(place, -0.1f, marbleTilesTexture(palette::fromSrgbBytes(160, 156, 150), 0.6f, seed + 10), true);
  addSlabs(place, kZHeight + 0.1f, ceilingTexture(palette::fromSrgbBytes(226, 226, 220), seed + 11), false);
  const auto wall = [&](const glm::vec2& start, double turn, float length, const SurfaceTexture& front) {
    return addCorridorWall(place, {start, turn, length, kZHeight, front});
  };
  const float back = -2 * kZHalf;
  const float far = kZCorner + 2 * kZHalf;
  const glm::mat4 north = wall({kZNicheEnd, back}, 0, kZCorner - kZNicheEnd, cream);
  const glm::mat4 nicheEnd = wall({kZNicheEnd, 0}, 90, 2 * kZHalf, red);
  wall({-kZHalf - kZThick, 0}, 180, -kZHalf - kZThick - kZNicheEnd, blue);
  const glm::mat4 firstLeft = wall({-kZHalf, kZFirstEnd}, 90, kZFirstEnd, cream);
  const glm::mat4 firstRight = wall({kZHalf, 0}, -90, kZFirstEnd, blue);
  wall({kZHalf, kZFirstEnd}, 180, 2 * kZHalf, red);
  const glm::mat4 south = wall({kZCorner - kZThick, 0}, 180, kZCorner - kZHalf - 2 * kZThick, blue);
  wall({kZCorner, kZNicheDepth}, 90, kZNicheDepth, blue);
  wall({far, kZNicheDepth}, 180, 2 * kZHalf, red);
  const glm::mat4 east = wall({far, kZThirdEnd}, -90, kZNicheDepth - kZThirdEnd, ochre);
  const glm::mat4 thirdLeft = wall({kZCorner, back - kZThick}, 90, back - kZThick - kZThirdEnd, cream);
  const glm::mat4 thirdEnd = wall({kZCorner, kZThirdEnd}, 0, 2 * kZHalf, red);
  place.light().setAmbient({0.5f, 0.51f, 0.53f});
  addCeilingLamps(place, kZHeight,
                  {{-3.2f, -1.2f},
                   {0, -1.2f},
                   {2.8f, -1.2f},
                   {5.6f, -1.2f},
                   {0, 1.8f},
                   {0, 4.6f},
                   {0, 7},
                   {5.6f, 2},
                   {5.6f, -4},
                   {5.6f, -6.5f},
                   {5.6f, -9}},
                  {0.9f, 0.4f}, glm::vec3(1, 0.97f, 0.9f) * 2.6f);
  const glm::vec3 oak = palette::fromSrgbBytes(150, 104, 64);
  const glm::vec3 slate = palette::fromSrgbBytes(66, 92, 128);
  addClosedDoor(place, north, 6.6f, oak, seed + 20);
  addClosedDoor(place, south, 1.4f, slate, seed + 21);
  addClosedDoor(place, firstLeft, 5.2f, oak, seed + 22);
  addClosedDoor(place, firstRight, 3.6f, slate, seed + 23);
  addClosedDoor(place, thirdLeft, 2.4f, slate, seed + 24);
  addClosedDoor(place, thirdLeft, 5.6f, oak, seed + 25);
  addClosedDoor(place, east, 5.4f, oak, seed + 26);
  addClosedDoor(place, thirdEnd, kZHalf, slate, seed + 27);
  hangOn(place, north, {{1.5f, {0.9f, 0.7f}, true}, {4.3f, {0.8f, 1.0f}, true}, {8.2f, {0.6f, 0.85f}, false}},
         seed + 40);
  hangOn(place, nicheEnd, {{kZHalf, {0.8f, 0.6f}, true}}, seed + 50);
  hangOn(place, firstLeft, {{2.4f, {0.9f, 0.7f}, true}, {7.1f, {0.6f, 0.85f}, false}}, seed + 70);
  hangOn(place, firstRight, {{1.2f, {0.6f, 0.85f}, false}, {5.4f, {0.8f, 0.6f}, true}}, seed + 80);
  hangOn(place, east,
         {{1.4f, {0.8f, 0.6f}, true},
          {3.4f, {0.6f, 0.85f}, false},
          {5.6f, {1.1f, 0.8f}, true},
          {9.2f, {0.9f, 1.1f}, true}},
         seed + 90);
  hangOn(place, thirdLeft, {{4, {0.8f, 0.6f}, true}}, seed + 100);
  addNicheThings(place, seed + 110);
  Scene scene = place.build();
  scene.guides.path = {{0, kPlaceEyeHeight, 7},
                       {0, kPlaceEyeHeight, -1.2f},
                       {5.6f, kPlaceEyeHeight, -1.2f},
                       {5.6f, kPlaceEyeHeight, -9}};
  return scene;
}

}  // namespace

BuiltinScene corridorScene() {
  std::vector<BuiltinParameter> parameters = placeParameters();
  parameters.front().otherwise = "0.03";
  return {"corridor", "a corridor with two corners, for graph cameras from video; in metres", parameters,
          buildCorridor};
}

}  // namespace ocelli
