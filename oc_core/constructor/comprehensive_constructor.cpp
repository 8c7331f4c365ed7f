#include "oc_core/constructor/comprehensive_constructor.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "oc_core/base/error.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/constructor/crossing_frusta.h"
#include "oc_core/constructor/maze_options.h"
#include "oc_core/constructor/maze_start.h"

namespace ocelli {
namespace {

/// Viewpoints lie at least so many corridor widths behind where rays turn: they must not look along planes.
constexpr double kMinDistance = 1.4;

class ComprehensiveBuilder {
 public:
  ComprehensiveBuilder(const Maze& maze, const ComprehensiveOptions& options, const MazeCell& start, Direction heading)
      : maze_(maze),
        options_(options),
        legs_(tourOf(maze, start, heading, options.order)),
        frustumOf_(legs_.size(), -1),
        width_(CrossingFrame(maze, start, heading).width),
        eyeHeight_(options.eyeHeight * static_cast<double>(maze.wallHeight)) {}

  GraphCamera build(int width, int height) {
    GraphCamera camera = beforeStart(width, height);
    for (size_t i = 0; i < legs_.size(); ++i) {
      endAtWalls(camera, i);
      try {
        addChildren(camera, legs_[i], frustumOf_[i]);
      } catch (const InputError&) {
        throw InputError(
            fmt::format("the maze of {} by {} cells does not fit into an image of {} by {} pixels: too few "
                        "rays are left for its deepest corridors, or they turn too often",
                        maze_.rows(), maze_.columns(), width, height),
            "comprehensive camera", "use a smaller maze, a larger image, or another start");
      }
    }
    return camera;
  }

 private:
  /// How far behind its beginning a leg is seen from.
  double viewDistance(const TourLeg& leg) const {
    const auto own = static_cast<double>(leg.cells.size());
    const auto after = static_cast<double>(leg.cellsAfter);
    const double scale = std::sqrt(after / (after + options_.nearness * own));  // of a length at the end of the leg
    return std::max(kMinDistance * width_, lengthOf(leg) * scale / (1 - scale));
  }
  double lengthOf(const TourLeg& leg) const {
    return static_cast<double>(leg.cells.size()) * static_cast<double>(maze_.cellSize);
  }

  /// The root, and the first leg.
  GraphCamera beforeStart(int width, int height) {
    const TourLeg& leg = legs_.front();
    MazeStart start = startOf(maze_, {leg.cells.front(), leg.heading, eyeHeight_, lengthOfAll()}, width, height);
    const glm::dvec3 viewpoint =
        (start.left + start.right) / 2.0 - start.heading * viewDistance(leg) + glm::dvec3(0, eyeHeight_, 0);
    const Plane plane = Plane::through(start.left, start.heading);
    frustumOf_.front() =
        start.camera.bend(start.frustum, {plane, viewpoint}, "start",
                          partBetween(start.camera, start.frustum, start.left, start.right, eyeHeight_));
    start.camera.limit(start.frustum, plane);
    return std::move(start.camera);
  }
  double lengthOfAll() const { return static_cast<double>(maze_.cellCount()) * static_cast<double>(maze_.cellSize); }

  void endAtWalls(GraphCamera& camera, size_t i) const {
    const TourLeg& leg = legs_[i];
    // With the cell before it, where its rays turned.
    Box box = maze_.clearBox(leg.cells.front().neighbor(opposite(leg.heading)));
    const Box last = maze_.clearBox(leg.cells.back());
    box.add(last.lower);
    box.add(last.upper);
    limitToBox(camera, frustumOf_[i], box);
  }

