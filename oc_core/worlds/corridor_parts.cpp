#include "oc_core/worlds/corridor_parts.h"

#include "oc_core/worlds/palette.h"
#include "oc_core/worlds/place_furniture.h"
#include "oc_core/worlds/placement.h"
#include "oc_core/worlds/printed_textures.h"

namespace ocelli {
namespace {

constexpr float kWallIntoSlab = 0.05f;
constexpr float kSlabThickness = 0.2f;
constexpr float kHungHeight = 1.55f;

}  // namespace

glm::mat4 addCorridorWall(PlaceBuilder& place, const CorridorWall& wall) {
  PlaceWall solid;
  solid.size = {wall.length, wall.height + 2 * kWallIntoSlab};
  solid.thickness = kCorridorWallThickness;
  solid.front = wall.front;
  solid.back = wall.front;
  solid.rim = wall.front;
  solid.isBackPlain = true;
  place.addWall(solid, placedAt({wall.start.x, -kWallIntoSlab, wall.start.y}, wall.turnDegrees));
  return placedAt({wall.start.x, 0, wall.start.y}, wall.turnDegrees);
}

void addCorridorSlab(PlaceBuilder& place, const CorridorSlab& slab) {
  const glm::vec2 size = slab.upper - slab.lower;
  const glm::vec2 middle = (slab.lower + slab.upper) / 2.0f;
  const BoxFace hidden = slab.isFloor ? BoxFace::kBottom : BoxFace::kTop;
  place.addBox({size.x, kSlabThickness, size.y}, placedAt({middle.x, slab.middle, middle.y}),
               BoxLook(slab.texture).plain(hidden).noShadow());
}

void hangOn(PlaceBuilder& place, const glm::mat4& worldFromWall, const std::vector<OnWall>& list, uint32_t seed) {
  for (const OnWall& each : list) {
    ++seed;
    place.beginObject();
    const glm::mat4 spot = worldFromWall * placedAt({each.along, kHungHeight, 0});
    if (each.isFramed) {
      addFramedPicture(place,
                       {each.size, 0.06f, paintingTexture(each.size, seed * 77),
                        woodTexture(palette::fromSrgbBytes(92, 58, 36), seed)},
                       spot);
    } else {
      addSheet(place, each.size, posterTexture(each.size, seed * 31), spot, 0.75f);
    }
  }
  place.beginStructure();
}

}  // namespace ocelli
