#include "oc_core/constructor/crossing_frusta.h"

#include <algorithm>
#include <cmath>

#include "oc_core/base/error.h"
#include "oc_core/constructor/image_parts.h"

namespace ocelli {
namespace {

/// Where a way begins beyond the box, in widths: the planes at which rays turn must not touch.
constexpr double kBeyond = 1e-4;

/// How far rays go into walls and floor before they end, in sizes of the room: surfaces must not lie at their ends,
/// where rounding would decide. Less than an overlap that counts (graph_overlap.h); more than kBeyond, so that rays
/// that pass just below the beginning of a way meet the floor before it.
constexpr double kIntoWalls = 2e-4;

/// The vertical plane through two points, its normal to the side of `towards`.
Plane wallThrough(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& up, const glm::dvec3& towards) {
  const glm::dvec3 normal = glm::normalize(glm::cross(b - a, up));
  return Plane::through(a, glm::dot(normal, towards) > 0 ? normal : -normal);
}

class Crossing {
 public:
  Crossing(GraphCamera& camera, int i, const Maze& maze, const MazeCell& cell, Direction heading, const WaysOut& ways,
           double eyeHeight)
      : camera_(camera),
        in_(i),
        room_(maze.clearBox(cell)),
        name_("crossing " + nameOf(cell)),
        frame_(maze, cell, heading),
        ways_(ways),
        eye_(eyeHeight),
        tall_(std::max(frame_.height, eyeHeight)),
        depth_(ways.depth * frame_.width) {}

  std::array<int, 3> add() {
    std::array<int, 3> out{-1, -1, -1};
    if (ways_.way[0].share > 0) {
      out[0] = addSide(frame_, ways_.way[0], "left");
    }
    if (ways_.way[1].share > 0 && ways_.way[1].viewDistance > 0) {
      out[1] = addAhead();
    }
    if (ways_.way[2].share > 0) {
      out[2] = addSide(frame_.mirrored(), ways_.way[2], "right");
    }
    return out;
  }

 private:
  /// To the left of `frame`.
  int addSide(const CrossingFrame& frame, const WayOut& way, const std::string& side) {
    const double w = frame.width;
    const glm::dvec3 near = frame.at(0, 0);
    const glm::dvec3 turn = frame.at(way.share * w, depth_);
    const glm::dvec3 left = -frame.right;
    const Plane plane = wallThrough(near, turn, frame.up, left);
    const std::string name = name_ + ", " + side;
    const GraphCamera::Part part = partBetween(camera_, in_, near, turn, tall_);
    if (ways_.depth >= 1) {
      return bendPart(in_, {plane, frame.at(way.share * w / 2 + way.viewDistance, w / 2, eye_)}, name, part);
    }
    // On the line S0-Pl, as far ahead as E.
    const int fan = bendPart(in_, {plane, frame.at(way.share * w * w / (w - depth_), 0, eye_)}, name, part);
    endInBox(fan);
    return addCorridor(fan, {frame.at(-kBeyond * w, 0), frame.at(-kBeyond * w, w), left}, way, name);
  }

  int addAhead() {
    const double w = frame_.width;
    const double x0 = ways_.way[0].share * w;
    const double x1 = (1 - ways_.way[2].share) * w;
    const glm::dvec3 a = frame_.at(x0, depth_);
    const glm::dvec3 b = frame_.at(x1, depth_);
    const std::string name = name_ + ", ahead";
    const Mouth mouth{frame_.at(0, (1 + kBeyond) * w), frame_.at(w, (1 + kBeyond) * w), frame_.ahead};
    if (!(x1 - x0 < w)) {
      return addCorridor(in_, mouth, ways_.way[1], name);
    }
    // Where the lines S0-Pl and S1-Pr meet.
    const double before = (w - depth_) * (x1 - x0) / (w - (x1 - x0));
    const Plane plane = wallThrough(a, b, frame_.up, frame_.ahead);
    const glm::dvec3 viewpoint = straightened(plane, frame_.at(x0 + before * x0 / (w - depth_), depth_ - before, eye_));
    const int fan = bendPart(in_, {plane, viewpoint}, name, partBetween(camera_, in_, a, b, tall_));
    endInBox(fan);
    return addCorridor(fan, mouth, ways_.way[1], name);
  }

