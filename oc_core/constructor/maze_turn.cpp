#include "oc_core/constructor/maze_turn.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "oc_core/base/conventions.h"
#include "oc_core/base/error.h"

namespace ocelli {
namespace {

constexpr const char* kMazeTurn = "turn in a maze";

/// The chosen way: its beginning in the crossing, and where it leads.
struct ChosenWay {
  glm::dvec3 mouth{0};  ///< in the middle, at the height of the eye
  Direction heading = Direction::kNorth;
};

ChosenWay chosenWay(const Maze& maze, const MazeTurn& turn) {
  const std::optional<CrossingAhead> crossing = crossingAhead(maze, turn.from);
  if (!crossing || !(turn.left ? crossing->left : crossing->right)) {
    throw InputError(fmt::format("there is no way to the {} ahead", turn.left ? "left" : "right"), kMazeTurn,
                     "turn at a crossing, to an open side");
  }
  const Direction heading = turn.left ? leftOf(turn.from.heading) : rightOf(turn.from.heading);
  const CrossingFrame frame(maze, crossing->cell, heading);
  return {frame.at(frame.width / 2, frame.width, turn.from.eye.y - static_cast<double>(maze.origin.y)), heading};
}

class Turning {
 public:
  Turning(const Maze& maze, const MazeTurn& turn, const MazeCameraOptions& options, int width, int height)
      : maze_(maze), turn_(turn), options_(options), width_(width), height_(height), way_(chosenWay(maze, turn)) {}

  GraphCamera forward() const {
    if (turn_.phase >= 3) {
      return camera(walking(), options_);
    }
    MazeCameraOptions options = options_;
    const double chosen = std::max(0.0, 2 * step(1) - 1);
    const std::array<double, 3> all{turn_.left ? 1.0 : 0, 0, turn_.left ? 0 : 1.0};
    for (size_t k = 0; k < 3; ++k) {
      options.split[k] = glm::mix(options_.split[k], all[k], chosen);
    }
    options.deployed = glm::mix(deployedAt(maze_, turn_.from, options_.deployCells), 1.0, step(1));
    options.parallel = std::min(1.0, 2 * step(1));
    options.fovCorridorDegrees = glm::mix(options_.fovCorridorDegrees, options_.fovHorizontalDegrees, step(2));
    return camera(turn_.from, options);
  }

  GraphCamera backward() const {
    MazeCameraOptions options = options_;
    options.backward = true;
    if (turn_.phase >= 3) {
      return camera(walking(), options);
    }
    if (turn_.phase <= 1) {
      const MazePose back{turn_.from.eye, opposite(turn_.from.heading)};
      options.deployed = glm::mix(deployedAt(maze_, back, options_.deployCells), 0.0, step(0));
      return camera(turn_.from, options);
    }
    const double angle = step(2) * kPi / 2;
    const glm::dvec3 before(vectorOf(opposite(turn_.from.heading)));
    const glm::dvec3 after(vectorOf(opposite(way_.heading)));
    const glm::dvec3 eye = turn_.from.eye + (newEye() - turn_.from.eye) * step(2);
    return GraphCamera(
        mazePinhole(maze_, eye, before * std::cos(angle) + after * std::sin(angle), options_, width_, height_));
  }

 private:
  /// How far the step from `begin` to the next whole number is, 0 to 1.
  double step(int begin) const { return std::clamp(turn_.phase - begin, 0.0, 1.0); }

  GraphCamera camera(const MazePose& pose, const MazeCameraOptions& options) const {
    return makeMazeCamera(maze_, pose, options, width_, height_);
  }

  /// From where the chosen way fills the image.
  glm::dvec3 newEye() const {
    const double width = CrossingFrame(maze_, {}, way_.heading).width;
    const double behind = width / 2 / std::tan(radiansFromDegrees(options_.fovHorizontalDegrees) / 2);
    return way_.mouth - glm::dvec3(vectorOf(way_.heading)) * behind;
  }
  MazePose walking() const {
    const glm::dvec3 end = poseAfter(maze_, turn_).eye;
    return {newEye() + (end - newEye()) * step(3), way_.heading};
  }

  const Maze& maze_;
  const MazeTurn& turn_;
  const MazeCameraOptions& options_;
  int width_;
  int height_;
  ChosenWay way_;
};

}  // namespace

MazePose poseAfter(const Maze& maze, const MazeTurn& turn) {
  const ChosenWay way = chosenWay(maze, turn);
  return {way.mouth + glm::dvec3(vectorOf(way.heading)) * (static_cast<double>(maze.cellSize) / 2), way.heading};
}

std::pair<GraphCamera, GraphCamera> turningCameras(const Maze& maze, const MazeTurn& turn,
                                                   const MazeCameraOptions& options, int width, int height) {
  if (!(turn.phase >= 0 && turn.phase <= 4)) {
    throw InputError(fmt::format("the phase {} is not from 0 to 4", turn.phase), kMazeTurn, "each step is one unit");
  }
  const Turning turning(maze, turn, options, width, height);
  return {turning.forward(), turning.backward()};
}

}  // namespace ocelli
