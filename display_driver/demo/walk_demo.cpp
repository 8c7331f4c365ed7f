#include "display_driver/demo/walk_demo.h"

#include <array>

#include "display_driver/demo/demo_folder.h"
#include "oc_core/explore/explore_renderer.h"
#include "oc_core/explore/explorer.h"

namespace ocelli {
namespace {

struct WalkDemoImage {
  const char* constructor;
  const char* name;
  const char* caption;
};
constexpr std::array kImages{
    WalkDemoImage{"pinhole", "Pinhole", "Walls hide what is behind the crossing."},
    WalkDemoImage{"maze", "Maze camera",
                  "At the right, all ways out of the crossing ahead; at the left, those behind."},
    WalkDemoImage{"comprehensive", "Comprehensive camera", "The whole maze from its entrance, each place once."},
};

constexpr double kFrame = 1.0 / 30;
constexpr int kFramesIn = 70;    // of walking into the maze, where ways lead on before and behind
constexpr int kMaxFrames = 600;  // until a camera has deployed: a few seconds' worth are enough

}  // namespace

DemoScene runWalkDemo(const std::string& title, const std::string& source, const std::filesystem::path& folder,
                      const std::string& name, const DemoOptions& options, const Progress& progress) {
  const DemoFolder images(folder, name);
  SceneOptions sceneOptions;
  sceneOptions.fit = false;
  ExploreScene world(loadGuidedScene(source, sceneOptions, progress));
  Explorer explorer(world, {.width = options.width, .height = options.height, .waitForWays = true});
  for (int frame = 0; frame < kFramesIn; ++frame) {
    explorer.advance({.forward = 1}, kFrame);
  }
  ExploreRenderer renderer(world);
  DemoScene scene;
  scene.title = title;
  scene.source = source;
  DemoRow row{
      "Around corners",
      "Cameras whose rays bend show what is behind the next corner before one is there. All three images are of "
      "the same place. \"ocelli explore\" is a window to walk in with them.",
      {}};
  for (const WalkDemoImage& each : kImages) {
    explorer.choose(each.constructor);
    for (int frame = 0; frame == 0 || (frame < kMaxFrames && !explorer.atRest()); ++frame) {
      explorer.advance({}, kFrame);
    }
    row.images.push_back(
        images.write(each.constructor, renderer.draw(explorer.frame()).image, each.name, each.caption));
  }
  scene.rows.push_back(std::move(row));
  return scene;
}

}  // namespace ocelli
