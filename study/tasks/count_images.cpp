#include "study/tasks/count_images.h"

#include <array>
#include <utility>

#include "oc_core/constructor/comprehensive_constructor.h"
#include "oc_core/worlds/maze_file.h"

namespace ocelli {
namespace {

/// A crossing, and two corridors that turn back at each of its sides. One enters from the south.
Maze mazeToCount() {
  Maze maze = mazeFromJsonText(R"({"plan": [
    "+-+-+-+-+-+",
    "|   | |   |",
    "+ +-+ +-+ +",
    "|         |",
    "+ +-+ +-+ +",
    "|   | |   |",
    "+-+-+ +-+-+"]})",
                               "an example");
  maze.landmarks = {{{0, 1}, LandmarkShape::kCone, LandmarkColor::kYellow},
                    {{2, 1}, LandmarkShape::kCube, LandmarkColor::kSkyBlue},
                    {{1, 3}, LandmarkShape::kSphere, LandmarkColor::kVermilion, 0.1f, 0.1f},
                    {{0, 3}, LandmarkShape::kColumn, LandmarkColor::kPurple},
                    {{2, 3}, LandmarkShape::kPyramid, LandmarkColor::kOrange}};
  return maze;
}

InstructionExample countExample(bool graph, const glm::ivec2& size) {
  InstructionExample example{std::make_shared<StudyScene>(mazeToCount(), false), {}};
  const Maze& maze = example.scene->maze();
  example.layout.scene = example.scene.get();
  if (graph) {
    ComprehensiveOptions options;
    options.nearness = 0.8;
    example.layout.views.emplace_back(wholeImage(size), makeComprehensiveCamera(maze, options, size.x, size.y));
    return example;
  }
  constexpr int kColumns = 3;
  constexpr int kGap = 6;
  const int across = (size.x - (kColumns - 1) * kGap) / kColumns;
  const int down = (size.y - kGap) / 2;
  const std::array<std::pair<MazeCell, Direction>, 6> eyes{{{{0, 0}, Direction::kEast},
                                                            {{2, 2}, Direction::kNorth},
                                                            {{0, 4}, Direction::kWest},
                                                            {{2, 0}, Direction::kEast},
                                                            {{1, 0}, Direction::kEast},
                                                            {{2, 4}, Direction::kWest}}};
  for (int i = 0; i < static_cast<int>(eyes.size()); ++i) {
    const auto& [cell, heading] = eyes[static_cast<size_t>(i)];
    const PixelRect place{static_cast<double>(i % kColumns * (across + kGap)),
                          static_cast<double>(i / kColumns * (down + kGap)), static_cast<double>(across),
                          static_cast<double>(down)};
    example.layout.views.emplace_back(place, exampleEye(maze, cell, heading, 1, {across, down}));
  }
  return example;
}

}  // namespace

std::vector<InstructionImage> countImages() {
  return {{"count_ppc", false, [](const glm::ivec2& size) { return countExample(false, size); }},
          {"count_gc", true, [](const glm::ivec2& size) { return countExample(true, size); }}};
}

}  // namespace ocelli
