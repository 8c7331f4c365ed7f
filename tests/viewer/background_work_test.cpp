#include "display_sim/viewer/background_work.h"

#include <gtest/gtest.h>

#include "oc_core/base/error.h"
#include "tests/base/temporary_folder.h"

namespace ocelli {
namespace {

ViewerState someState(const std::string& source = "builtin:fence", const std::string& camera = "di") {
  return viewerState(source, {}, cameraChoice(camera), View{}, 72, 48, "test");
}

/// All that has come in, one over the other.
struct Taken {
  WorkResult all;
  std::vector<WorkStep> steps;
  std::vector<WorkStep> failed;
};

Taken takeAll(BackgroundWork& work) {
  work.waitUntilIdle();
  Taken taken;
  while (const auto result = work.take()) {
    taken.steps.push_back(result->step);
    if (result->error) {
      taken.failed.push_back(result->step);
      taken.all.error = result->error;
    }
    taken.all.scene = result->scene ? result->scene : taken.all.scene;
    taken.all.camera = result->camera ? result->camera : taken.all.camera;
    taken.all.rays = result->rays ? result->rays : taken.all.rays;
    taken.all.volume = result->volume ? result->volume : taken.all.volume;
  }
  return taken;
}

TEST(BackgroundWork, makesEverythingThatIsWanted) {
  BackgroundWork work;
  EXPECT_FALSE(work.status().busy);
  work.want(someState().work);
  const Taken taken = takeAll(work);
  EXPECT_FALSE(work.status().busy);
  EXPECT_TRUE(taken.failed.empty());
  ASSERT_TRUE(taken.all.scene && taken.all.camera && taken.all.volume && taken.all.rays);
  EXPECT_EQ(taken.all.scene->mesh.triangles.size(), loadScene("builtin:fence").triangles.size());
  EXPECT_GT(taken.all.camera->representation.sampleCount(), 100U);
  EXPECT_EQ(taken.all.volume->litVoxels, taken.all.volume->volume.litVoxels());
  EXPECT_GT(taken.all.volume->litVoxels, 0U);
}

TEST(BackgroundWork, theSameWishIsNotMadeTwice) {
  BackgroundWork work;
  work.want(someState().work);
  takeAll(work);
  work.want(someState().work);
  EXPECT_TRUE(takeAll(work).steps.empty());
}

TEST(BackgroundWork, makesOnlyWhatHasChanged) {
  BackgroundWork work;
  ViewerState state = someState();
  work.want(state.work);
  takeAll(work);
  chooseProfile(state, "vortex");
  work.want(state.work);
  EXPECT_EQ(takeAll(work).steps, std::vector{WorkStep::kVolume});
  chooseCamera(state, "rppc");
  work.want(state.work);
  EXPECT_EQ(takeAll(work).steps, (std::vector{WorkStep::kCamera, WorkStep::kVolume, WorkStep::kRays}));
}

TEST(BackgroundWork, theNewestOfManyWishesIsTheOneThatStays) {
  BackgroundWork work;
  ViewerState state = someState();
  for (const char* source : {"builtin:statues", "builtin:doors", "builtin:teapot", "builtin:boxes"}) {
    openScene(state, source);
    chooseCamera(state, "cell");
    work.want(state.work);
  }
  const Taken taken = takeAll(work);
  ASSERT_TRUE(taken.all.scene && taken.all.camera && taken.all.volume && taken.all.rays);
  EXPECT_EQ(taken.all.scene->source, "builtin:boxes");
  const Mesh boxes = loadScene("builtin:boxes");
  const auto expected = buildRepresentation(state.work.camera, PinholeCamera(View{}, 72, 48), boxes);
  EXPECT_EQ(taken.all.camera->representation.mesh.positions, expected.mesh.positions);
}

TEST(BackgroundWork, aSceneOfTrianglesFollowsOneOfPointsOfAWidth) {
  const test::TemporaryFolder folder;
  const std::string points = folder.write("points.xyz", "0 0 0\n1 0 0\n0 1 0\n1 1 0\n").string();
  BackgroundWork work;
  ViewerState state = someState(points);
  state.work.sceneOptions.points.width = 0.25;
  work.want(state.work);
  const Taken first = takeAll(work);
  ASSERT_TRUE(first.all.scene);
  EXPECT_EQ(first.all.scene->points.width, 0.25);
  openScene(state, "builtin:fence");
  work.want(state.work);
  const Taken next = takeAll(work);
  EXPECT_TRUE(next.failed.empty());
  ASSERT_TRUE(next.all.scene);
  EXPECT_EQ(next.all.scene->source, "builtin:fence");
}

TEST(BackgroundWork, aBrokenSceneIsAnErrorAndTheOldOneStands) {
  BackgroundWork work;
  ViewerState state = someState();
  work.want(state.work);
  takeAll(work);
  const uint64_t good = state.work.sceneRevision;
  openScene(state, "no-such-file.obj");
  work.want(state.work);
  const Taken broken = takeAll(work);
  EXPECT_EQ(broken.failed, std::vector{WorkStep::kScene});
  EXPECT_THROW(std::rethrow_exception(broken.all.error), InputError);
  // Back to what stands, then on with another camera of it: nothing is loaded again.
  state.work.sceneRevision = good;
  chooseCamera(state, "rppc");
  work.want(state.work);
  const Taken after = takeAll(work);
  EXPECT_TRUE(after.failed.empty());
  EXPECT_FALSE(after.all.scene);
  EXPECT_TRUE(after.all.camera);
}

TEST(BackgroundWork, aCameraThatCannotBeBuiltLeavesTheScene) {
  BackgroundWork work;
  ViewerState state = someState("builtin:teapot");
  View inside;
  inside.eye = {0, 0, 0.05f};
  inside.fovVerticalDegrees = 50;
  chooseReference(state, inside);
  work.want(state.work);
  const Taken taken = takeAll(work);
  EXPECT_TRUE(taken.all.scene);
  EXPECT_EQ(taken.failed, std::vector{WorkStep::kCamera});
  chooseReference(state, View{});
  work.want(state.work);
  EXPECT_TRUE(takeAll(work).all.camera);
}

TEST(BackgroundWork, canBeLeftInTheMiddle) {
  for (int i = 0; i < 5; ++i) {
    BackgroundWork work;
    work.want(someState("builtin:statues", "cell").work);
  }
}

}  // namespace
}  // namespace ocelli