  void addChildren(GraphCamera& camera, const TourLeg& leg, int frustum) {
    if (leg.children.empty()) {
      return;
    }
    std::array<double, 3> weights{};
    WaysOut ways;
    for (const int child : leg.children) {
      const TourLeg& next = legs_[static_cast<size_t>(child)];
      const size_t side = sideOf(leg, next);
      weights[side] = std::pow(static_cast<double>(next.cells.size() + next.cellsAfter), options_.evenness);
      ways.way[side].viewDistance = viewDistance(next);
    }
    const std::array<double, 3> shares = widthsOf(weights);
    for (size_t side = 0; side < 3; ++side) {
      ways.way[side].share = shares[side];
    }
    ways.depth = shares[1] > 0 ? shares[1] : 1;  // one viewpoint for all of a crossing
    const std::array<int, 3> added =
        addWaysOut(camera, frustum, maze_, leg.cells.back(), leg.heading, ways, eyeHeight_);
    for (const int child : leg.children) {
      frustumOf_[static_cast<size_t>(child)] = added[sideOf(leg, legs_[static_cast<size_t>(child)])];
    }
  }

  static size_t sideOf(const TourLeg& leg, const TourLeg& next) {
    return next.heading == leftOf(leg.heading) ? 0 : next.heading == leg.heading ? 1 : 2;
  }

  /// Of the crossing's width, such that areas of the image are as the weights.
  static std::array<double, 3> widthsOf(const std::array<double, 3>& weights) {
    const double sides = weights[0] + weights[2];
    if (weights[1] == 0) {
      return {weights[0] / sides, 0, weights[2] / sides};
    }
    // A width f ahead keeps f^2 of the area, as the image of the way grows to all sides. A side of width s keeps all of
    // the height at E and f of it at S0. So f^2 sides = (1 - f) (1 + f) / 2 ahead.
    const double f = std::sqrt(weights[1] / (weights[1] + 2 * sides));
    return {(1 - f) * weights[0] / sides, f, (1 - f) * weights[2] / sides};
  }

  const Maze& maze_;
  const ComprehensiveOptions& options_;
  std::vector<TourLeg> legs_;
  std::vector<int> frustumOf_;
  double width_;
  double eyeHeight_;
};

}  // namespace

GraphCamera makeComprehensiveCamera(const Maze& maze, const ComprehensiveOptions& options, int width, int height) {
  if (options.start.has_value() != options.heading.has_value()) {
    throw InputError("the start is given without a heading, or a heading without a start", "comprehensive camera",
                     "give both, or none to begin at the entrance");
  }
  if (options.start) {
    checkCell(maze, *options.start, "comprehensive camera");
    const std::array<Direction, 3> ways{leftOf(*options.heading), *options.heading, rightOf(*options.heading)};
    if (std::none_of(ways.begin(), ways.end(), [&](Direction way) { return maze.isOpen(*options.start, way); })) {
      throw InputError(fmt::format("a wall stands to the {} of the cell {}, and there is no way to the sides",
                                   nameOf(*options.heading), nameOf(*options.start)),
                       "comprehensive camera", "head for an open side");
    }
    return ComprehensiveBuilder(maze, options, *options.start, *options.heading).build(width, height);
  }
  if (!maze.entrance) {
    throw InputError("the maze has no entrance", "comprehensive camera", "give a \"start\" and a \"heading\"");
  }
  return ComprehensiveBuilder(maze, options, maze.entrance->cell, maze.entrance->heading).build(width, height);
}

ComprehensiveOptions readComprehensiveOptions(JsonFields& fields) {
  ComprehensiveOptions options;
  const std::string order = fields.text("order", "breadth_first");
  if (order != "breadth_first" && order != "depth_first") {
    fields.fail("order", "is \"" + order + "\", but must be breadth_first or depth_first");
  }
  options.order = order == "breadth_first" ? TourOrder::kBreadthFirst : TourOrder::kDepthFirst;
  const int row = fields.integer("start_row", 0, kMaxMazeSide - 1, -1);
  const int column = fields.integer("start_column", 0, kMaxMazeSide - 1, -1);
  if ((row < 0) != (column < 0)) {
    fields.fail(row < 0 ? "start_row" : "start_column", "is missing, as only half of the start is given");
  }
  if (row >= 0) {
    options.start = MazeCell{row, column};
  }
  options.heading = readDirection(fields, "heading");
  options.eyeHeight = fields.number("eye_height", 1, 10, options.eyeHeight);
  options.nearness = fields.number("nearness", 0.1, 100, options.nearness);
  options.evenness = fields.number("evenness", 0, 1, options.evenness);
  return options;
}

}  // namespace ocelli
