#include "oc_core/ocri/harm_meter.h"

#include <gtest/gtest.h>

#include "oc_core/ocri/image_mesh.h"
#include "oc_core/render/rasterize.h"
#include "tests/ocri/test_scenes.h"

namespace ocelli {
namespace {

using test::kBoxHalf;
using test::kHeight;
using test::kWidth;
using test::smallCamera;

/// The box's right side, at column 55, as a column of splats with these bands. Where it is `pushed`, four rows of the
/// map push the wall by ten pixels, behind the box.
struct SeenScene {
  explicit SeenScene(float hidden, float room, bool pushed = false) {
    for (int y = 22; y < 38; ++y) {
      splats.push_back({{{55, static_cast<float>(y) + 0.5f}, {1, 0}, 1 / 9.3f, 1 / 10.9f}, hidden, room});
    }
    owners = claimPixels(splats, kWidth, kHeight);
    DistortionMap map = finalizeMap(splats, owners, DistortionMap::Lookup::kBilinear);
    for (int y = 28; y < 32 && pushed; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        if (owners(x, y) >= 0) {
          map.samples()(x, y).displacement = {-10, 0};
        }
      }
    }
    camera.emplace(pinhole, map);
    part = displacedPart(*camera, mesh);
  }
  HarmMeter meter() const { return {pinhole, mesh, seen, part, {}}; }

  PinholeCamera pinhole = smallCamera();
  Mesh mesh = test::boxBeforeWall();
  FragmentImage seen = rasterize(pinhole, mesh);
  std::vector<DistortionSplat> splats;
  SplatOwners owners;
  std::optional<DdocCamera> camera;
  TrianglePart part;
};

/// The slow reference: all of the image against all of the view.
size_t missingAtReference(const SeenScene& scene) {
  const ReferenceImage image = referenceImage(rasterize(*scene.camera, scene.mesh), scene.mesh, scene.pinhole, "ddoc");
  return countMissing(compareFrames(scene.pinhole, positionImage(scene.pinhole, scene.mesh),
                                    positionImage(scene.pinhole, imageMesh(image))))
      .strict;
}

TEST(HarmMeter, nothingIsLostWhereNothingMoves) {
  const SeenScene scene(0, 0);
  const Harm harm = scene.meter().measure(*scene.camera, scene.splats, scene.owners);
  EXPECT_EQ(harm.missing, 0u);
  EXPECT_EQ(harm.ofSplats, std::vector<int>(scene.splats.size(), 0));
}

TEST(HarmMeter, countsWhatTheReferenceViewLacks) {
  for (const bool pushed : {false, true}) {
    const SeenScene scene(10, 10, pushed);
    const size_t expected = missingAtReference(scene);
    // Ten columns of the two middle rows, less the rims; others have neighbours a pixel away.
    EXPECT_EQ(expected >= 14, pushed);
    HarmMeter meter = scene.meter();
    const Harm first = meter.measure(*scene.camera, scene.splats, scene.owners);
    EXPECT_EQ(first.missing, expected);
    // The second time it draws the surfaces of the first image instead of the scene, resampled: good enough to blame by
    // where it finds no harm where there is none, and half of it at the least.
    const Harm second = meter.measure(*scene.camera, scene.splats, scene.owners);
    EXPECT_GE(2 * second.missing, expected);
    EXPECT_LE(second.missing, 2 * expected);
  }
}

TEST(HarmMeter, blamesTheSplatsThatBury) {
  const SeenScene scene(10, 10, true);
  const Harm harm = scene.meter().measure(*scene.camera, scene.splats, scene.owners);
  for (size_t i = 0; i < scene.splats.size(); ++i) {
    const float y = scene.splats[i].edge.position.y;
    if (y > 29 && y < 31) {
      EXPECT_GT(harm.ofSplats[i], 0) << y;
    } else if (y < 26 || y > 34) {
      EXPECT_EQ(harm.ofSplats[i], 0) << y;
    }
  }
}

TEST(HarmMeter, emptyViewLacksNothing) {
  const PinholeCamera pinhole = smallCamera();
  const Mesh nothing;
  const FragmentImage seen = rasterize(pinhole, nothing);
  const DdocCamera camera(pinhole, DistortionMap(kWidth, kHeight, DistortionMap::Lookup::kBilinear));
  const TrianglePart part;
  HarmMeter meter(pinhole, nothing, seen, part, {});
  EXPECT_EQ(meter.measure(camera, {}, SplatOwners(kWidth, kHeight, -1)).missing, 0u);
}

}  // namespace
}  // namespace ocelli
