// An engine block that is made: two cylinders cast in aluminium, with steel sleeves, pistons, valves and a crankshaft
// within. It stands in for the CT of an engine that papers on volumes show, of the same size in voxels; nothing of it
// was measured.
#include <cstdint>

#include "oc_core/base/conventions.h"
#include "oc_core/volume/builtin_volume_list.h"
#include "oc_core/volume/made_volume.h"
#include "oc_core/volume/solid_distance.h"

namespace ocelli {
namespace {

// Densities, of 8 bits.
constexpr float kAluminium = 120;
constexpr float kSteel = 230;

/// Voxels along z, of 256 along x and y.
constexpr int kDepthOf256 = 110;

// The block lies within 1 along x and y and 0.43 along z, y up. Both cylinders stand along y.
constexpr float kCylinderX = 0.38f;
constexpr float kCrankY = -0.6f;
constexpr float kBore = 0.25f;

/// Both halves are alike but for the height of their pistons.
float pistonHeight(float x) {
  return x < 0 ? 0.12f : -0.16f;
}

float castingDistance(const glm::vec3& p) {
  using namespace solid;
  const glm::vec3 half(std::abs(p.x), p.y, p.z);
  const glm::vec3 fromCylinder(half.x - kCylinderX, p.y, p.z);
  const float fromAxis = glm::length(glm::vec2(fromCylinder.x, fromCylinder.z));

  float casting = box(half, {0, -0.1f, 0}, {0.8f, 0.52f, 0.38f}, 0.06f);
  casting = std::min(casting, box(half, {0, -0.72f, 0}, {0.92f, 0.08f, 0.41f}, 0.03f));
  casting = std::min(casting, box(half, {0, 0.58f, 0}, {0.8f, 0.15f, 0.36f}, 0.04f));
  // Ports to both sides, the intake above the exhaust, and the pump at one end.
  const float fromIntake = glm::length(glm::vec2(fromCylinder.x, p.y - 0.6f));
  const float fromExhaust = glm::length(glm::vec2(fromCylinder.x, p.y - 0.52f));
  casting = std::min(casting, cylinder(fromIntake, p.z - 0.33f, 0.12f, 0.09f));
  casting = std::min(casting, cylinder(fromExhaust, p.z + 0.33f, 0.12f, 0.09f));
  const float fromPump = glm::length(glm::vec2(p.y - 0.05f, p.z));
  casting = std::min(casting, cylinder(fromPump, p.x - 0.85f, 0.15f, 0.1f));
  // Ribs along the flanks.
  casting = std::min(casting, box({half.x, p.y, std::abs(p.z)}, {0, -0.3f, 0.39f}, {0.7f, 0.025f, 0.025f}, 0.01f));

  // What is hollow: bores, the crankcase, water around the bores, ports, bolts.
  casting = without(casting, cylinder(fromAxis, p.y + 0.15f, kBore, 0.55f));
  casting = without(casting, ellipsoid(half, {kCylinderX, 0.4f, 0}, {0.2f, 0.09f, 0.2f}));
  casting = without(casting, cylinder(glm::length(glm::vec2(p.y - kCrankY, p.z)), p.x, 0.26f, 0.72f));
  const float aroundBore = both(std::abs(fromAxis - 0.315f) - 0.018f, std::abs(p.y - 0.02f) - 0.27f);
  casting = without(casting, aroundBore);
  casting = without(casting, capsule(half, {kCylinderX, 0.6f, 0.6f}, {kCylinderX, 0.44f, 0.1f}, 0.075f));
  casting = without(casting, capsule(half, {kCylinderX, 0.52f, -0.6f}, {kCylinderX, 0.44f, -0.1f}, 0.075f));
  casting = without(casting, cylinder(fromPump, p.x - 0.85f, 0.1f, 0.2f));
  const glm::vec2 fromBolt(std::min(std::abs(half.x - 0.72f), half.x), std::abs(p.z) - 0.26f);
  casting = without(casting, glm::length(fromBolt) - 0.03f);

  // Pistons are cast too.
  const float piston = cylinder(fromAxis, p.y - pistonHeight(p.x), kBore - 0.012f, 0.11f);
  const float hollow = cylinder(fromAxis, p.y - pistonHeight(p.x) + 0.05f, kBore - 0.05f, 0.11f);
  return std::min(casting, without(piston, hollow));
}

float steelDistance(const glm::vec3& p) {
  using namespace solid;
  const float side = p.x < 0 ? -1.0f : 1.0f;
  const glm::vec3 half(std::abs(p.x), p.y, p.z);
  const glm::vec3 fromCylinder(half.x - kCylinderX, p.y, p.z);
  const float fromAxis = glm::length(glm::vec2(fromCylinder.x, fromCylinder.z));
  const float pin = kCrankY + (side < 0 ? 0.12f : -0.12f);

  float steel = both(std::abs(fromAxis - kBore - 0.016f) - 0.016f, std::abs(p.y + 0.05f) - 0.4f);
  // The crankshaft: main journal, webs and pins.
  steel = std::min(steel, capsule(p, {-0.95f, kCrankY, 0}, {-0.58f, kCrankY, 0}, 0.065f));
  steel = std::min(steel, capsule(p, {-0.18f, kCrankY, 0}, {0.18f, kCrankY, 0}, 0.065f));
  steel = std::min(steel, capsule(p, {0.58f, kCrankY, 0}, {0.95f, kCrankY, 0}, 0.065f));
  const float fromShaft = glm::length(glm::vec2(p.y - 0.5f * (kCrankY + pin), p.z));
  steel = std::min(steel, cylinder(fromShaft, std::abs(fromCylinder.x) - 0.15f, 0.16f, 0.03f));
  steel = std::min(steel, capsule(half, {kCylinderX - 0.16f, pin, 0}, {kCylinderX + 0.16f, pin, 0}, 0.05f));
  // Connecting rods from the pins to the pistons, and the pistons' own pins.
  const float piston = pistonHeight(p.x);
  steel = std::min(steel, capsule(half, {kCylinderX, pin, 0}, {kCylinderX, piston, 0}, 0.035f));
  steel = std::min(steel, capsule(half, {kCylinderX - 0.15f, piston, 0}, {kCylinderX + 0.15f, piston, 0}, 0.03f));
  // Two valves for each cylinder: head and stem.
  const glm::vec2 fromStem(fromCylinder.x, std::abs(p.z) - 0.11f);
  const float stem = glm::length(fromStem);
  steel = std::min(steel, cylinder(stem, p.y - 0.43f, 0.07f, 0.014f));
  return std::min(steel, cylinder(stem, p.y - 0.62f, 0.016f, 0.2f));
}

BuiltinVolume makeEngine(const BuiltinValues& values) {
  const auto count = static_cast<int>(values.count("size"));
  const double spacing = 2.0 / count;
  const VolumeGrid grid = gridAroundOrigin({count, count, (count * kDepthOf256 + 128) / 256}, spacing);
  const glm::vec3 first(grid.worldFromIndex[3]);
  const auto step = static_cast<float>(spacing);
  ScalarVolume volume = madeVolume<uint8_t>(grid, [&](int j, int k, std::span<uint8_t> row) {
    for (size_t i = 0; i < row.size(); ++i) {
      const glm::vec3 p = first + step * glm::vec3(float(i), float(j), float(k));
      const float density = std::max(kAluminium * solid::coverage(castingDistance(p), step),
                                     kSteel * solid::coverage(steelDistance(p), step));
      row[i] = static_cast<uint8_t>(std::lround(density));
    }
  });
  return {std::move(volume),
          {TransferFunction(
               {transferPoint(40, 0x8c9aa8, 0), transferPoint(90, 0xa9b4bf, 0.03), transferPoint(125, 0xc3ccd4, 0.04),
                transferPoint(150, 0xd55e00, 0), transferPoint(195, 0xd55e00, 0.5), transferPoint(255, 0xf2a65e, 0.9)},
               2.0 / 256),
           {.isOn = true}}};
}

}  // namespace

BuiltinVolumeKind engineVolume() {
  return {"engine",
          "an engine block with two cylinders, pistons and a crankshaft, made: it stands in for the CT of one",
          {sizeParameter(256)},
          makeEngine};
}

}  // namespace ocelli
