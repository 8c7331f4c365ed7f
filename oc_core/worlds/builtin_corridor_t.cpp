// `builtin:corridor_t`: three corridors that meet in a T, with doors, pictures and posters: a place for a graph camera
// from video (section 4.3.3, Figure 4.4).
//
// The stem runs along z, from the crossing at z in [-2.4, 0] towards +z; the branches run along x.
#include "oc_core/worlds/builtin_list.h"
#include "oc_core/worlds/corridor_parts.h"
#include "oc_core/worlds/palette.h"
#include "oc_core/worlds/place_furniture.h"
#include "oc_core/worlds/place_parameters.h"
#include "oc_core/worlds/place_room.h"

namespace ocelli {
namespace {

constexpr float kCorridorHalf = 1.2f;
constexpr float kBranchEnd = 9;  ///< |x|
constexpr float kStemEnd = 9;    ///< z
constexpr float kCorridorHeight = 2.8f;

void addFloorAndCeiling(PlaceBuilder& place, uint32_t seed) {
  const SurfaceTexture floor = marbleTilesTexture(palette::fromSrgbBytes(168, 160, 146), 0.6f, seed);
  const SurfaceTexture ceiling = ceilingTexture(palette::fromSrgbBytes(226, 226, 220), seed + 1);
  const float branch = kBranchEnd + kCorridorWallThickness;
  const float stem = kCorridorHalf + kCorridorWallThickness;
  const auto slabs = [&](float middle, const SurfaceTexture& texture, bool isFloor) {
    addCorridorSlab(place,
                    {{-branch, -2 * kCorridorHalf - kCorridorWallThickness}, {branch, 0}, middle, texture, isFloor});
    addCorridorSlab(place, {{-stem, 0}, {stem, kStemEnd + kCorridorWallThickness}, middle, texture, isFloor});
  };
  slabs(-0.1f, floor, true);
  slabs(kCorridorHeight + 0.1f, ceiling, false);
}

Scene buildCorridorT(const BuiltinValues& values) {
  PlaceBuilder place(static_cast<float>(values.number("texel")));
  const auto seed = static_cast<uint32_t>(values.count("seed")) * 1000003u + 29;
  const SurfaceTexture cream = plasterTexture(palette::fromSrgbBytes(206, 198, 178), seed + 1);
  const SurfaceTexture green = plasterTexture(palette::fromSrgbBytes(150, 172, 150), seed + 2);
  const SurfaceTexture red = brickTexture(palette::fromSrgbBytes(170, 104, 80), seed + 3);
  const float back = -2 * kCorridorHalf;
  const float south = kBranchEnd - kCorridorHalf - kCorridorWallThickness;
  addFloorAndCeiling(place, seed + 10);
  const auto wall = [&](const glm::vec2& start, double turn, float length, const SurfaceTexture& front) {
    return addCorridorWall(place, {start, turn, length, kCorridorHeight, front});
  };
  const glm::mat4 north = wall({-kBranchEnd, back}, 0, 2 * kBranchEnd, cream);
  const glm::mat4 southLeft = wall({-kCorridorHalf - kCorridorWallThickness, 0}, 180, south, green);
  const glm::mat4 southRight = wall({kBranchEnd, 0}, 180, south, green);
  const glm::mat4 stemLeft = wall({-kCorridorHalf, kStemEnd}, 90, kStemEnd, cream);
  const glm::mat4 stemRight = wall({kCorridorHalf, 0}, -90, kStemEnd, green);
  const glm::mat4 west = wall({-kBranchEnd, 0}, 90, 2 * kCorridorHalf, red);
  const glm::mat4 east = wall({kBranchEnd, back}, -90, 2 * kCorridorHalf, red);
  wall({kCorridorHalf, kStemEnd}, 180, 2 * kCorridorHalf, red);
  place.light().setAmbient({0.5f, 0.51f, 0.53f});
  addCeilingLamps(place, kCorridorHeight,
                  {{-7.5f, -1.2f},
                   {-4.5f, -1.2f},
                   {-1.8f, -1.2f},
                   {1.8f, -1.2f},
                   {4.5f, -1.2f},
                   {7.5f, -1.2f},
                   {0, 1.6f},
                   {0, 4.4f},
                   {0, 7.2f}},
                  {0.9f, 0.4f}, glm::vec3(1, 0.97f, 0.9f) * 2.6f);
  const glm::vec3 oak = palette::fromSrgbBytes(150, 104, 64);
  const glm::vec3 blue = palette::fromSrgbBytes(66, 92, 128);
  addClosedDoor(place, north, 2.2f, oak, seed + 20);
  addClosedDoor(place, north, 14.6f, blue, seed + 21);
  addClosedDoor(place, southLeft, 3.4f, blue, seed + 22);
  addClosedDoor(place, southRight, 4.2f, oak, seed + 23);
  addClosedDoor(place, stemLeft, 6.2f, oak, seed + 24);
  addClosedDoor(place, stemRight, 4.6f, blue, seed + 25);
  addClosedDoor(place, west, kCorridorHalf, oak, seed + 26);
  hangOn(place, north,
         {{0.9f, {0.5f, 0.7f}, false},
          {4.6f, {1.1f, 0.8f}, true},
          {6.6f, {0.6f, 0.85f}, false},
          {9.0f, {0.9f, 1.1f}, true},
          {11.4f, {0.6f, 0.85f}, false},
          {12.9f, {0.8f, 0.6f}, true},
          {16.9f, {0.84f, 0.6f}, false}},
         seed + 40);
  hangOn(place, southLeft, {{1.4f, {0.8f, 0.6f}, true}, {5.6f, {0.6f, 0.85f}, false}}, seed + 60);
  hangOn(place, southRight, {{1.6f, {0.6f, 0.85f}, false}, {6.2f, {0.9f, 0.7f}, true}}, seed + 70);
  hangOn(place, stemLeft, {{3.4f, {0.9f, 0.7f}, true}, {7.9f, {0.5f, 0.7f}, false}}, seed + 80);
  hangOn(place, stemRight, {{1.4f, {0.6f, 0.85f}, false}, {2.9f, {0.8f, 0.6f}, true}}, seed + 90);
  hangOn(place, east, {{kCorridorHalf, {1.2f, 0.9f}, true}}, seed + 100);
  Scene scene = place.build();
  scene.guides.path = {
      {0, kPlaceEyeHeight, 8}, {0, kPlaceEyeHeight, -1.2f}, {-8, kPlaceEyeHeight, -1.2f}, {8, kPlaceEyeHeight, -1.2f}};
  return scene;
}

}  // namespace

BuiltinScene corridorTScene() {
  std::vector<BuiltinParameter> parameters = placeParameters();
  parameters.front().otherwise = "0.03";
  return {"corridor_t", "three corridors that meet in a T, for graph cameras from video; in metres", parameters,
          buildCorridorT};
}

}  // namespace ocelli
