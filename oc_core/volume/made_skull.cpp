// A head that is made, as a CT sees it, in Hounsfield units: skin, bones with eye sockets, jaws and teeth, a brain with
// its arteries, and behind the left temple an aneurysm that was closed with a coil of metal: what cameras may look for
// behind bone. It stands in for scans of people; nothing of it was measured.
#include <array>
#include <cstdint>
#include <glm/trigonometric.hpp>

#include "oc_core/volume/builtin_volume_list.h"
#include "oc_core/volume/made_volume.h"
#include "oc_core/volume/solid_distance.h"

namespace ocelli {
namespace {

using glm::vec3;

constexpr double kEdgeMillimetres = 240;
/// Over which a material begins, in voxels: by a smooth step, which is as steep in its middle as a straight ramp of
/// two. So gradients, which are taken over two voxels, do not change by steps from one voxel to the next.
constexpr float kRampVoxels = 3;

// Hounsfield units.
constexpr float kAir = -1000;
constexpr float kFat = -100;
constexpr float kFluid = 8;
constexpr float kWhiteMatter = 28;
constexpr float kSkin = 30;
constexpr float kGreyMatter = 38;
constexpr float kMuscle = 55;
constexpr float kDisc = 90;
constexpr float kBlood = 330;  ///< with contrast agent
constexpr float kSpongyBone = 450;
constexpr float kBone = 1100;
constexpr float kEnamel = 1700;
constexpr float kMetal = 3000;

// Millimetres in the frame of patients: x to the left, y to the back, z to the head; around the middle of the head.
constexpr vec3 kVaultCenter(0, 8, 36);
constexpr vec3 kVaultRadii(69, 88, 68);
constexpr float kVaultThickness = 6;
constexpr vec3 kOrbit(31, -72, 6);
constexpr float kOrbitRadius = 19;
constexpr vec3 kAneurysm(46, -12, 18);
constexpr float kAneurysmRadius = 9;

struct Tube {
  vec3 from;
  vec3 to;
  float radius;
};

/// Arteries of one side; the other mirrors them. The last piece leads to the aneurysm, on its side.
constexpr std::array<Tube, 7> kArteries{{{{16, 2, -125}, {15, -6, -30}, 3.2f},
                                         {{15, -6, -30}, {12, -18, 2}, 2.8f},
                                         {{12, -18, 2}, {30, -18, 8}, 2.4f},
                                         {{30, -18, 8}, {46, -12, 18}, 2.2f},
                                         {{46, -12, 18}, {57, 12, 36}, 1.9f},
                                         {{12, -18, 2}, {3, -40, 22}, 2.0f},
                                         {{3, -40, 22}, {3, -34, 70}, 1.7f}}};

/// Bones of one side of the face: brow, cheek and its arch, and the lower jaw.
constexpr std::array<Tube, 7> kFaceBones{{{{6, -86, 27}, {50, -66, 29}, 6},
                                          {{46, -72, -14}, {65, -40, -10}, 6},
                                          {{65, -40, -10}, {68, 2, -12}, 3.5f},
                                          {{52, -66, 22}, {54, -68, -10}, 4.5f},
                                          {{57, -4, -16}, {51, -12, -66}, 6},
                                          {{51, -12, -66}, {22, -76, -77}, 7.5f},
                                          {{22, -76, -77}, {0, -87, -79}, 8.5f}}};

template <size_t kCount>
float nearestTube(const vec3& p, const std::array<Tube, kCount>& tubes) {
  float distance = 1e9f;
  for (const Tube& tube : tubes) {
    distance = std::min(distance, solid::capsule(p, tube.from, tube.to, tube.radius));
  }
  return distance;
}

float skinDistance(const vec3& mirrored) {
  using namespace solid;
  float skin = ellipsoid(mirrored, {0, 6, 34}, {77, 96, 77});
  skin = smoothUnion(skin, ellipsoid(mirrored, {0, -40, -30}, {62, 56, 66}), 18);
  skin = smoothUnion(skin, ellipsoid(mirrored, {0, -60, -64}, {44, 42, 32}), 14);
  skin = smoothUnion(skin, capsule(mirrored, {0, 30, -30}, {0, 40, -160}, 52), 14);
  skin = smoothUnion(skin, ellipsoid(mirrored, {0, -98, -22}, {13, 15, 18}), 8);
  return smoothUnion(skin, ellipsoid(mirrored, {78, 12, -6}, {5, 15, 26}), 4);
}

/// Both rows of teeth: pegs along half an ellipse.
float toothDistance(const vec3& mirrored) {
  constexpr float kFirstDegrees = 5.5f;
  constexpr float kStepDegrees = 11.5f;
  if (mirrored.y > -40 || mirrored.z < -72 || mirrored.z > -40 || mirrored.x > 40) {
    return 1e9f;
  }
  const float degrees = glm::degrees(std::atan2(mirrored.x / 27, -(mirrored.y + 54) / 31));
  const float number = std::clamp(std::round((degrees - kFirstDegrees) / kStepDegrees), 0.0f, 6.0f);
  const float at = glm::radians(kFirstDegrees + kStepDegrees * number);
  const vec3 root(27 * std::sin(at), -54 - 31 * std::cos(at), 0);
  const float upper = solid::capsule(mirrored, root + vec3(0, 0, -46), root + vec3(0, 0, -54), 3.1f);
  return std::min(upper, solid::capsule(mirrored, root + vec3(0, 2, -59), root + vec3(0, 2, -67), 3.0f));
}

/// Vertebrae every 20 mm, with discs between them and an arch behind.
struct Spine {
  float bone;
  float disc;
};
Spine spineDistance(const vec3& p) {
  using namespace solid;
  constexpr float kPeriod = 20;
  const float top = p.z + 42;
  const float within = top - kPeriod * std::round(top / kPeriod);
  const float fromAxis = glm::length(glm::vec2(p.x, p.y - 34));
  const float below = top - 8;  // the column ends there
  const float column = both(fromAxis - 12, below);
  const float fromCanal = glm::length(glm::vec2(p.x, p.y - 54));
  const float arch = both(std::abs(fromCanal - 11) - 3, std::abs(within) - 5);
  const float process = box({p.x, p.y, within}, {0, 74, -2}, {3, 10, 3}, 2);
  return {std::max(std::min({both(column, std::abs(within) - 7.5f), arch, process}), below), column};
}

/// The coil in the aneurysm: rings in three planes.
float coilDistance(const vec3& p) {
  float coil = 1e9f;
  for (int axis = 0; axis < 3; ++axis) {
    coil = std::min(coil, solid::torus(p, kAneurysm, axis, 5, 1.7f));
  }
  return coil;
}

/// What a CT measures at a point; materials that meet in a voxel are mixed by their shares.
class HeadAt {
 public:
  HeadAt(const vec3& p, float spacing) : p_(p), mirrored_(std::abs(p.x), p.y, p.z), spacing_(spacing) {}

