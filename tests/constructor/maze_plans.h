// Mazes for tests, drawn as plans.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "oc_core/base/error.h"
#include "oc_core/scene/scene.h"
#include "oc_core/worlds/maze_file.h"
#include "oc_core/worlds/maze_mesh.h"
#include "oc_core/worlds/scene_source.h"

namespace ocelli::test {

inline Maze mazeOfPlan(const std::vector<std::string>& plan) {
  return mazeFromJsonText(nlohmann::json{{"plan", plan}}.dump(), "plan");
}

/// From the entrance in the south over two straight cells to a crossing of four ways; a loop in the west.
inline Maze crossroads() {
  return mazeOfPlan({
      "+-+-+-+-+-+",
      "|   | |   |",
      "+ +-+ +-+ +",
      "|         |",
      "+ + + +-+-+",
      "|   | |   |",
      "+-+-+ +-+ +",
      "| | | |   |",
      "+ + + + + +",
      "|   | |   |",
      "+-+ + + +-+",
      "|         |",
      "+-+-+ +-+-+",
  });
}

/// One way through all cells: a turn every other cell.
inline Maze serpentine(int columns) {
  std::vector<std::string> plan{"+", "|", "+", "|", "+"};
  for (int column = 0; column < columns; ++column) {
    const bool last = column + 1 == columns;
    plan[0] += "-+";
    plan[1] += last ? " |" : column % 2 == 0 ? "  " : " |";
    plan[2] += " +";
    plan[3] += last ? " |" : column % 2 == 0 ? " |" : "  ";
    plan[4] += column == 0 ? " +" : "-+";
  }
  return mazeOfPlan(plan);
}

inline GuidedScene sceneOf(const Maze& maze) {
  const Scene parts = makeMazeScene(maze);
  return {flatten(parts), objectOfTriangles(parts), parts.guides};
}

/// The message of the InputError; empty for none.
template <class Call>
std::string inputErrorOf(const Call& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace ocelli::test
