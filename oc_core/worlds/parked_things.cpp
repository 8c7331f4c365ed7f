#include "oc_core/worlds/parked_things.h"

#include <array>
#include <cmath>
#include <functional>
#include <glm/common.hpp>
#include <glm/vec2.hpp>

#include "oc_core/worlds/placement.h"
#include "oc_core/worlds/solids.h"

namespace ocelli {
namespace {

constexpr double kTau = 6.283185307179586;

// Of the car, linear. Light enough that no tint makes them black on a display that emits light.
constexpr glm::vec3 kBody{0.9f, 0.9f, 0.9f};
constexpr glm::vec3 kGlass{0.10f, 0.115f, 0.14f};
constexpr glm::vec3 kTyre{0.10f, 0.10f, 0.105f};
constexpr glm::vec3 kHub{0.55f, 0.57f, 0.6f};
constexpr glm::vec3 kBumper{0.30f, 0.31f, 0.33f};
constexpr glm::vec3 kHeadlight{0.95f, 0.92f, 0.75f};
constexpr glm::vec3 kTailLight{0.75f, 0.12f, 0.10f};
// Of the barrel.
constexpr glm::vec3 kWood{0.34f, 0.16f, 0.06f};
constexpr glm::vec3 kDarkWood{0.22f, 0.10f, 0.035f};
constexpr glm::vec3 kHoop{0.10f, 0.11f, 0.12f};

/// The corners of a face, counter-clockwise seen from outside: u goes from the first to the second, v to the last.
using Face = std::array<glm::vec3, 4>;

/// A face divided by lines from 0 to 1 along u and v; each cell has vertices and a colour of its own.
void addCells(Mesh& mesh, const Face& face, const std::vector<float>& us, const std::vector<float>& vs,
              const std::function<glm::vec3(size_t i, size_t j)>& color) {
  const auto at = [&](float u, float v) {
    return glm::mix(glm::mix(face[0], face[1], u), glm::mix(face[3], face[2], u), v);
  };
  for (size_t j = 0; j + 1 < vs.size(); ++j) {
    for (size_t i = 0; i + 1 < us.size(); ++i) {
      const auto base = static_cast<uint32_t>(mesh.positions.size());
      for (const glm::vec3& corner :
           {at(us[i], vs[j]), at(us[i + 1], vs[j]), at(us[i + 1], vs[j + 1]), at(us[i], vs[j + 1])}) {
        mesh.positions.push_back(corner);
        mesh.colors.push_back(color(i, j));
      }
      mesh.triangles.push_back({base, base + 1, base + 2});
      mesh.triangles.push_back({base, base + 2, base + 3});
    }
  }
}

void addPainted(Mesh& car, Mesh part, const glm::vec3& color, const glm::mat4& place) {
  paint(part, color);
  append(car, part, place);
}

void addBlock(Mesh& car, const glm::vec3& center, const glm::vec3& half, const glm::vec3& color) {
  addPainted(car, makeBox(half), color, placedAt(center));
}

/// A cross-section of the body.
struct Station {
  float x, bottom, top, halfWidth;
};

/// Skin over cross-sections from the tail to the nose.
Mesh makeBody() {
  constexpr std::array<Station, 8> kStations{{{-2.10f, 0.42f, 0.80f, 0.70f},
                                              {-2.00f, 0.31f, 0.87f, 0.79f},
                                              {-1.40f, 0.26f, 0.90f, 0.85f},
                                              {0.00f, 0.25f, 0.88f, 0.86f},
                                              {0.95f, 0.26f, 0.85f, 0.86f},
                                              {1.75f, 0.28f, 0.75f, 0.81f},
                                              {2.03f, 0.34f, 0.66f, 0.73f},
                                              {2.10f, 0.42f, 0.60f, 0.64f}}};
  constexpr uint32_t kAround = 10;
  Mesh body;
  for (const Station& s : kStations) {
    const float height = s.top - s.bottom;
    // One side from the bottom to the top, then the other side downwards.
    const std::array<glm::vec2, 5> side{{{s.bottom, s.halfWidth - 0.07f},
                                         {s.bottom + 0.22f * height, s.halfWidth},
                                         {s.bottom + 0.60f * height, s.halfWidth + 0.015f},
                                         {s.top - 0.10f * height, s.halfWidth - 0.02f},
                                         {s.top, s.halfWidth - 0.10f}}};
    for (size_t i = 0; i < kAround; ++i) {
      const glm::vec2& p = side[i < 5 ? i : 9 - i];
      body.positions.push_back({s.x, p.x, i < 5 ? p.y : -p.y});
    }
  }
  for (uint32_t s = 0; s + 1 < kStations.size(); ++s) {
    for (uint32_t i = 0; i < kAround; ++i) {
      const uint32_t a = s * kAround + i;
      const uint32_t b = s * kAround + (i + 1) % kAround;
      body.triangles.push_back({a, a + kAround, b + kAround});
      body.triangles.push_back({a, b + kAround, b});
    }
  }
  constexpr uint32_t kNose = static_cast<uint32_t>(kStations.size() - 1) * kAround;
  for (uint32_t i = 1; i + 1 < kAround; ++i) {
    body.triangles.push_back({0, i, i + 1});
    body.triangles.push_back({kNose, kNose + i + 1, kNose + i});
  }
  return body;
}

/// The windows' frustum: its faces have frames and panes.
void addCabin(Mesh& car) {
  const auto corner = [](float x, float y, float z) { return glm::vec3(x, y, z); };
  constexpr float kLow = 0.83f;
  constexpr float kHigh = 1.40f;
  // Below and above, at the rear and in front.
  const glm::vec3 lowRear = corner(-1.80f, kLow, 0.75f);
  const glm::vec3 lowFront = corner(1.00f, kLow, 0.75f);
  const glm::vec3 highRear = corner(-1.20f, kHigh, 0.59f);
  const glm::vec3 highFront = corner(0.20f, kHigh, 0.59f);
  const auto other = [](glm::vec3 p) { return glm::vec3(p.x, p.y, -p.z); };
  const auto pane = [](size_t i, size_t j) { return i == 1 && j == 1 ? kGlass : kBody; };
  const auto sidePanes = [](size_t i, size_t j) { return (i == 1 || i == 3) && j == 1 ? kGlass : kBody; };
  const std::vector<float> across{0, 0.09f, 0.91f, 1};
  const std::vector<float> upwards{0, 0.14f, 0.88f, 1};
  addCells(car, {other(lowFront), other(highFront), highFront, lowFront}, upwards, across,
           [&](size_t i, size_t j) { return pane(i, j); });
  addCells(car, {lowRear, highRear, other(highRear), other(lowRear)}, upwards, across,
           [&](size_t i, size_t j) { return pane(i, j); });
  const std::vector<float> alongLeft{0, 0.10f, 0.47f, 0.53f, 0.90f, 1};
  addCells(car, {lowRear, lowFront, highFront, highRear}, alongLeft, upwards, sidePanes);
  addCells(car, {other(lowFront), other(lowRear), other(highRear), other(highFront)}, alongLeft, upwards, sidePanes);
  addCells(car, {highRear, highFront, other(highFront), other(highRear)}, {0, 1}, {0, 1},
           [](size_t, size_t) { return kBody; });
}

std::vector<glm::vec2> arc(float radius, int corners, double from, double to) {
  std::vector<glm::vec2> outline;
  for (int i = 0; i < corners; ++i) {
    const double angle = from + (to - from) * i / corners;
    outline.emplace_back(radius * static_cast<float>(std::cos(angle)), radius * static_cast<float>(std::sin(angle)));
  }
  return outline;
}

void addWheels(Mesh& car) {
  constexpr float kRadius = 0.33f;
  for (const float x : {-1.30f, 1.30f}) {
    for (const float side : {-1.0f, 1.0f}) {
      const auto at = [&](float z) { return placedAt({x, kRadius, side * z}); };
      addPainted(car, makePrism(arc(0.41f, 16, 0, kTau / 2 * 16 / 15), 0.03f), kTyre, at(0.855f));
      addPainted(car, makePrism(arc(kRadius, 28, 0, kTau), 0.11f), kTyre, at(0.81f));
      addPainted(car, makePrism(arc(0.20f, 20, 0, kTau), 0.02f), kHub, at(0.915f));
    }
  }
}

/// A bar that stands out on two short arms, with bent ends.
void addBumper(Mesh& car, float side) {
  constexpr float kOut = 2.26f;
  addBlock(car, {side * kOut, 0.47f, 0}, {0.05f, 0.085f, 0.74f}, kBumper);
  for (const float z : {-1.0f, 1.0f}) {
    addPainted(car, makeBox({0.05f, 0.085f, 0.14f}), kBumper,
               placedAt({side * (kOut - 0.06f), 0.47f, z * 0.80f}, static_cast<double>(side * z) * 45));
    addBlock(car, {side * 2.15f, 0.47f, z * 0.40f}, {0.10f, 0.04f, 0.05f}, kTyre);
  }
}

void addLights(Mesh& car) {
  for (const float z : {-1.0f, 1.0f}) {
    addBlock(car, {2.06f, 0.585f, z * 0.50f}, {0.05f, 0.055f, 0.13f}, kHeadlight);
    addBlock(car, {-2.09f, 0.70f, z * 0.53f}, {0.03f, 0.06f, 0.14f}, kTailLight);
    addBlock(car, {0.74f, 0.93f, z * 0.90f}, {0.06f, 0.06f, 0.09f}, kBody);  // side mirrors
  }
  addBlock(car, {-2.32f, 0.47f, 0}, {0.012f, 0.06f, 0.24f}, kBody);  // number plate
}

/// A smooth rise from 0 at the ends to 1 in the middle.
float bulgeAt(float y) {
  const float x = 2 * y / 0.9f - 1;
  return 1 - x * x;
}

}  // namespace

Mesh makeCar() {
  Mesh car;
  addPainted(car, makeBody(), kBody, glm::mat4(1));
  addCabin(car);
  addWheels(car);
  addBumper(car, -1);
  addBumper(car, 1);
  addLights(car);
  return car;
}

Mesh makeBarrel() {
  constexpr float kHeight = 0.9f;
  constexpr int kStaves = 24;
  struct Ring {
    float radius, height;
    glm::vec3 color;  ///< of what goes up from it
  };
  const auto side = [](float y, float out) { return 0.28f + 0.075f * bulgeAt(y) + out; };
  std::vector<Ring> rings{{0, 0.04f, kWood}, {0.25f, 0.04f, kDarkWood}, {0.25f, 0, kDarkWood}};
  const std::array<glm::vec2, 4> hoops{{{0.05f, 0.11f}, {0.25f, 0.30f}, {0.60f, 0.65f}, {0.79f, 0.85f}}};
  constexpr float kOut = 0.016f;
  constexpr int kBetween = 3;
  float from = 0;
  for (size_t i = 0; i <= hoops.size(); ++i) {
    const float to = i < hoops.size() ? hoops[i].x : kHeight;
    for (int k = 0; k < kBetween; ++k) {
      const float y = from + (to - from) * static_cast<float>(k) / kBetween;
      rings.push_back({side(y, 0), y, kWood});
    }
    if (i < hoops.size()) {
      rings.push_back({side(to, 0), to, kHoop});
      rings.push_back({side(to, kOut), to, kHoop});
      rings.push_back({side(hoops[i].y, kOut), hoops[i].y, kHoop});
      from = hoops[i].y;
    }
  }
  rings.push_back({side(kHeight, 0), kHeight, kDarkWood});
  rings.push_back({0.25f, kHeight, kDarkWood});
  rings.push_back({0.25f, kHeight - 0.04f, kWood});
  rings.push_back({0, kHeight - 0.04f, kWood});
  Mesh barrel;
  for (int stave = 0; stave < kStaves; ++stave) {
    const auto around = [&](const Ring& ring, int end) {
      const double angle = kTau * end / kStaves;
      return glm::vec3(ring.radius * static_cast<float>(std::cos(angle)), ring.height,
                       -ring.radius * static_cast<float>(std::sin(angle)));
    };
    const float shade = stave % 2 == 0 ? 1.0f : stave % 3 == 0 ? 0.72f : 0.85f;
    for (size_t r = 0; r + 1 < rings.size(); ++r) {
      const Ring& low = rings[r];
      const Ring& high = rings[r + 1];
      const glm::vec3 color = low.color == kHoop ? kHoop : low.color * shade;
      addCells(barrel, {around(low, stave), around(low, stave + 1), around(high, stave + 1), around(high, stave)},
               {0, 1}, {0, 1}, [&](size_t, size_t) { return color; });
    }
  }
  return barrel;
}

}  // namespace ocelli