  float value() {
    const float skin = skinDistance(mirrored_);
    if (skin > kRampVoxels / 2 * spacing_) {
      return kAir;
    }
    paint(skin, kSkin);
    paint(skin + 2, kFat);
    paint(skin + 5, kMuscle);
    vault_ = solid::ellipsoid(p_, kVaultCenter, kVaultRadii);
    orbit_ = solid::sphere(mirrored_, kOrbit, kOrbitRadius);
    const bool isDeepInBrain = vault_ < -2 * kVaultThickness && orbit_ > 2 * kVaultThickness;
    if (!isDeepInBrain) {
      addVault();
      addFace(skin);
      addNeck();
    }
    addBrain();
    addArteries();
    return value_;
  }

 private:
  /// A material where `distance` is negative. Nothing of it is left half a ramp outside.
  void paint(float distance, float hounsfield) {
    const float share = solid::coverage(distance, kRampVoxels * spacing_);
    value_ = glm::mix(value_, hounsfield, share * share * (3 - 2 * share));
  }

  void addVault() {
    using namespace solid;
    // The spine's canal goes on through its base.
    const float hole = both(glm::length(glm::vec2(p_.x, p_.y - 50)) - 15, p_.z + 5);
    const float shell = without(without(vault_, vault_ + kVaultThickness), hole);
    paint(shell, kBone);
    paint(both(shell, std::abs(vault_ + kVaultThickness / 2) - 1.2f), kSpongyBone);
  }

