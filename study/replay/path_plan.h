// A plan of what a subject did in a trial: the walls of the maze, the path walked, coloured by time and marked with
// directions, the object and where it went, and clicks.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "oc_core/drawing/figure.h"
#include "oc_core/scene/maze.h"
#include "study/replay/trial_replay.h"

namespace ocelli {

/// Places are east and south, metres.
struct PathPlan {
  struct Point {
    double seconds = 0;
    WalkerPose pose;
  };
  struct Object {
    LandmarkShape shape = LandmarkShape::kCone;
    LandmarkColor color = LandmarkColor::kOrange;
    std::vector<glm::dvec2> places;  ///< at each point of the path; one where it stands still
  };
  struct Click {
    double seconds = 0;
    glm::dvec2 place{0};  ///< where the subject stood
    bool ended = false;   ///< the trial
  };

  std::string title;
  std::string subtitle;
  std::optional<Maze> maze{};
  std::vector<Point> path;  ///< one a frame
  std::vector<Object> objects{};
  std::vector<Click> clicks{};
  std::string simulated{};  ///< a note where no person did it
};

/// From a log, by a replay of it.
PathPlan pathPlanOf(const TaskBlock& block, const TrialLog& log, const std::string& title);

/// Throws InputError where the trial shows no maze.
Figure pathPlanFigure(const PathPlan& plan);

/// SVG or PNG, as the name ends. Throws as pathPlanFigure() and writeFigure() do (figure_file.h).
void writePathPlan(const std::filesystem::path& path, const PathPlan& plan);

}  // namespace ocelli
