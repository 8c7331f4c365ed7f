// What stands in museums, offices and libraries. Each thing stands on y = 0 of its frame around the origin, its front
// towards +z, or hangs on the wall z = 0 of its frame. Metres. All are closed solids (place_builder.h).
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "oc_core/worlds/place_builder.h"

namespace ocelli {

/// A picture in a frame, around the origin.
struct FramedPicture {
  glm::vec2 size{1};    ///< of the picture
  float frame = 0.07f;  ///< width of the frame
  SurfaceTexture picture;
  SurfaceTexture moulding;
};
void addFramedPicture(PlaceBuilder& place, const FramedPicture& framed, const glm::mat4& worldFromPicture);

/// A sheet on the wall, such as a poster or a label, a few millimetres thick.
void addSheet(PlaceBuilder& place, const glm::vec2& size, const SurfaceTexture& print, const glm::mat4& worldFromSheet,
              float fineness);

/// A figure of stone or bronze, 1.5 m high, on a plinth of a height.
void addStatue(PlaceBuilder& place, float plinth, const SurfaceTexture& stone, const SurfaceTexture& figure,
               uint32_t seed, const glm::mat4& worldFromStatue);
/// A pot on a plinth.
void addVase(PlaceBuilder& place, float plinth, const SurfaceTexture& stone, uint32_t seed,
             const glm::mat4& worldFromVase);
void addBench(PlaceBuilder& place, float length, const glm::mat4& worldFromBench, uint32_t seed);
/// A post of brass, 0.95 m high.
void addBarrierPost(PlaceBuilder& place, const glm::mat4& worldFromPost, uint32_t seed);

void addTable(PlaceBuilder& place, const glm::vec3& size, const glm::vec3& color, const glm::mat4& worldFromTable,
              uint32_t seed);
void addChair(PlaceBuilder& place, const glm::vec3& color, const glm::mat4& worldFromChair, uint32_t seed);
/// A chair on castors, with arms.
void addOfficeChair(PlaceBuilder& place, const glm::vec3& color, const glm::mat4& worldFromChair, uint32_t seed);
/// A screen, a keyboard, a mouse, papers, a mug and a lamp, on a table of a height; the screen is at the back.
void addDeskThings(PlaceBuilder& place, float width, float height, const glm::mat4& worldFromDesk, uint32_t seed);
void addDeskLamp(PlaceBuilder& place, const glm::vec3& shade, const glm::mat4& worldFromLamp, uint32_t seed);
void addPottedPlant(PlaceBuilder& place, float height, const glm::mat4& worldFromPlant, uint32_t seed);

/// A case of shelves with books, or with folders and boxes, that stands with its back towards -z.
struct Bookcase {
  glm::vec3 size{1, 2, 0.3f};
  int shelves = 6;
  glm::vec3 wood{0.3f, 0.17f, 0.08f};
  bool hasFolders = false;
  float gaps = 0.12f;  ///< part of each shelf that is empty
  uint32_t seed = 1;
};
void addBookcase(PlaceBuilder& place, const Bookcase& shelf, const glm::mat4& worldFromCase);
/// Books that lie on one another.
void addBookPile(PlaceBuilder& place, size_t count, const glm::mat4& worldFromPile, uint32_t seed);

}  // namespace ocelli