  void addFace(float skin) {
    using namespace solid;
    // The upper jaw and what holds the nose, with air in them; the eye sockets are walls of bone that open forwards.
    const float nose = ellipsoid(p_, {0, -84, -22}, {11, 26, 17});
    const float sinus = sphere(mirrored_, {22, -66, -24}, 10.5f);
    float bone = ellipsoid(mirrored_, {0, -64, -28}, {38, 24, 27});
    bone = both(bone, p_.y + 40);
    bone = std::min(bone, capsule(p_, {0, -84, 16}, {0, -96, -6}, 4));
    bone = std::min(bone, nearestTube(mirrored_, kFaceBones));
    bone = std::min(bone, both(orbit_ - 2.5f, -(p_.y + 82)));
    paint(without(without(bone, both(nose, skin + 4)), orbit_), kBone);
    paint(both(std::min(sinus, nose), skin + 4), kAir);
    paint(both(orbit_, skin + 3), kFat);
    paint(sphere(mirrored_, kOrbit + vec3(0, -7, 1), 11.5f), kFluid + 10);
    paint(ellipsoid(mirrored_, kOrbit + vec3(0, -16, 1), {4.5f, 2, 4.5f}), kDisc);
    // The mouth and the throat.
    paint(capsule(p_, {0, -52, -40}, {0, -18, -60}, 6), kAir);
    paint(capsule(p_, {0, -18, -60}, {0, -12, -160}, 8), kAir);
    paint(toothDistance(mirrored_), kEnamel);
  }

  void addNeck() {
    const Spine spine = spineDistance(p_);
    paint(spine.disc, kDisc);
    paint(spine.bone, kSpongyBone + 200);
  }

  void addBrain() {
    using namespace solid;
    const float brain = without(vault_ + kVaultThickness, orbit_ - 3);
    if (brain > kRampVoxels / 2 * spacing_) {
      return;
    }
    paint(brain, kFluid);
    paint(brain + 1.5f, kGreyMatter);
    const float folds = 2.2f * std::sin(0.33f * p_.x) * std::sin(0.29f * p_.y) * std::sin(0.31f * p_.z);
    paint(brain + 6 + folds, kWhiteMatter);
    paint(ellipsoid(mirrored_, {10, 2, 42}, {6, 28, 9}), kFluid);
    paint(both(mirrored_.x - 1, both(brain, 20 - p_.z)), kFluid);
  }

  void addArteries() {
    using namespace solid;
    float blood = nearestTube(mirrored_, kArteries);
    blood = std::min(blood, capsule(p_, {0, 30, -60}, {0, 0, 2}, 2.6f));
    blood = std::min(blood, sphere(p_, kAneurysm, kAneurysmRadius));
    paint(blood, kBlood);
    if (sphere(p_, kAneurysm, kAneurysmRadius) < kRampVoxels / 2 * spacing_) {
      paint(coilDistance(p_), kMetal);
    }
  }

  vec3 p_;
  vec3 mirrored_;  ///< both sides are alike but for the aneurysm
  float spacing_;
  float vault_ = 0;
  float orbit_ = 0;
  float value_ = kAir;
};

BuiltinVolume makeSkull(const BuiltinValues& values) {
  const auto count = static_cast<int>(values.count("size"));
  VolumeGrid grid = gridAroundOrigin(glm::ivec3(count), kEdgeMillimetres / count);
  grid.unit = "mm";
  grid.isAnatomical = true;
  const vec3 first(grid.worldFromIndex[3]);
  const auto step = static_cast<float>(kEdgeMillimetres / count);
  ScalarVolume volume = madeVolume<int16_t>(grid, [&](int j, int k, std::span<int16_t> row) {
    for (size_t i = 0; i < row.size(); ++i) {
      const vec3 p = first + step * vec3(float(i), float(j), float(k));
      row[i] = static_cast<int16_t>(std::lround(HeadAt(p, step).value()));
    }
  });
  volume.setFacts({.modality = "CT", .valueUnit = "HU"});
  return {std::move(volume),
          {TransferFunction(
               {transferPoint(180, 0xb08d66, 0), transferPoint(280, 0xc9ab84, 0.12), transferPoint(600, 0xe6d3b3, 0.5),
                transferPoint(1200, 0xf7eddc, 0.85), transferPoint(1900, 0xfffaf0, 0.9),
                transferPoint(2200, 0xd55e00, 0.95), transferPoint(3000, 0xd55e00, 0.95)},
               1),
           {.isOn = true}}};
}

}  // namespace

BuiltinVolumeKind skullVolume() {
  return {"skull",
          "a head in CT, made: skin, bones, brain, and a coil of metal behind the left temple",
          {sizeParameter(256)},
          makeSkull};
}

}  // namespace ocelli
