#include "oc_core/constructor/maze_start.h"

#include <algorithm>
#include <cmath>

#include "oc_core/base/conventions.h"
#include "oc_core/constructor/crossing_frusta.h"

namespace ocelli {
namespace {

/// How far away the viewpoints of almost parallel rays lie, in clear widths.
constexpr double kFar = 50;
/// How far within a cell rays begin to the left and right, in clear widths: beside the planes where they turn.
constexpr double kInset = 0.02;
/// How far beyond the near face of its cell the first frustum within a maze begins, in clear widths.
constexpr double kFirstHeight = 1e-3;

/// Looks level, its upper border the horizon; `tall` fits into its height at `distance`.
PinholeCamera levelCamera(const glm::dvec3& eye, const glm::dvec3& direction, double distance, double tall,
                          const MazeOpening& opening, int width, int height) {
  View view;
  view.eye = glm::vec3(eye);
  view.target = glm::vec3(eye + direction * distance);
  view.fovVerticalDegrees = degreesFromRadians(2 * std::atan(tall / 2 / distance));
  view.centerShift = {0, -0.5f};
  view.zNear = static_cast<float>(0.5 * distance);
  view.zFar = static_cast<float>(2 * distance + 3 * opening.longestRay);
  return {view, width, height};
}

MazeStart besideEntrance(const CrossingFrame& frame, double wall, const MazeOpening& opening, int width, int height) {
  const double w = frame.width;
  const double distance = kFar * w;
  // E is the near left corner of the opening; O, at the right border of the image, as far back as the image is wide.
  const double half = opening.height * width / height / 2;
  const double eyeBehind = half * distance / (distance + w);
  const double outer = -wall - 1e-3 * w;
  const glm::dvec3 e = frame.at(0, outer);
  const glm::dvec3 o = frame.at(w, outer - eyeBehind - half);
  const glm::dvec3 eye = frame.at(-distance, outer - eyeBehind, opening.height);
  GraphCamera camera(levelCamera(eye, frame.right, distance + w, opening.height, opening, width, height));
  const glm::dvec3 normal = frame.ahead * w + frame.right * (eyeBehind + half);
  const glm::dvec3 behind = frame.at(w / 2, outer - distance * kFar, opening.height);
  const int frustum = camera.bend(GraphCamera::kRoot, {Plane::through(e, normal), behind}, "before the entrance",
                                  partBetween(camera, GraphCamera::kRoot, e, o, opening.height));
  return {std::move(camera), frustum, frame.at(0, -wall), frame.at(w, -wall), frame.ahead};
}

MazeStart within(const CrossingFrame& frame, const MazeOpening& opening, int width, int height) {
  const double w = frame.width;
  const double distance = kFar * w;
  const glm::dvec3 eye = frame.at(w / 2, -distance, opening.height);
  PinholeCamera camera =
      levelCamera(eye, frame.ahead, distance, std::max(opening.height, w * height / width), opening, width, height);
  View view = camera.view();
  // Beyond the face of a wall that may stand behind the cell.
  view.zNear = static_cast<float>(distance + kFirstHeight * w / 2);
  return {GraphCamera(PinholeCamera(view, width, height)), GraphCamera::kRoot, frame.at(kInset * w, kFirstHeight * w),
          frame.at((1 - kInset) * w, kFirstHeight * w), frame.ahead};
}

}  // namespace

MazeStart startOf(const Maze& maze, const MazeOpening& opening, int width, int height) {
  const CrossingFrame frame(maze, opening.cell, opening.heading);
  const bool fromOutside =
      maze.entrance && maze.entrance->cell == opening.cell && maze.entrance->heading == opening.heading;
  return fromOutside ? besideEntrance(frame, static_cast<double>(maze.wallThickness), opening, width, height)
                     : within(frame, opening, width, height);
}

}  // namespace ocelli
