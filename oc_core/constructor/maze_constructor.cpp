#include "oc_core/constructor/maze_constructor.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "oc_core/base/conventions.h"
#include "oc_core/base/error.h"
#include "oc_core/constructor/camera_fields.h"
#include "oc_core/constructor/maze_horizon.h"
#include "oc_core/constructor/maze_options.h"

namespace ocelli {
namespace {

constexpr const char* kMazeCamera = "maze camera";
constexpr double kParallel = 1.0 / 200;  ///< one over how much farther away the viewpoint of parallel rays lies
constexpr double kMinWayShare = 2e-3;    ///< of rays; less is no way

double tanHalf(double degrees) {
  return std::tan(radiansFromDegrees(degrees) / 2);
}

void check(const MazeCameraOptions& options) {
  const auto& [left, ahead, right] = options.split;
  if (!(left >= 0 && ahead >= 0 && right >= 0)) {
    throw InputError(fmt::format("\"split\" has a negative share: {}, {}, {}", left, ahead, right), kMazeCamera,
                     "give three numbers from 0 to 1 that add up to 1");
  }
  if (!(std::abs(left + ahead + right - 1) < 1e-6)) {
    throw InputError(
        fmt::format("the shares of \"split\", {}, {} and {}, add up to {}", left, ahead, right, left + ahead + right),
        kMazeCamera, "give three numbers that add up to 1");
  }
}

/// What the root looks like: where its rays begin, how wide they spread, and where from.
struct Lens {
  double behind = 0;   ///< the eye, of the user
  double tangent = 1;  ///< of half the horizontal field of view
  double aside = 0;    ///< where the view direction meets the image: to the right of its middle, in image widths
};

View viewOf(const Maze& maze, const glm::dvec3& eye, const glm::dvec3& direction, const Lens& lens, double aspect) {
  const double cell = static_cast<double>(maze.cellSize);
  View view;
  view.eye = glm::vec3(eye - direction * lens.behind);
  view.target = glm::vec3(eye + direction * cell);
  view.fovVerticalDegrees = degreesFromRadians(2 * std::atan(lens.tangent / aspect));
  const double eyeHeight = eye.y - static_cast<double>(maze.origin.y);
  view.centerShift = {static_cast<float>(lens.aside * aspect),
                      static_cast<float>(horizonShift(eyeHeight, 2 * lens.tangent * lens.behind / aspect))};
  view.zNear = static_cast<float>(std::max(lens.behind, 0.01 * cell));
  view.zFar = static_cast<float>(lens.behind + cell * static_cast<double>(4 * (maze.rows() + maze.columns())));
  return view;
}

class MazeCameraBuilder {
 public:
  MazeCameraBuilder(const Maze& maze, const MazePose& pose, const MazeCameraOptions& options)
      : maze_(maze),
        pose_(pose),
        options_(options),
        deployed_(options.deployed.value_or(deployedAt(maze, pose, options.deployCells))) {}

  GraphCamera build(int width, int height) const {
    const double aspect = static_cast<double>(width) / height;
    const std::optional<CrossingAhead> crossing = crossingAhead(maze_, pose_);
    if (!crossing || !(deployed_ > 0)) {
      return GraphCamera(mazePinhole(maze_, pose_.eye, glm::dvec3(vectorOf(pose_.heading)), options_, width, height));
    }
    const CrossingFrame frame(maze_, crossing->cell, pose_.heading);
    const double x = glm::dot(pose_.eye - frame.corner, frame.right);
    // Deployed in full, the corridor fills the image where the user stands.
    const double hug = std::max(frame.width / 2 / tanHalf(options_.fovHorizontalDegrees),
                                crossing->distance * options_.crossingShare / (1 - options_.crossingShare)) /
                       glm::mix(1.0, kParallel, options_.parallel);
    Lens lens;
    lens.behind = deployed_ * hug;
    lens.tangent = 1 / glm::mix(1 / tanHalf(options_.fovHorizontalDegrees), hug / (frame.width / 2), deployed_);
    lens.aside = deployed_ * (x / frame.width - 0.5);
    GraphCamera camera(
        PinholeCamera(viewOf(maze_, pose_.eye, glm::dvec3(vectorOf(pose_.heading)), lens, aspect), width, height));
    addWaysOut(camera, GraphCamera::kRoot, maze_, crossing->cell, pose_.heading,
               waysOut(*crossing, frame.width, rootOf(*crossing, frame, x, lens)),
               pose_.eye.y - static_cast<double>(maze_.origin.y));
    return camera;
  }

 private:
  /// The rays of the root in the plan of the crossing, in its widths.
  struct Root {
    double x;       ///< of the viewpoint
    double before;  ///< how far the viewpoint lies before the near face
    double left;    ///< where on the near face, or beside it, the image begins
    double right;   ///< and ends
  };

  static Root rootOf(const CrossingAhead& crossing, const CrossingFrame& frame, double x, const Lens& lens) {
    const double before = (lens.behind + crossing.distance) / frame.width;
    const double span = 2 * lens.tangent * before;
    x /= frame.width;
    return {x, before, x - (0.5 + lens.aside) * span, x + (0.5 - lens.aside) * span};
  }

