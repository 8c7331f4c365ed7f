#include "oc_core/remote/remote_scene.h"

#include <gtest/gtest.h>

#include <thread>

#include "oc_core/render/rasterize_gpc.h"
#include "oc_core/worlds/scene_source.h"

namespace ocelli {
namespace {

const RemoteScene& teapots() {
  static const RemoteScene scene(loadScene("builtin:statues"), "builtin:statues");
  return scene;
}

RemotePlan smallPlan() {
  RemoteSettings settings;
  return planRemoteImage({.sequence = 0, .view = {}, .screen = {160, 90}}, settings);
}

TEST(RemoteScene, DrawsWhatTheRasteriserDraws) {
  const RemotePlan plan = smallPlan();
  const ReferenceImage image = teapots().draw(plan);
  const FragmentImage fragments = rasterizeGpc({plan.reference, plan.layout}, teapots().mesh());
  size_t same = 0;
  for (size_t i = 0; i < fragments.size(); ++i) {
    same +=
        fragments[i].covered() == (image.held[i] != 0) && std::abs(fragments[i].t - image.t[i]) <= 1e-3f * image.t[i];
  }
  // As elsewhere (tests/render/technique_matrix_test.cpp): all but pixels at edges, where the two round differently.
  EXPECT_GT(same, fragments.size() * 995 / 1000);
}

TEST(RemoteScene, AveragesColoursAndKeepsDepths) {
  const RemotePlan plan = smallPlan();
  const ReferenceImage one = teapots().draw(plan, 1);
  const ReferenceImage nine = teapots().draw(plan, 3);
  EXPECT_EQ(one.t, nine.t);
  EXPECT_EQ(one.held, nine.held);
  // At the outlines a pixel is part of both sides: neither black nor as bright as what it shows.
  size_t mixed = 0;
  for (size_t i = 0; i < one.color.size(); ++i) {
    mixed += one.held[i] == 0 && nine.color[i] != glm::vec3(0);
  }
  EXPECT_GT(mixed, 20u);
}

TEST(RemoteScene, AnswersManyThreadsAlike) {
  const RemoteRequest request{.sequence = 4, .view = {}, .screen = {96, 64}};
  const RemoteImage alone = teapots().answer(request, {}, 9);
  std::vector<RemoteImage> together(4);
  std::vector<std::thread> threads;
  for (RemoteImage& each : together) {
    threads.emplace_back([&] { each = teapots().answer(request, {}, 9); });
  }
  for (std::thread& thread : threads) {
    thread.join();
  }
  for (const RemoteImage& each : together) {
    EXPECT_EQ(each.color, alone.color);
    EXPECT_EQ(each.depth, alone.depth);
    EXPECT_EQ(each.sequence, 4u);
  }
}

TEST(RemoteScene, TellsOfItself) {
  EXPECT_EQ(teapots().name(), "builtin:statues");
  EXPECT_FALSE(teapots().bounds().empty());
  EXPECT_TRUE(contains(Box{glm::vec3(-1.01f), glm::vec3(1.01f)}, teapots().bounds().upper));  // fitted
}

}  // namespace
}  // namespace ocelli