  struct Mouth {
    glm::dvec3 a;
    glm::dvec3 b;
    glm::dvec3 heading;
  };
  int addCorridor(int fan, const Mouth& mouth, const WayOut& way, const std::string& name) {
    const Plane plane = Plane::through(mouth.a, mouth.heading);
    glm::dvec3 viewpoint = (mouth.a + mouth.b) / 2.0 - mouth.heading * way.viewDistance + frame_.up * eye_;
    if (glm::dot(mouth.heading, frame_.ahead) > 0.5) {
      viewpoint = straightened(plane, viewpoint);
    }
    return bendPart(fan, {plane, viewpoint}, name + ", corridor", partBetween(camera_, fan, mouth.a, mouth.b, tall_));
  }

  void endInBox(int fan) {
    if (ways_.endInBox) {
      limitToBox(camera_, fan, room_);
    }
  }

  /// The viewpoint for rays beyond a plane whose directions are between those from `viewpoint` and those of the rays
  /// that come in.
  glm::dvec3 straightened(const Plane& plane, const glm::dvec3& viewpoint) const {
    const glm::dvec3& from = camera_.frusta()[static_cast<size_t>(in_)].viewpoint;
    const double one = (1 - ways_.straight) / plane.height(viewpoint);
    const double other = ways_.straight / plane.height(from);
    return (viewpoint * one + from * other) / (one + other);
  }

  int bendPart(int i, const GraphCamera::Bend& turn, const std::string& name, const GraphCamera::Part& part) {
    if (part.empty()) {
      throw InputError("too few pixels are left for it", "graph camera, frustum \"" + name + "\"",
                       "use a larger image, or give its way a larger share");
    }
    return camera_.bend(i, turn, name, part);
  }

  GraphCamera& camera_;
  int in_;
  Box room_;
  std::string name_;
  CrossingFrame frame_;
  WaysOut ways_;
  double eye_;
  double tall_;  ///< of what is seen through a way
  double depth_;
};

}  // namespace

CrossingFrame::CrossingFrame(const Maze& maze, const MazeCell& cell, Direction heading)
    : right(vectorOf(rightOf(heading))),
      ahead(vectorOf(heading)),
      width(static_cast<double>(maze.cellSize) - static_cast<double>(maze.wallThickness)),
      height(maze.wallHeight) {
  corner = glm::dvec3(maze.centerOf(cell)) - (right + ahead) * (width / 2);
}

CrossingFrame CrossingFrame::mirrored() const {
  CrossingFrame other = *this;
  other.corner += right * width;
  other.right = -right;
  return other;
}

std::array<int, 3> addWaysOut(GraphCamera& camera, int i, const Maze& maze, const MazeCell& cell, Direction heading,
                              const WaysOut& ways, double eyeHeight) {
  return Crossing(camera, i, maze, cell, heading, ways, eyeHeight).add();
}

GraphCamera::Part partBetween(const GraphCamera& camera, int i, const glm::dvec3& a, const glm::dvec3& b,
                              double height) {
  const GraphCamera::Frustum& frustum = camera.frusta()[static_cast<size_t>(i)];
  const glm::dvec3 up(0, height, 0);
  GraphCamera::Part part;
  for (const glm::dvec3& point : {a + up, b + up, b, a}) {
    const glm::dvec4 h = frustum.pixelFromWorld * glm::dvec4(point, 1);
    part.push_back(glm::dvec2(h) / h.w);
  }
  if (part[0].x > part[1].x) {
    std::reverse(part.begin(), part.end());
  }
  return common(part, frustum.part);
}

void limitToBox(GraphCamera& camera, int i, const Box& box) {
  const glm::vec3 size = box.size();
  const double into = kIntoWalls * static_cast<double>(std::min({size.x, size.y, size.z}));
  const glm::dvec3 lower = glm::dvec3(box.lower) - into;
  const glm::dvec3 upper = glm::dvec3(box.upper) + into;
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 normal(0);
    normal[axis] = -1;
    camera.limit(i, Plane::through(lower, normal));
    if (axis != 1) {
      camera.limit(i, Plane::through(upper, -normal));
    }
  }
}

}  // namespace ocelli
