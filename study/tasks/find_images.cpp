#include "study/tasks/find_images.h"

#include "oc_core/constructor/portal_constructor.h"
#include "oc_core/worlds/maze_file.h"
#include "study/task/eye_camera.h"

namespace ocelli {
namespace {

/// A corridor from the south to a crossing, with one object around the corner.
Maze mazeToSearch() {
  Maze maze = mazeFromJsonText(R"({"plan": [
    "+-+-+-+-+-+",
    "|   | |   |",
    "+ +-+ +-+ +",
    "|         |",
    "+ +-+ +-+ +",
    "| | | | | |",
    "+ + + + + +",
    "|   | |   |",
    "+-+-+ +-+-+"]})",
                               "an example");
  maze.landmarks = {{{1, 1}, LandmarkShape::kSphere, LandmarkColor::kOrange, 0.15f, -0.1f}};
  return maze;
}

InstructionExample searchExample(bool graph, const glm::ivec2& size) {
  InstructionExample example{std::make_shared<StudyScene>(mazeToSearch()), {}};
  const Maze& maze = example.scene->maze();
  const PinholeCamera eye = exampleEye(maze, {3, 2}, Direction::kNorth, 0, size);
  example.layout.scene = example.scene.get();
  if (graph) {
    SceneGuides guides;
    guides.maze = maze;
    PortalOptions options = EyeCameraOptions().portals;  // as subjects will see it
    options.bentBeyond = 1;
    example.layout.views.emplace_back(wholeImage(size), buildPortalCamera(options, guides, eye));
  } else {
    example.layout.views.emplace_back(wholeImage(size), eye);
  }
  return example;
}

}  // namespace

std::vector<InstructionImage> findImages() {
  return {{"find_ppc", false, [](const glm::ivec2& size) { return searchExample(false, size); }},
          {"find_gc", true, [](const glm::ivec2& size) { return searchExample(true, size); }}};
}

}  // namespace ocelli
