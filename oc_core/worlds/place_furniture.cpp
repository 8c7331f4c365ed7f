#include "oc_core/worlds/place_furniture.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "oc_core/base/conventions.h"
#include "oc_core/base/random.h"
#include "oc_core/worlds/palette.h"
#include "oc_core/worlds/placement.h"
#include "oc_core/worlds/printed_textures.h"
#include "oc_core/worlds/surface_noise.h"

namespace ocelli {
namespace {

glm::vec3 placeOf(const glm::mat4& m, const glm::vec3& p) {
  return glm::vec3(m * glm::vec4(p, 1));
}

/// An occluder for what has none of its own, of the box between two corners of a frame.
void addShadow(PlaceBuilder& place, const glm::mat4& m, const glm::vec3& lower, const glm::vec3& upper) {
  place.light().addOccluder(upper - lower, m * placedAt((lower + upper) * 0.5f));
}

void addPlinth(PlaceBuilder& place, float width, float height, const SurfaceTexture& stone, const glm::mat4& m) {
  constexpr float kBase = 0.06f;
  const float side = width - 0.06f;
  place.addBox({width, kBase, width}, m * placedAt({0, kBase / 2 - 0.004f, 0}), BoxLook(stone).plain(BoxFace::kBottom));
  place.addBox({side, height - kBase, side}, m * placedAt({0, (height + kBase) / 2 - 0.03f, 0}),
               BoxLook(stone).plain(BoxFace::kBottom).plain(BoxFace::kTop));
  place.addBox({width, 0.04f, width}, m * placedAt({0, height - 0.02f, 0}),
               BoxLook(stone).plain(BoxFace::kBottom).noShadow());
}

void addRod(PlaceBuilder& place, const glm::mat4& m, const glm::vec3& from, const glm::vec3& to, float radius,
            const SurfaceTexture& texture) {
  place.addTube({placeOf(m, from), placeOf(m, to)}, radius, texture);
}

}  // namespace

void addFramedPicture(PlaceBuilder& place, const FramedPicture& framed, const glm::mat4& m) {
  constexpr float kOut = 0.045f;
  constexpr float kOver = 0.012f;  // how far the frame reaches over the picture
  const glm::vec2 outer = framed.size + 2 * framed.frame;
  PlaceWall frame;
  frame.size = outer;
  frame.thickness = kOut + 0.01f;
  frame.openings = {{glm::vec2(framed.frame + kOver), outer - framed.frame - kOver}};
  frame.front = frame.back = frame.rim = framed.moulding;
  place.addWall(frame, m * placedAt({-outer.x / 2, -outer.y / 2, kOut}));
  place.addBox({framed.size.x, framed.size.y, 0.03f}, m * placedAt({0, 0, 0.005f}),
               BoxLook(framed.picture)
                   .plain(BoxFace::kBack)
                   .plain(BoxFace::kLeft)
                   .plain(BoxFace::kRight)
                   .plain(BoxFace::kTop)
                   .plain(BoxFace::kBottom)
                   .finer(0.62f)
                   .noShadow());
}

void addSheet(PlaceBuilder& place, const glm::vec2& size, const SurfaceTexture& print, const glm::mat4& m,
              float fineness) {
  BoxLook look = BoxLook(print).finer(fineness).noShadow();
  for (const BoxFace face : {BoxFace::kBack, BoxFace::kLeft, BoxFace::kRight, BoxFace::kTop, BoxFace::kBottom}) {
    look.plain(face);
  }
  place.addBox({size.x, size.y, 0.012f}, m * placedAt({0, 0, 0.001f}), look);
}

void addStatue(PlaceBuilder& place, float plinth, const SurfaceTexture& stone, const SurfaceTexture& figure,
               uint32_t seed, const glm::mat4& m) {
  addPlinth(place, 0.46f, plinth, stone, m);
  Random random(seed);
  const float lean = random.inRange(-0.06f, 0.06f);
  const float folds = 9 + static_cast<float>(random.below(5));
  const auto drape = [=](const glm::vec3& p) {
    const float angle = std::atan2(p.x, p.z);
    const float low = smoothEdge(1.05f, 0.2f, p.y);
    const float fold = std::sin(folds * angle + 5 * layeredNoise({p.y * 2, std::cos(angle)}, 3, seed));
    const float carved = layeredNoise({angle * 3, p.y * 9}, 3, seed + 1) * std::abs(std::cos(angle / 2));
    const float wide = 1 + 0.10f * low * fold + 0.05f * carved;
    return glm::vec3(p.x * wide + lean * std::sin(p.y * 2.5f), p.y, p.z * wide * 0.78f);
  };
  const glm::mat4 feet = m * placedAt({0, plinth - 0.012f, 0});
  place.addTurned({{0, 0},
                   {0.17f, 0},
                   {0.185f, 0.04f},
                   {0.165f, 0.35f},
                   {0.16f, 0.62f},
                   {0.135f, 0.82f},
                   {0.165f, 1.02f},
                   {0.185f, 1.14f},
                   {0.17f, 1.21f},
                   {0.085f, 1.26f},
                   {0.06f, 1.29f},
                   {0.055f, 1.36f},
                   {0, 1.37f}},
                  feet, figure, 0.9f, drape);
  const float head = lean * std::sin(1.42f * 2.5f);
  const glm::mat4 face = feet * placedAt({head, 1.45f, 0.01f}, random.inRange(-25, 25));
  place.addBall({0.082f, 0.118f, 0.1f}, face, figure, 0.8f);
  place.addBall({0.09f, 0.085f, 0.1f}, face * placedAt({0, 0.05f, -0.03f}), figure, 0.8f);
  place.addBall({0.014f, 0.03f, 0.022f}, face * placedAt({0, -0.012f, 0.1f}), figure, 0.6f);
  for (const float side : {-1.0f, 1.0f}) {
    const glm::vec3 shoulder(side * 0.17f + lean * 0.3f, 1.17f, 0);
    const glm::vec3 elbow(side * random.inRange(0.22f, 0.3f), random.inRange(0.88f, 1.0f), random.inRange(0, 0.1f));
    const glm::vec3 hand(side * random.inRange(0.05f, 0.24f), random.inRange(0.75f, 1.25f),
                         random.inRange(0.15f, 0.25f));
    place.addTube({placeOf(feet, shoulder), placeOf(feet, elbow)}, 0.048f, figure);
    place.addTube({placeOf(feet, elbow), placeOf(feet, hand)}, 0.036f, figure);
    place.addBall({0.052f, 0.052f, 0.052f}, feet * placedAt(elbow), figure);
    place.addBall({0.04f, 0.055f, 0.045f}, feet * placedAt(hand), figure);
    place.addBall({0.03f, 0.012f, 0.016f}, face * placedAt({side * 0.032f, 0.02f, 0.086f}), figure, 0.6f);
  }
  addShadow(place, feet, {-0.07f, 0.02f, -0.06f}, {0.07f, 1.22f, 0.06f});
  addShadow(place, face, {-0.04f, -0.07f, -0.05f}, {0.04f, 0.07f, 0.05f});
}

void addVase(PlaceBuilder& place, float plinth, const SurfaceTexture& stone, uint32_t seed, const glm::mat4& m) {
  addPlinth(place, 0.42f, plinth, stone, m);
  Random random(seed);
  const float belly = random.inRange(0.12f, 0.17f);
  const float neck = random.inRange(0.045f, 0.075f);
  const float height = random.inRange(0.38f, 0.55f);
  const glm::vec3 clay = bindingColor(seed) + 0.08f;
  const glm::vec3 paint = bindingColor(seed + 1) * 0.5f;
  const SurfaceTexture pattern = [=](const glm::vec2& p) {
    const float band = std::sin(p.y * 60 + 0.6f * std::sin(p.x * 45 + p.y * 4));
    const float figures = layeredNoise({p.x * 14, p.y * 18}, 3, seed + 2);
    const float part = std::max(smoothEdge(0.55f, 0.75f, band),
                                smoothEdge(0.12f, 0.2f, figures) * smoothEdge(0.1f, 0.0f, std::abs(p.y - 0.3f)));
    return glm::mix(clay, paint, part) * (1 + 0.12f * layeredNoise(p * 22.0f, 3, seed + 3));
  };
  const glm::mat4 foot = m * placedAt({0, plinth - 0.006f, 0});
  place.addTurned({{0, 0},
                   {belly * 0.55f, 0},
                   {belly * 0.6f, 0.02f},
                   {belly * 0.95f, height * 0.35f},
                   {belly, height * 0.5f},
                   {belly * 0.85f, height * 0.68f},
                   {neck, height * 0.82f},
                   {neck, height * 0.94f},
                   {neck * 1.5f, height},
                   {neck * 1.2f, height + 0.004f},
                   {neck * 0.8f, height * 0.93f},
                   {0, height * 0.9f}},
                  foot, pattern, 0.7f);
  addShadow(place, foot, {-belly * 0.35f, 0.02f, -belly * 0.35f}, {belly * 0.35f, height * 0.75f, belly * 0.35f});
}

void addBench(PlaceBuilder& place, float length, const glm::mat4& m, uint32_t seed) {
  const SurfaceTexture wood = woodTexture(palette::fromSrgbBytes(150, 104, 66), seed);
  const glm::vec3 leather = palette::fromSrgbBytes(94, 52, 38);
  place.addBox({length, 0.06f, 0.44f}, m * placedAt({0, 0.37f, 0}), BoxLook(wood).plain(BoxFace::kBottom));
  constexpr int kCushions = 3;
  const float cushion = length / kCushions;
  for (int i = 0; i < kCushions; ++i) {
    const float x = (static_cast<float>(i) - 1) * cushion;
    place.addBox(
        {cushion - 0.015f, 0.09f, 0.425f}, m * placedAt({x, 0.435f, 0}),
        BoxLook(clothTexture(leather, seed + 5 + static_cast<uint32_t>(i))).plain(BoxFace::kBottom).noShadow());
  }
  for (const float x : {-0.4f, 0.4f}) {
    for (const float z : {-0.16f, 0.16f}) {
      place.addBox({0.07f, 0.35f, 0.05f}, m * placedAt({x * length, 0.173f, z}),
                   BoxLook(wood).plain(BoxFace::kBottom).plain(BoxFace::kTop));
    }
  }
}

void addBarrierPost(PlaceBuilder& place, const glm::mat4& m, uint32_t seed) {
  const SurfaceTexture brass = metalTexture(palette::fromSrgbBytes(206, 164, 82), seed);
  place.addTurned({{0, -0.004f},
                   {0.15f, -0.004f},
                   {0.15f, 0.015f},
                   {0.04f, 0.035f},
                   {0.022f, 0.06f},
                   {0.022f, 0.86f},
                   {0.04f, 0.88f},
                   {0.045f, 0.92f},
                   {0.03f, 0.95f},
                   {0, 0.955f}},
                  m, brass);
}

void addTable(PlaceBuilder& place, const glm::vec3& size, const glm::vec3& color, const glm::mat4& m, uint32_t seed) {
  constexpr float kTop = 0.035f;
  const SurfaceTexture top = woodTexture(color, seed);
  place.addBox({size.x, kTop, size.z}, m * placedAt({0, size.y - kTop / 2, 0}),
               BoxLook(top).plain(BoxFace::kBottom).finer(0.9f));
  const glm::vec2 leg(size.x / 2 - 0.07f, size.z / 2 - 0.07f);
  for (const float x : {-leg.x, leg.x}) {
    for (const float z : {-leg.y, leg.y}) {
      place.addBox({0.06f, size.y - kTop + 0.01f, 0.06f}, m * placedAt({x, (size.y - kTop) / 2 + 0.001f, z}),
                   BoxLook(uprightWoodTexture(color * 0.85f, seed + 3)).plain(BoxFace::kBottom).plain(BoxFace::kTop));
    }
    place.addBox({0.025f, 0.08f, 2 * leg.y}, m * placedAt({x, size.y - kTop - 0.035f, 0}),
                 BoxLook(top).plain(BoxFace::kTop).noShadow());
  }
  place.addBox({2 * leg.x, 0.085f, 0.022f}, m * placedAt({0, size.y - kTop - 0.036f, -leg.y}),
               BoxLook(top).plain(BoxFace::kTop).noShadow());
}

void addChair(PlaceBuilder& place, const glm::vec3& color, const glm::mat4& m, uint32_t seed) {
  const SurfaceTexture wood = uprightWoodTexture(color, seed);
  place.addBox({0.42f, 0.03f, 0.42f}, m * placedAt({0, 0.45f, 0}),
               BoxLook(woodTexture(color, seed + 1)).plain(BoxFace::kBottom));
  place.addBox({0.39f, 0.03f, 0.39f}, m * placedAt({0, 0.475f, 0.005f}),
               BoxLook(clothTexture(bindingColor(seed), seed + 2)).plain(BoxFace::kBottom).noShadow());
  for (const float x : {-0.185f, 0.185f}) {
    for (const float z : {-0.185f, 0.185f}) {
      const float height = z < 0 ? 0.92f : 0.45f;
      place.addBox({0.036f, height, 0.036f}, m * placedAt({x, height / 2 - 0.002f, z}),
                   BoxLook(wood).plain(BoxFace::kBottom).noShadow());
    }
  }
  for (const float y : {0.62f, 0.74f, 0.86f}) {
    place.addBox({0.37f, 0.07f, 0.018f}, m * placedAt({0, y, -0.186f}),
                 BoxLook(woodTexture(color, seed + static_cast<uint32_t>(y * 100))).noShadow());
  }
  addShadow(place, m, {-0.18f, 0.6f, -0.19f}, {0.18f, 0.9f, -0.18f});
}

void addOfficeChair(PlaceBuilder& place, const glm::vec3& color, const glm::mat4& m, uint32_t seed) {
  const SurfaceTexture metal = metalTexture(glm::vec3(0.25f), seed);
  const SurfaceTexture black = plasticTexture(glm::vec3(0.06f), seed + 1);
  const SurfaceTexture cloth = clothTexture(color, seed + 2);
  for (int i = 0; i < 5; ++i) {
    const double angle = 2 * kPi * i / 5 + 0.3;
    const glm::vec3 out(std::sin(angle), 0, std::cos(angle));
    addRod(place, m, {0, 0.1f, 0}, out * 0.29f + glm::vec3(0, 0.075f, 0), 0.018f, metal);
    place.addBall(glm::vec3(0.032f), m * placedAt(out * 0.29f + glm::vec3(0, 0.031f, 0)), black);
  }
  addRod(place, m, {0, 0.08f, 0}, {0, 0.45f, 0}, 0.028f, metal);
  place.addBox({0.46f, 0.08f, 0.46f}, m * placedAt({0, 0.48f, 0}), BoxLook(cloth).plain(BoxFace::kBottom));
  place.addBox({0.44f, 0.56f, 0.06f}, m * placedAt({0, 0.86f, -0.235f}, -7, {1, 0, 0}), BoxLook(cloth));
  addRod(place, m, {0, 0.44f, -0.2f}, {0, 0.7f, -0.265f}, 0.02f, metal);
  for (const float x : {-0.25f, 0.25f}) {
    addRod(place, m, {x, 0.47f, 0}, {x, 0.675f, 0}, 0.014f, metal);
    addRod(place, m, {x * 0.6f, 0.47f, 0}, {x, 0.475f, 0}, 0.014f, metal);
    place.addBox({0.05f, 0.03f, 0.27f}, m * placedAt({x, 0.685f, -0.02f}), BoxLook(black).noShadow());
  }
}

void addDeskLamp(PlaceBuilder& place, const glm::vec3& shade, const glm::mat4& m, uint32_t seed) {
  const SurfaceTexture brass = metalTexture(palette::fromSrgbBytes(190, 150, 80), seed);
  place.addTurned(
      {{0, -0.003f}, {0.085f, -0.003f}, {0.085f, 0.012f}, {0.03f, 0.03f}, {0.01f, 0.05f}, {0.01f, 0.36f}, {0, 0.365f}},
      m, brass);
  const SurfaceTexture glass = leafTexture(shade, seed + 1);
  place.addTurned({{0, 0.33f}, {0.135f, 0.3f}, {0.14f, 0.305f}, {0.1f, 0.38f}, {0.05f, 0.425f}, {0, 0.43f}}, m, glass,
                  0.8f);
}

void addDeskThings(PlaceBuilder& place, float width, float height, const glm::mat4& worldFromDesk, uint32_t seed) {
  Random random(seed);
  const glm::mat4 m = worldFromDesk * placedAt({0, height, 0});
  const SurfaceTexture black = plasticTexture(glm::vec3(0.055f), seed);
  const auto own = [&] { return static_cast<uint32_t>(random.next() >> 33); };
  const glm::vec2 screen(0.53f, 0.31f);
  const glm::mat4 stand = m * placedAt({random.inRange(-0.12f, 0.12f), 0, -0.16f}, random.inRange(-10, 10));
  place.addBox({0.24f, 0.012f, 0.18f}, stand * placedAt({0, 0.0045f, 0}), BoxLook(black).plain(BoxFace::kBottom));
  place.addBox({0.05f, 0.2f, 0.022f}, stand * placedAt({0, 0.1f, -0.05f}), BoxLook(black).noShadow());
  place.addBox({screen.x + 0.03f, screen.y + 0.03f, 0.03f}, stand * placedAt({0, 0.3f, -0.03f}), BoxLook(black));
  place.addBox({screen.x, screen.y, 0.02f}, stand * placedAt({0, 0.3f, -0.0215f}),
               BoxLook(black)
                   .with(BoxFace::kFront, screenTexture(screen, own()))
                   .plain(BoxFace::kBack)
                   .finer(0.55f)
                   .stretched({1, 1, 4})
                   .glowing(0.95f)
                   .noShadow());
  const glm::vec2 keys(0.43f, 0.13f);
  const glm::mat4 hand = m * placedAt({random.inRange(-0.06f, 0.06f), 0, 0.14f}, random.inRange(-8, 8));
  place.addBox(
      {keys.x, 0.02f, keys.y}, hand * placedAt({0, 0.008f, 0}),
      BoxLook(black).with(BoxFace::kTop, keyboardTexture(keys, own())).plain(BoxFace::kBottom).finer(0.5f).noShadow());
  place.addBall({0.032f, 0.017f, 0.055f}, hand * placedAt({0.3f, 0.015f, 0}), black);
  for (int i = 0; i < 6; ++i) {
    const glm::vec2 sheet(0.21f, 0.297f);
    const float side = i % 2 == 0 ? -1.0f : 1.0f;
    const float x = side * random.inRange(0.34f, width / 2 - 0.14f);
    place.addBox({sheet.x, 0.006f + 0.004f * static_cast<float>(i), sheet.y},
                 m * placedAt({x, 0.001f + 0.002f * static_cast<float>(i), random.inRange(-0.08f, 0.16f)},
                              random.inRange(-35, 35)),
                 BoxLook(paperTexture(sheet, own())).plain(BoxFace::kBottom).finer(0.7f).noShadow());
  }
  place.addTurned({{0, -0.002f}, {0.038f, -0.002f}, {0.042f, 0.09f}, {0.038f, 0.091f}, {0.034f, 0.02f}, {0, 0.018f}},
                  m * placedAt({random.inRange(0.28f, 0.36f), 0, -0.2f}),
                  plasticTexture(bindingColor(own()) * 1.6f, own()));
  addBookPile(place, 2 + random.below(4), m * placedAt({-width / 2 + 0.2f, 0, -0.22f}, random.inRange(-15, 15)), own());
}

void addPottedPlant(PlaceBuilder& place, float height, const glm::mat4& m, uint32_t seed) {
  Random random(seed);
  const float pot = height * 0.28f;
  const float r = 0.5f * pot;
  place.addTurned({{0, -0.004f},
                   {r * 0.75f, -0.004f},
                   {r, pot},
                   {r * 0.88f, pot + 0.002f},
                   {r * 0.85f, pot * 0.86f},
                   {0, pot * 0.87f}},
                  m, leafTexture(palette::fromSrgbBytes(172, 92, 62), seed));
  addShadow(place, m, {-r * 0.5f, 0, -r * 0.5f}, {r * 0.5f, pot * 0.8f, r * 0.5f});
  addShadow(place, m, {-r * 0.4f, height * 0.6f, -r * 0.4f}, {r * 0.4f, height * 0.8f, r * 0.4f});
  const auto leaves = static_cast<int>(26 + height * 22);
  for (int i = 0; i < leaves; ++i) {
    const float turn = random.inRange(0, 360);
    const float reach = height * random.inRange(0.08f, 0.3f);
    const float up = random.inRange(pot * 1.3f, height);
    const auto angle = static_cast<float>(radiansFromDegrees(turn));
    const glm::vec3 tip(reach * std::sin(angle), up, reach * std::cos(angle));
    const glm::vec3 root(0.25f * r * std::sin(angle * 3), pot * 0.8f, 0.25f * r * std::cos(angle * 3));
    const SurfaceTexture green = leafTexture(palette::fromSrgbBytes(66, 116, 48) * random.inRange(0.7f, 1.6f),
                                             seed + 7 + static_cast<uint32_t>(i));
    place.addTube({placeOf(m, root), placeOf(m, (root + tip) * 0.5f + glm::vec3(0, 0.12f * up, 0)), placeOf(m, tip)},
                  0.0045f, green, 1.5f);
    const glm::mat4 leaf = m * placedAt(tip, turn) * placedAt({0, 0, 0}, random.inRange(-10, 60), {1, 0, 0});
    const float size = height * random.inRange(0.05f, 0.09f);
    place.addBall({size * 0.55f, 0.004f, size * 1.3f}, leaf * placedAt({0, 0, size}), green, 1.3f);
  }
}

}  // namespace ocelli
