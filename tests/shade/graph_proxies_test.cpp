// Graph cameras as what stands for a scene (scene_proxies.h), in a maze with a mirroring ball.
#include <gmock/gmock.h>

#include "oc_core/base/error.h"
#include "oc_core/shade/effects.h"
#include "oc_core/shade/scene_proxies.h"
#include "oc_core/shade/shade_comparison.h"
#include "oc_core/shade/specular_ways.h"
#include "tests/base/temporary_folder.h"
#include "tests/shade/small_shaded_scene.h"

namespace ocelli {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr const char* kSmallMaze = "builtin:mirrormaze,rows=3,columns=3";

struct MirrorMaze {
  ShadedScene scene = loadShadedScene(kSmallMaze, rolesFor(kSmallMaze, ""));
  CastObjects cast = castObjects(scene, &scene.mirrors[0]);
  Box senders = boundsOf(scene.mirrors);
  PinholeCamera reference{aroundView(scene.cast, senders), 360, 240};
  PinholeCamera camera{unhiddenView(pictureView(senders), scene, senders), 60, 40};
  SecondaryRays rays = reflectedRays({scene, scene.mirrors}, camera);

  BuiltProxy build(const std::string& name) const {
    const Progress none;
    return buildProxy(specularWay(name), {scene, cast, senders.center(), reference, {.sideRadii = 0.1f}, 64, none});
  }
  ShadeFigures figures(const std::string& name) const {
    const ShadedPicture truth = shade(rays, *build(kTraced).proxy);
    const BuiltProxy built = build(name);
    return figuresOf(built, rays, truth, shade(rays, *built.proxy), {{reference}, {}});
  }
};

TEST(GraphProxies, showWhatStandsAround) {
  const MirrorMaze maze;
  EXPECT_FALSE(planeView(maze.scene.cast, maze.senders, 90, 60)) << "the maze lies around the ball";
  const ShadeFigures di = maze.figures("di");
  const ShadeFigures graph = maze.figures("comprehensive");
  const ShadeFigures walk = maze.figures("comprehensive:by-frusta");
  ASSERT_GT(graph.castRays, 200u);
  // A depth image holds what lies to one side.
  EXPECT_GT(di.lostRatio(), 0.4);
  EXPECT_LT(graph.lostRatio(), 0.25);
  EXPECT_LT(walk.lostRatio(), 0.25);
  EXPECT_GT(graph.psnrDecibels, di.psnrDecibels + 3);
  EXPECT_GT(walk.psnrDecibels, di.psnrDecibels + 3);
  EXPECT_EQ(walk.samples, graph.samples);
  EXPECT_GT(walk.stepsPerRay(), graph.stepsPerRay());
}

TEST(GraphProxies, areNamedAsConstructorsAndFiles) {
  EXPECT_NO_THROW(checkProxyName("comprehensive"));
  EXPECT_NO_THROW(checkProxyName("comprehensive:by-frusta"));
  EXPECT_THAT([] { checkProxyName("cell:by-frusta"); }, ThrowsMessage<InputError>(HasSubstr("no graph camera")));
  const test::TemporaryFolder folder;
  const std::string file = folder.write("tour.json", R"({"camera": "comprehensive", "eye_height": 3})");
  EXPECT_NO_THROW(checkProxyName(file));
  const MirrorMaze maze;
  EXPECT_LT(maze.figures(file).lostRatio(), 0.4);
  EXPECT_LT(maze.figures(file + ":by-frusta").lostRatio(), 0.4);
  const std::string curved = folder.write("curved.json", R"({"camera": "curved", "turns": []})");
  EXPECT_THAT([&] { maze.build(curved + ":by-frusta"); },
              ThrowsMessage<InputError>(HasSubstr("no frusta to walk through")));
}

TEST(GraphProxies, needWaysWhereTheyShowAllOfThem) {
  ShadedScene scene = test::mirrorBeforeBox();
  scene.whole.mesh = scene.cast;
  scene.whole.guides.walk.emplace();  // it is known that nobody walks there
  const Box senders = boundsOf(scene.mirrors);
  const PinholeCamera reference(referenceView(scene.cast, senders, 90, 60), 90, 60);
  const Progress none;
  EXPECT_THROW(buildProxy(specularWay("comprehensive"),
                          {scene, castObjects(scene, nullptr), senders.center(), reference, {}, 64, none}),
               InputError);
}

TEST(UnhiddenView, rises) {
  const MirrorMaze maze;
  const View level = pictureView(maze.senders);
  const View raised = unhiddenView(level, maze.scene, maze.senders);
  EXPECT_GT(raised.eye.y, level.eye.y + 1) << "over the walls";
  EXPECT_NEAR(glm::distance(raised.eye, raised.target), glm::distance(level.eye, level.target), 1e-4f);
  EXPECT_GT(maze.rays.rays.size(), 300u);
  // As it is where nothing is before the mirror.
  const ShadedScene open = test::mirrorBeforeBox();
  const View seen = pictureView(boundsOf(open.mirrors));
  EXPECT_EQ(unhiddenView(seen, open, boundsOf(open.mirrors)), seen);
}

}  // namespace
}  // namespace ocelli
