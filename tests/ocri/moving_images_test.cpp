// Images of an eye that moves, which begin from what the last one knew.
#include <gtest/gtest.h>

#include <string_view>

#include "oc_core/base/parallel.h"
#include "oc_core/ocri/band_memory.h"
#include "oc_core/ocri/camera_choice.h"
#include "oc_core/ocri/coverage.h"
#include "oc_core/ocri/representation_kind.h"
#include "oc_core/ocri/union_mesh.h"
#include "oc_core/ocri/view_cell.h"
#include "oc_core/worlds/scene_source.h"
#include "tests/ocri/test_scenes.h"

namespace ocelli {
namespace {

constexpr int kMovingWidth = 240;
constexpr int kMovingHeight = 160;

const Mesh& statues() {
  static const Mesh kMesh = loadScene("builtin:statues,triangles=20000");
  return kMesh;
}

/// From a place on an arc, so many display radii aside.
PinholeCamera seenFromAside(float aside) {
  View view;
  view.eye = glm::normalize(glm::vec3(aside, 0.4f, 10)) * 10.0f;
  return {view, kMovingWidth, kMovingHeight};
}

MissingSamples missingOf(const ReferenceImages& images, const PinholeCamera& reference) {
  const Mesh mesh = unionMesh(images);
  MissingSamples missing;
  for (const View& view : ViewCell{}.interiorViews(reference.view(), 4, 19)) {
    const PinholeCamera camera(view, kMovingWidth, kMovingHeight);
    missing += countMissing(compareFrames(camera, positionImage(camera, statues()), positionImage(camera, mesh)));
  }
  return missing;
}

bool sameImages(const ReferenceImages& a, const ReferenceImages& b) {
  bool same = a.size() == b.size();
  for (size_t i = 0; same && i < a.size(); ++i) {
    same = a[i].t == b[i].t && a[i].held == b[i].held && a[i].color == b[i].color &&
           a[i].displacement == b[i].displacement && a[i].triangleBound == b[i].triangleBound;
  }
  return same;
}

TEST(MovingImages, TheFirstIsTheOneThatIsBuiltByItself) {
  for (const RepresentationKind& kind : representationKinds()) {
    if (!kind.images) {
      continue;
    }
    const CameraChoice camera = cameraChoice(kind.name);
    MovingImages moving(camera);
    const PinholeCamera reference = test::smallCamera();
    const Mesh scene = test::boxBeforeWall();
    EXPECT_TRUE(sameImages(moving.next(reference, scene), buildReferenceImages(camera, reference, scene))) << kind.name;
    EXPECT_EQ(moving.starts().images, 1u);
    EXPECT_EQ(moving.starts().cold, 1u);
    EXPECT_EQ(moving.remembers(), static_cast<bool>(kind.sequence)) << kind.name;
  }
}

TEST(MovingImages, WhereNothingIsRememberedEachIsTheOneThatIsBuiltByItself) {
  const CameraChoice camera = cameraChoice("eoc-h");
  MovingImages moving(camera);
  for (const float aside : {0.0f, 0.1f}) {
    EXPECT_TRUE(sameImages(moving.next(seenFromAside(aside), statues()),
                           buildReferenceImages(camera, seenFromAside(aside), statues())));
  }
  EXPECT_EQ(moving.starts().cold, 2u);
}

class RememberingImages : public ::testing::TestWithParam<const char*> {};

TEST_P(RememberingImages, StartColdOnceWhereAnEyeWalksAndLackNoMore) {
  const CameraChoice camera = cameraChoice(GetParam());
  MovingImages moving(camera);
  MissingSamples warm;
  MissingSamples cold;
  constexpr int kSteps = 24;
  for (int i = 0; i < kSteps; ++i) {
    const PinholeCamera reference = seenFromAside(0.04f * static_cast<float>(i));
    const ReferenceImages images = moving.next(reference, statues());
    if (i % 3 == 2) {
      warm += missingOf(images, reference);
      cold += missingOf(buildReferenceImages(camera, reference, statues()), reference);
    }
  }
  EXPECT_EQ(moving.starts().images, static_cast<size_t>(kSteps));
  EXPECT_EQ(moving.starts().cold, 1u);
  EXPECT_GT(cold.strict, 0u);
  EXPECT_LE(warm.strictRatio(), 1.1 * cold.strictRatio());
}

TEST_P(RememberingImages, StartColdAfterAJump) {
  const CameraChoice camera = cameraChoice(GetParam());
  MovingImages moving(camera);
  moving.next(seenFromAside(0), statues());
  moving.next(seenFromAside(0.04f), statues());
  EXPECT_EQ(moving.starts().cold, 1u);
  const PinholeCamera elsewhere = seenFromAside(25);
  EXPECT_TRUE(sameImages(moving.next(elsewhere, statues()), buildReferenceImages(camera, elsewhere, statues())));
  EXPECT_EQ(moving.starts().cold, 2u);
}

TEST_P(RememberingImages, MayChangeTheirSize) {
  MovingImages moving(cameraChoice(GetParam()));
  moving.next(seenFromAside(0), statues());
  moving.next(PinholeCamera(seenFromAside(0.04f).view(), kMovingWidth * 3 / 4, kMovingHeight * 3 / 4), statues());
  EXPECT_EQ(moving.starts().cold, 1u);
}

TEST_P(RememberingImages, AreTheSameWithAnyNumberOfThreads) {
  ReferenceImages last;
  for (const int threads : {1, 2, 7}) {
    setThreadCount(threads);
    MovingImages moving(cameraChoice(GetParam()));
    ReferenceImages images;
    for (int i = 0; i < 4; ++i) {
      images = moving.next(seenFromAside(0.05f * static_cast<float>(i)), statues());
    }
    EXPECT_TRUE(last.empty() || sameImages(images, last)) << threads;
    last = std::move(images);
  }
  setThreadCount(0);
}

std::vector<const char*> remembering() {
  std::vector<const char*> names;
  for (const RepresentationKind& kind : representationKinds()) {
    // The dissertation's variants have no feedback that could be remembered.
    if (kind.sequence && !std::string_view(kind.name).starts_with("ddoc-")) {
      names.push_back(kind.name);
    }
  }
  return names;
}

INSTANTIATE_TEST_SUITE_P(All, RememberingImages, ::testing::ValuesIn(remembering()),
                         [](const auto& named) { return std::string(named.param); });

// Without the memory, whole bands would bury what the reference view sees.
TEST(MovingImages, BandsThatDoHarmStayNarrow) {
  CameraChoice camera = cameraChoice("ddoc");
  MovingImages moving(camera);
  camera.ddoc.feedbackRounds = 0;
  size_t lostWithout = 0;
  size_t lost = 0;
  const auto lostBy = [&](const ReferenceImages& images, const PinholeCamera& reference) {
    return countMissing(compareFrames(reference, positionImage(reference, statues()),
                                      positionImage(reference, unionMesh(images))))
        .strict;
  };
  for (int i = 0; i < 12; ++i) {
    const PinholeCamera reference = seenFromAside(0.04f * static_cast<float>(i));
    lost += lostBy(moving.next(reference, statues()), reference);
    lostWithout += lostBy(buildReferenceImages(camera, reference, statues()), reference);
  }
  EXPECT_EQ(moving.starts().cold, 1u);
  EXPECT_GT(lostWithout, 0u);
  EXPECT_LT(2 * lost, lostWithout);
}

DistortionSplat splatAt(float u, float v, float near) {
  return {DepthEdge{{u, v}, {1, 0}, 1 / near, 1 / (near + 2)}, 8, 4};
}

TEST(BandMemory, FindsASilhouetteWhereItHasMovedTo) {
  const PinholeCamera before = seenFromAside(0);
  const PinholeCamera after = seenFromAside(0.7f);
  const DistortionSplat splat = splatAt(120.5f, 80.5f, 9);
  BandMemory memory;
  memory.remember(before, {splat}, {0.25f});
  const ImagePoint moved = *after.project(*before.unproject({120.5f, 80.5f, 9}));
  ASSERT_GT(std::abs(moved.u - 120.5f), 5);

  const auto kept = [&](float u, float v, float near) {
    return memory.recall(after, {splatAt(u, v, near)}).kept.front();
  };
  EXPECT_EQ(kept(moved.u, moved.v, moved.t), 0.25f);
  EXPECT_EQ(kept(moved.u + 1.5f, moved.v - 1.5f, moved.t), 0.25f);
  EXPECT_EQ(kept(moved.u + 4, moved.v, moved.t), 1);                           // too far away
  EXPECT_EQ(kept(moved.u, moved.v, moved.t + 4), 1);                           // another occluder
  EXPECT_EQ(memory.recall(before, {splatAt(moved.u, moved.v, 9)}).known, 0u);  // where it was it is not
  EXPECT_EQ(memory.recall(after, {splatAt(moved.u, moved.v, moved.t), splatAt(10, 10, 9)}).known, 1u);
}

TEST(BandMemory, KnowsTheLastImageAlone) {
  const PinholeCamera camera = seenFromAside(0);
  BandMemory memory;
  memory.remember(camera, {splatAt(30, 40, 9)}, {0.5f});
  memory.remember(camera, {splatAt(90, 40, 9)}, {0.75f});
  const BandMemory::Recalled recalled = memory.recall(camera, {splatAt(30, 40, 9), splatAt(90, 40, 9)});
  EXPECT_EQ(recalled.kept, (std::vector<float>{1, 0.75f}));
  EXPECT_EQ(recalled.known, 1u);
}

}  // namespace
}  // namespace ocelli