  /// Of rays, as far as there are ways: to the left and to the right.
  std::array<double, 2> raysAside(const CrossingAhead& crossing) const {
    std::array<double, 3> split{crossing.left ? options_.split[0] : 0, crossing.ahead ? options_.split[1] : 0,
                                crossing.right ? options_.split[2] : 0};
    double sum = split[0] + split[1] + split[2];
    if (!(sum > 0)) {  // what is asked for is not there
      split = {crossing.left ? 1.0 : 0, crossing.ahead ? 1.0 : 0, crossing.right ? 1.0 : 0};
      sum = split[0] + split[1] + split[2];
    }
    return {deployed_ * split[0] / sum, deployed_ * split[2] / sum};
  }

  WaysOut waysOut(const CrossingAhead& crossing, double width, const Root& root) const {
    const double corridor = width / 2 / tanHalf(options_.fovCorridorDegrees);
    const std::array<double, 2> rays = raysAside(crossing);
    const double ahead = 1 - rays[0] - rays[1];
    // The part of the near face in the image, measured from each side.
    const double first = std::max(root.left, 0.0);
    const double last = std::min(root.right, 1.0);
    const std::array<double, 2> near{first + rays[0] * (last - first), 1 - last + rays[1] * (last - first)};
    const std::array<double, 2> viewpoint{root.x, 1 - root.x};
    // At Pl and Pr, rays have gone on from the near face: not so far that they leave the box.
    WaysOut ways;
    ways.depth = std::min(0.999, 1 - 0.8 * ahead);
    std::array<double, 2> outwards{};
    for (size_t k = 0; k < 2; ++k) {
      outwards[k] = (viewpoint[k] - near[k]) / root.before;
      if (rays[k] > kMinWayShare && outwards[k] > 0) {
        ways.depth = std::min(ways.depth, 0.5 * near[k] / outwards[k]);
      }
    }
    for (size_t k = 0; k < 2; ++k) {
      ways.way[2 * k] = {rays[k] > kMinWayShare ? near[k] - outwards[k] * ways.depth : 0, corridor};
    }
    // Without a way ahead, rays go straight on to the far wall.
    ways.way[1] = {1 - ways.way[0].share - ways.way[2].share, crossing.ahead && ahead > kMinWayShare ? corridor : 0};
    ways.straight = 1 - deployed_;
    ways.endInBox = false;
    return ways;
  }

  const Maze& maze_;
  const MazePose& pose_;
  const MazeCameraOptions& options_;
  double deployed_;
};

}  // namespace

PinholeCamera mazePinhole(const Maze& maze, const glm::dvec3& eye, const glm::dvec3& direction,
                          const MazeCameraOptions& options, int width, int height) {
  const Lens lens{0, tanHalf(options.fovHorizontalDegrees), 0};
  return {viewOf(maze, eye, direction, lens, static_cast<double>(width) / height), width, height};
}

GraphCamera makeMazeCamera(const Maze& maze, const MazePose& pose, const MazeCameraOptions& options, int width,
                           int height) {
  check(options);
  const MazeCell cell = cellOf(maze, pose.eye, kMazeCamera);
  const std::optional<CrossingAhead> crossing = crossingAhead(maze, pose);
  if (!maze.isOpen(cell, pose.heading) && !crossing) {
    throw InputError(fmt::format("a wall stands to the {} of the cell {}", nameOf(pose.heading), nameOf(cell)),
                     kMazeCamera, "head for an open side");
  }
  return MazeCameraBuilder(maze, {pose.eye, options.backward ? opposite(pose.heading) : pose.heading}, options)
      .build(width, height);
}

MazeCameraPlace readMazeCamera(JsonFields& fields, const PinholeCamera& reference) {
  MazeCameraPlace place;
  MazeCameraOptions& options = place.options;
  place.pose.eye = fields.has("position") ? readVector(fields, "position") : glm::dvec3(reference.eye());
  place.pose.heading = readDirection(fields, "heading").value_or(nearestDirection(reference.forward()));
  const std::string direction = fields.text("direction", "forward");
  if (direction != "forward" && direction != "backward") {
    fields.fail("direction", "is \"" + direction + "\", but must be forward or backward");
  }
  options.backward = direction == "backward";
  if (fields.has("split")) {
    const glm::dvec3 split = readVector(fields, "split");
    options.split = {split.x, split.y, split.z};
  }
  options.fovHorizontalDegrees = fields.number("fov_degrees", 10, 150, options.fovHorizontalDegrees);
  options.fovCorridorDegrees = fields.number("corridor_fov_degrees", 1, 150, options.fovCorridorDegrees);
  options.crossingShare = fields.number("crossing_share", 0.05, 0.98, options.crossingShare);
  options.deployCells = fields.number("deploy_cells", 0.01, 100, options.deployCells);
  return place;
}

}  // namespace ocelli
