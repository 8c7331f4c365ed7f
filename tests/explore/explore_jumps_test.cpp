// No frame of a walk changes by more than the pinhole's would (section 4.3.1), with each constructor.
#include "oc_core/explore/explore_jumps.h"

#include <gtest/gtest.h>

#include "oc_core/explore/explore_offscreen.h"
#include "oc_core/worlds/scene_source.h"
#include "tests/explore/explore_scenes.h"

namespace ocelli {
namespace {

TEST(ImageChange, isTheMeanOfAllBytes) {
  Image<Rgb8> one(2, 1, Rgb8(10, 20, 30));
  Image<Rgb8> other = one;
  EXPECT_EQ(imageChange(one, other), 0);
  other(1, 0) = {16, 20, 27};
  EXPECT_DOUBLE_EQ(imageChange(one, other), 9 / 6.0);
}

TEST(JumpMeasure, tellsAJumpFromAStep) {
  ExploreScene scene(test::twoRooms());
  ExplorerOptions options;
  options.width = 160;
  options.height = 90;
  Explorer explorer(scene, options);
  ExploreRenderer renderer(scene);
  JumpMeasure measure(scene);
  explorer.jumpTo({{0, 1.6, 3}, 0, 0});
  WalkInput forward;
  forward.forward = 1;
  const auto add = [&](bool upsideDown) {
    explorer.advance(forward, 1 / 30.0);
    Image<Rgb8> picture = renderer.draw(explorer.frame()).image;
    if (upsideDown) {
      std::reverse(picture.begin(), picture.end());
    }
    measure.add(explorer.frame(), picture, 70, 2);
  };
  add(false);
  add(false);
  add(true);
  ASSERT_EQ(measure.changes().size(), 2u);
  EXPECT_FALSE(measure.changes()[0].jumps());
  EXPECT_EQ(measure.changes()[0].picture, measure.changes()[0].pinhole) << "the picture is the pinhole's";
  EXPECT_TRUE(measure.changes()[1].jumps());
  EXPECT_EQ(measure.worst()->change.frame, measure.changes()[1].frame);
  measure.cut();
  add(false);
  EXPECT_EQ(measure.changes().size(), 2u) << "nothing to compare with";
}

struct Walk {
  const char* name;
  GuidedScene (*scene)();
  const char* script;
};

GuidedScene unfitted(const char* name) {
  SceneOptions options;
  options.fit = false;
  return loadGuidedScene(name, options);
}

const Walk kWalks[] = {
    {"portal", test::twoRooms,
     R"({"size": [320, 180], "steps": [{"go": {"to": [6, 1.6, 1], "heading": -57}}, {"choose": "portal"},
         {"wait": "rest"}, {"expect": "rays bend at 1 part"}, {"walk": {"forward": 2}}, {"turn": -25},
         {"walk": {"forward": 2}}, {"turn": 40}, {"walk": {"right": -2}}, {"walk": {"forward": 3}}, {"turn": 30},
         {"walk": {"forward": 4}}, {"choose": "pinhole"}, {"wait": "rest"}]})"},
    {"portal_of_a_maze", [] { return unfitted("builtin:maze,seed=5"); },
     R"({"size": [320, 180], "steps": [{"choose": "portal"}, {"walk": {"forward": 5}}, {"turn": 90},
         {"walk": {"forward": 4}}, {"turn": -90}, {"choose": "pinhole"}, {"wait": "rest"}]})"},
    {"occluder", test::hiddenBox,
     R"({"size": [320, 180], "steps": [{"go": {"to": [0.5, 1.6, 5], "heading": 0}}, {"choose": "occluder"},
         {"pick": [155, 100]}, {"wait": "rest"}, {"walk": {"forward": 3}}, {"walk": {"right": 2}}, {"turn": -20},
         {"turn": 80}, {"turn": -60}, {"walk": {"forward": 2}}, {"choose": "pinhole"}, {"wait": "rest"}]})"},
    {"target", test::hiddenBox,
     R"({"size": [320, 180], "steps": [{"go": {"to": [2.5, 1.6, 1], "heading": -20}}, {"choose": "target"},
         {"seconds": 1}, {"go": {"to": [0, 1.6, 6], "heading": 0, "glide": true}}, {"wait": "rest"},
         {"walk": {"right": 2}}, {"walk": {"forward": 4}}, {"turn": -30}, {"turn": 120}, {"turn": -90},
         {"choose": "pinhole"}, {"wait": "rest"}]})"},
    {"path", test::hallWithPath,
     R"({"size": [320, 180], "steps": [{"choose": "path"}, {"wait": "rest"}, {"walk": {"forward": 22}},
         {"choose": "pinhole"}, {"wait": "rest"}]})"},
    {"comprehensive", [] { return unfitted("builtin:maze,seed=5"); },
     R"({"size": [320, 180], "steps": [{"choose": "comprehensive"}, {"wait": "rest"}, {"walk": {"forward": 2}},
         {"option": {"name": "nearness", "value": 3}}, {"wait": "rest"}, {"choose": "portal"}, {"wait": "rest"},
         {"choose": "pinhole"}, {"wait": "rest"}]})"},
    {"maze", [] { return unfitted("builtin:maze,seed=5"); },
     R"({"size": [320, 180], "steps": [{"choose": "maze"}, {"wait": "rest"}, {"walk": {"forward": 5}}, {"turn": 90},
         {"walk": {"forward": 4}}, {"choose": "pinhole"}, {"wait": "rest"}]})"},
    {"maze_in_four_steps", [] { return unfitted("builtin:maze,seed=5"); },
     R"({"size": [320, 180], "steps": [{"go": {"to": [7.55, 1.6, 7.55], "heading": 90}}, {"choose": "maze"},
         {"wait": "rest"}, {"turn": 4}, {"expect": "turning"}, {"wait": "rest"}, {"walk": {"forward": 1}},
         {"choose": "pinhole"}, {"wait": "rest"}]})"},
    {"portal_that_deploys_while_the_head_turns", test::twoRooms,
     R"({"size": [320, 180], "steps": [{"go": {"to": [6, 1.6, 1], "heading": -57}}, {"choose": "portal"},
         {"turn": 60}, {"turn": -90}, {"wait": "rest"}, {"choose": "pinhole"}, {"turn": 60}, {"turn": -60},
         {"wait": "rest"}]})"},
    {"occluder_that_deploys_while_the_head_turns", test::hiddenBox,
     R"({"size": [320, 180], "steps": [{"go": {"to": [0.5, 1.6, 5], "heading": 0}}, {"choose": "occluder"},
         {"pick": [155, 100]}, {"turn": 30}, {"turn": -60}, {"turn": 30}, {"wait": "rest"},
         {"option": {"name": "shadow", "value": 3}}, {"turn": 20}, {"turn": -40}, {"choose": "pinhole"},
         {"turn": 30}, {"turn": -60}, {"wait": "rest"}]})"},
    {"portal_of_the_curve_of_studies", test::twoRooms,
     R"({"size": [320, 180], "steps": [{"go": {"to": [6, 1.6, 1], "heading": -57}}, {"choose": "portal"},
         {"option": {"name": "curve", "value": 1}}, {"wait": "rest"}, {"walk": {"forward": 2}}, {"turn": -25},
         {"walk": {"forward": 2}}, {"turn": 40}, {"walk": {"right": -2}}, {"walk": {"forward": 3}}, {"turn": 30},
         {"walk": {"forward": 4}}, {"choose": "pinhole"}, {"wait": "rest"}]})"},
};

class ExploreJumps : public testing::TestWithParam<Walk> {};

TEST_P(ExploreJumps, noFrameJumps) {
  ExploreScene scene(GetParam().scene());
  ExploreOffscreenOptions options;
  options.measureJumps = true;
  const ExploreReport report =
      exploreOffscreen(scene, exploreScriptFromJsonText(GetParam().script, GetParam().name), options);
  ASSERT_GT(report.changes.size(), 60u);
  ASSERT_TRUE(report.worst);
  const WorstFrame& worst = *report.worst;
  std::printf("%s: at most %.3f of what is allowed\n", GetParam().name, worst.change.picture / worst.change.allowed());
  EXPECT_EQ(report.jumps(), 0) << "worst: frame " << worst.change.frame << " changes by " << worst.change.picture
                               << ", the pinhole by " << worst.change.pinhole << ", with a turn by "
                               << worst.change.turn << "\n"
                               << csvOf(report.changes);
}

INSTANTIATE_TEST_SUITE_P(Walks, ExploreJumps, testing::ValuesIn(kWalks),
                         [](const auto& walk) { return std::string(walk.param.name); });

}  // namespace
}  // namespace ocelli
