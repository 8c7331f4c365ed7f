#include "oc_core/explore_window/explorer_window_model.h"

#include <gtest/gtest.h>

#include <set>

#include "oc_core/base/error.h"
#include "oc_core/explore_window/explorer_plan.h"
#include "oc_core/worlds/scene_source.h"

namespace ocelli {
namespace {

constexpr const char* kSmallMaze = "builtin:maze,columns=3,rows=3";

std::shared_ptr<ExploreScene> sceneFrom(const std::string& source) {
  SceneOptions options;
  options.fit = false;
  return std::make_shared<ExploreScene>(loadGuidedScene(source, options));
}

ExplorerWindowModel modelOf(const std::string& source, const std::string& camera = "") {
  return {{.read = [source](const Progress&) { return sceneFrom(source); },
           .explorer = {.waitForWays = true},
           .camera = camera},
          {}};
}

size_t indexOf(const WindowPicture& picture, const std::string& name) {
  const auto found = std::ranges::find(picture.choices, name, &WindowChoice::name);
  return static_cast<size_t>(found - picture.choices.begin());
}

constexpr WindowShape kSmall{.view = {160, 90}};

TEST(ExplorerWindowModel, drawsWhatIsAskedFor) {
  ExplorerWindowModel model = modelOf(kSmallMaze);
  const WindowPicture plain = model.draw(kSmall);
  EXPECT_EQ(plain.view.width(), 160);
  EXPECT_EQ(plain.view.height(), 90);
  EXPECT_FALSE(plain.pinhole);
  EXPECT_EQ(plain.ground, nullptr);
  ASSERT_NE(plain.scene, nullptr);
  const WindowPicture more = model.draw({.view = {160, 90}, .pinhole = glm::ivec2(80, 60), .ground = true});
  ASSERT_TRUE(more.pinhole);
  EXPECT_EQ(more.pinhole->height(), 60);
  ASSERT_NE(more.ground, nullptr);
  EXPECT_LT(more.ground->lower.x, more.plan.walker.x);
  EXPECT_GT(more.ground->upper.x, more.plan.walker.x);
  EXPECT_EQ(model.draw({.view = {160, 90}, .ground = true}).ground, more.ground);  // it is made once
}

TEST(ExplorerWindowModel, thePinholeLooksLikeTheViewOfThePinhole) {
  ExplorerWindowModel model = modelOf(kSmallMaze);
  const WindowPicture picture = model.draw({.view = {160, 90}, .pinhole = glm::ivec2(160, 90)});
  EXPECT_TRUE(*picture.pinhole == picture.view);
}

TEST(ExplorerWindowModel, walkingMovesThePlan) {
  ExplorerWindowModel model = modelOf(kSmallMaze);
  const WindowPlan before = model.draw(kSmall).plan;
  model.advance(0.5, {.ahead = 1});
  const WindowPlan after = model.draw(kSmall).plan;
  const glm::vec2 way = after.walker - before.walker;
  EXPECT_NEAR(glm::length(way), 0.8, 0.01);  // 1.6 m a second
  EXPECT_NEAR(glm::dot(way, before.heading), 0.8, 0.01);
}

TEST(ExplorerWindowModel, everyRowCanBeChosenAndSaysItsOptions) {
  ExplorerWindowModel model = modelOf(kSmallMaze);
  const size_t count = model.draw(kSmall).choices.size();
  EXPECT_EQ(count, liveConstructors().size());
  for (size_t i = 0; i < count; ++i) {
    model.choose(i);
    model.advance(0.1, {});
    const WindowPicture picture = model.draw(kSmall);
    EXPECT_EQ(picture.chosen, i);
    for (const WindowField& field : picture.fields) {
      EXPECT_FALSE(field.label.empty()) << field.name;
      EXPECT_LT(field.lower, field.upper) << field.name;
      EXPECT_GT(field.step, 0) << field.name;
      EXPECT_GE(field.value, field.lower) << field.name;
      EXPECT_LE(field.value, field.upper) << field.name;
      model.changeField(field.name, 1e6);  // stays in its range
      model.changeField(field.name, -1e6);
    }
  }
  EXPECT_THROW(model.changeField("nothing", 1), InputError);
}

TEST(ExplorerWindowModel, thingsArePickedWithoutThePointer) {
  ExplorerWindowModel model = modelOf("builtin:boxes");
  const WindowPicture first = model.draw(kSmall);
  EXPECT_NE(model.pickNext(1), "");  // the pinhole picks nothing
  model.choose(indexOf(first, "occluder"));
  EXPECT_EQ(model.pickNext(1), "");
  for (int i = 0; i < 5; ++i) {
    model.advance(0.1, {});
  }
  const std::vector<glm::vec2> near = model.draw(kSmall).plan.picked;
  ASSERT_EQ(near.size(), 4U);
  model.pickNext(1);
  for (int i = 0; i < 60; ++i) {
    model.advance(0.1, {});
  }
  const std::vector<glm::vec2> next = model.draw(kSmall).plan.picked;
  EXPECT_NE(next, near);
  model.pickNext(-1);
  for (int i = 0; i < 60; ++i) {
    model.advance(0.1, {});
  }
  EXPECT_EQ(model.draw(kSmall).plan.picked, near);
}

TEST(ExplorerWindowModel, aClickThatMeetsNothingSaysWhatToClick) {
  ExplorerWindowModel model = modelOf(kSmallMaze);
  const WindowPicture picture = model.draw(kSmall);
  model.choose(indexOf(picture, "target"));
  EXPECT_NE(model.pick({-5, -5}).find("object"), std::string::npos);
}

TEST(ExplorerWindowModel, placesOfThePlanAreReachedAndTheStartAgain) {
  ExplorerWindowModel model = modelOf(kSmallMaze);
  const glm::vec2 start = model.draw(kSmall).plan.walker;
  const auto glide = [&] {
    for (int i = 0; i < 40; ++i) {
      model.advance(0.1, {});
    }
    return model.draw(kSmall).plan.walker;
  };
  const glm::vec2 there = start + glm::vec2(0.5f, 0.25f);
  model.goTo(there);
  EXPECT_LT(glm::distance(glide(), there), 1e-3);
  model.goToStart();
  EXPECT_LT(glm::distance(glide(), start), 1e-3);
}

TEST(ExplorerWindowModel, camerasAreFiles) {
  ExplorerWindowModel model = modelOf(kSmallMaze);
  model.draw(kSmall);
  EXPECT_NE(model.cameraFile().find('{'), std::string::npos);
}

TEST(ExplorerPlan, eachOpeningIsOneLine) {
  const std::shared_ptr<ExploreScene> scene = sceneFrom(kSmallMaze);
  const std::vector<WindowPlan::Opening> openings = planOpenings(*scene);
  // A maze without loops of n cells has n - 1 passages between them.
  std::set<std::array<float, 4>> seen;
  for (const WindowPlan::Opening& opening : openings) {
    EXPECT_TRUE(seen.insert({opening[0].x, opening[0].y, opening[1].x, opening[1].y}).second);
  }
  EXPECT_GE(openings.size(), 8U);
}

TEST(ExplorerPlan, tunnelsFollowTheirRings) {
  WalkMap map;
  map.cells.push_back({.kind = WalkCellKind::kTunnel,
                       .center = {0, 0, 0},
                       .axis = {0, 0, -1},
                       .halfLength = 2,
                       .halfWidth = 1,
                       .rings = {{0, 1, 1, 2}, {2, 0.5f, 1, 2}, {4, 1, 1, 2}}});
  WalkCell room;
  room.center = {5, 0, 0};
  room.axis = {1, 0, 0};
  room.halfLength = 3;
  room.halfWidth = 1;
  map.cells.push_back(room);
  const std::vector<WindowPlan::Cell> cells = planCells(map);
  EXPECT_TRUE(cells[0].isTunnel);
  // To the right of who walks to -z is +x; up the right wall, back along the left one.
  EXPECT_EQ(cells[0].outline, (std::vector<glm::vec2>{{1, 2}, {1, 0}, {1, -2}, {-1, -2}, {-0.5f, 0}, {-1, 2}}));
  EXPECT_FALSE(cells[1].isTunnel);
  EXPECT_EQ(cells[1].outline, (std::vector<glm::vec2>{{2, -1}, {8, -1}, {8, 1}, {2, 1}}));
}

}  // namespace
}  // namespace ocelli
