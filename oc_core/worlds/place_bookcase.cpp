// Shelves with books: part of place_furniture.h.
#include <algorithm>
#include <cmath>

#include "oc_core/base/random.h"
#include "oc_core/worlds/palette.h"
#include "oc_core/worlds/place_furniture.h"
#include "oc_core/worlds/placement.h"
#include "oc_core/worlds/printed_textures.h"
#include "oc_core/worlds/surface_noise.h"

namespace ocelli {
namespace {

constexpr float kBoard = 0.022f;

uint32_t nextSeed(Random& random) {
  return static_cast<uint32_t>(random.next() >> 33);
}

/// The edges of pages between covers.
SurfaceTexture pagesTexture(uint32_t seed) {
  return [=](const glm::vec2& p) {
    return glm::vec3(0.66f, 0.6f, 0.47f) * (1 + 0.25f * layeredNoise({p.x * 90, p.y * 3}, 2, seed));
  };
}

/// A row of books from `left` to `right` on the board at `y`, their spines around `front`.
void addBookRow(PlaceBuilder& place, const Bookcase& shelf, float left, float right, float y, float room, float front,
                Random& random, const glm::mat4& m) {
  float x = left;
  int lean = 0;  // books left that lean on those before
  while (true) {
    const float thick = shelf.hasFolders ? random.inRange(0.05f, 0.08f) : random.inRange(0.016f, 0.052f);
    if (x + thick > right) {
      break;
    }
    if (random.inRange(0, 1) < shelf.gaps * 0.18f) {  // a gap, after which some lean
      x += random.inRange(0.04f, 0.16f);
      lean = 1 + static_cast<int>(random.below(2));
      continue;
    }
    const float tall = room * (shelf.hasFolders ? random.inRange(0.84f, 0.9f) : random.inRange(0.56f, 0.93f));
    const float deep = std::min(shelf.size.z - 0.06f, shelf.hasFolders ? 0.26f : tall * random.inRange(0.62f, 0.78f));
    const uint32_t seed = nextSeed(random);
    const glm::vec2 spine(thick, tall);
    const SurfaceTexture cover = clothTexture(bindingColor(seed), seed + 9);
    BoxLook look = BoxLook(cover)
                       .with(BoxFace::kFront, shelf.hasFolders ? folderTexture(spine, seed) : spineTexture(spine, seed))
                       .with(BoxFace::kTop, pagesTexture(seed))
                       .plain(BoxFace::kBack)
                       .plain(BoxFace::kLeft)
                       .plain(BoxFace::kRight)
                       .plain(BoxFace::kBottom)
                       .finer(0.85f)
                       .stretched({0.75f, 1, 6})
                       .noShadow();
    if (y > 1.5f) {
      look.plain(BoxFace::kTop);
    }
    const float turn = lean > 0 ? random.inRange(4, 9) : 0;
    lean = std::max(0, lean - 1);
    const auto aside = tall * std::sin(turn * 0.01745f);
    if (x + thick + aside > right) {
      break;
    }
    // It leans to the left on its lower left edge, a little in the board.
    const glm::mat4 foot = m * placedAt({x + aside, y - 0.002f, front - deep / 2 - random.inRange(0, 0.02f)}) *
                           placedAt({0, 0, 0}, turn, {0, 0, 1});
    place.addBox({thick - 0.001f, tall, deep}, foot * placedAt({thick / 2, tall / 2, 0}), look);
    x += thick + aside + random.inRange(0.0005f, 0.002f);
  }
}

}  // namespace

void addBookcase(PlaceBuilder& place, const Bookcase& shelf, const glm::mat4& m) {
  Random random(shelf.seed);
  const glm::vec3& size = shelf.size;
  const SurfaceTexture upright = uprightWoodTexture(shelf.wood, nextSeed(random));
  for (const float side : {-1.0f, 1.0f}) {
    place.addBox({kBoard, size.y, size.z}, m * placedAt({side * (size.x - kBoard) / 2, size.y / 2 - 0.003f, 0}),
                 BoxLook(upright).plain(BoxFace::kBottom).plain(BoxFace::kBack).finer(1.5f).stretched({0.67f, 1, 1}));
  }
  place.addBox({size.x - kBoard, size.y - 0.02f, 0.012f}, m * placedAt({0, size.y / 2, -size.z / 2 + 0.012f}),
               BoxLook(upright).plain(BoxFace::kBack).finer(2.5f));
  const float foot = 0.08f;
  const float room = (size.y - foot - kBoard) / static_cast<float>(shelf.shelves);
  for (int k = 0; k <= shelf.shelves; ++k) {
    const float y = foot + room * static_cast<float>(k);
    const bool isTop = k == shelf.shelves;
    place.addBox({size.x - kBoard, kBoard, size.z - (isTop ? 0.0f : 0.012f)}, m * placedAt({0, y + kBoard / 2, 0.002f}),
                 BoxLook(woodTexture(shelf.wood, nextSeed(random)))
                     .plain(BoxFace::kBack)
                     .finer(1.25f)
                     .stretched({1.1f, 0.8f, 1.8f}));
    if (!isTop) {
      addBookRow(place, shelf, -size.x / 2 + kBoard + 0.002f, size.x / 2 - kBoard - 0.002f, y + kBoard, room - kBoard,
                 size.z / 2 - 0.015f, random, m);
    }
  }
  place.addBox({size.x - kBoard, foot + 0.01f, 0.015f}, m * placedAt({0, foot / 2, size.z / 2 - 0.03f}),
               BoxLook(woodTexture(shelf.wood * 0.8f, nextSeed(random))).plain(BoxFace::kBottom).noShadow());
}

void addBookPile(PlaceBuilder& place, size_t count, const glm::mat4& m, uint32_t seed) {
  Random random(seed);
  float y = -0.002f;
  for (size_t k = 0; k < count; ++k) {
    const glm::vec3 size(random.inRange(0.18f, 0.26f), random.inRange(0.02f, 0.045f), random.inRange(0.13f, 0.19f));
    const uint32_t own = nextSeed(random);
    const SurfaceTexture spine = spineTexture({size.y, size.x}, own);
    // The spine lies: its v runs along the front.
    const SurfaceTexture lying = [spine, size](const glm::vec2& p) { return spine({p.y, size.x - p.x}); };
    place.addBox(size,
                 m * placedAt({random.inRange(-0.02f, 0.02f), y + size.y / 2, random.inRange(-0.02f, 0.02f)},
                              random.inRange(-14, 14)),
                 BoxLook(pagesTexture(own))
                     .with(BoxFace::kFront, lying)
                     .with(BoxFace::kTop, posterTexture({size.x, size.z}, own + 1))
                     .plain(BoxFace::kBottom)
                     .finer(0.7f));
    y += size.y - 0.001f;
  }
}

}  // namespace ocelli
