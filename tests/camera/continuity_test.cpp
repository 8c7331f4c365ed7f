// An object that moves through a camera moves on in its image without a jump, but across split lines; and rays of
// curved ray cameras bend without a corner and do not cross, whatever the turns.
#include <gtest/gtest.h>

#include <array>

#include "oc_core/camera/graph_overlap.h"
#include "tests/camera/random_curved_cameras.h"

namespace ocelli {
namespace {

using test::Numbers;
using test::randomCurved;
using test::randomGraph;

constexpr int kSteps = 300;  // along a path

glm::dvec2 pixelOf(const ExactImagePoint& q) {
  return {q.u, q.v};
}

/// A bent path from one point that the camera sees to another.
class Path {
 public:
  template <class C>
  Path(Numbers& numbers, const C& camera, double farthest) {
    for (glm::dvec3& corner : corners_) {
      std::optional<glm::dvec3> seen;
      while (!seen) {
        seen = camera.unprojectExactly(
            {numbers.between(0, camera.width()), numbers.between(0, camera.height()), numbers.between(4, farthest)});
      }
      corner = *seen;
    }
  }
  glm::dvec3 at(double t) const {
    return corners_[0] * (1 - t) * (1 - t) + corners_[1] * 2.0 * t * (1 - t) + corners_[2] * t * t;
  }

 private:
  std::array<glm::dvec3, 3> corners_;
};

/// How far a point of frustum i may move in the image for each unit that it moves in the world (Frobenius norm of the
/// derivative of its projection).
double speedIn(const GraphCamera& graph, int i, const glm::dvec3& point) {
  const glm::dmat4 rows = glm::transpose(graph.frusta()[static_cast<size_t>(i)].pixelFromWorld);
  const glm::dvec4 h = graph.frusta()[static_cast<size_t>(i)].pixelFromWorld * glm::dvec4(point, 1);
  const glm::dvec3 du = (glm::dvec3(rows[0]) - glm::dvec3(rows[3]) * (h.x / h.w)) / h.w;
  const glm::dvec3 dv = (glm::dvec3(rows[1]) - glm::dvec3(rows[3]) * (h.y / h.w)) / h.w;
  return std::sqrt(glm::dot(du, du) + glm::dot(dv, dv));
}

/// A step along a path, and which frusta hold its ends.
struct PathStep {
  double from = 0;
  double to = 0;
  int first = -1;
  int second = -1;
};

/// What is left of a step at the place where it leaves its first frustum.
PathStep cutDown(const GraphCamera& graph, const Path& way, PathStep step) {
  for (int halving = 0; halving < 45; ++halving) {
    const double middle = (step.from + step.to) / 2;
    const int between = graph.frustumOf(way.at(middle));
    (between == step.first ? step.from : step.to) = middle;
    step.second = between == step.first ? step.second : between;
  }
  return step;
}

double moved(const GraphCamera& graph, const Path& way, const PathStep& step) {
  return glm::distance(pixelOf(*graph.projectExactly(way.at(step.from))),
                       pixelOf(*graph.projectExactly(way.at(step.to))));
}

/// Whether one of the frusta begins where the other ends, and the point is there.
bool isAtPlane(const GraphCamera& graph, const PathStep& step, const glm::dvec3& point) {
  const GraphCamera::Frustum& later = graph.frusta()[static_cast<size_t>(std::max(step.first, step.second))];
  return later.parent == std::min(step.first, step.second) && std::abs(later.plane.height(point)) < 1e-8;
}

/// Distance of the image of a point from the border of a frustum's part.
double fromBorder(const GraphCamera& graph, int i, const glm::dvec3& point) {
  const GraphCamera::Part& part = graph.frusta()[static_cast<size_t>(i)].part;
  double least = 1e30;
  for (size_t k = 0; k < part.size(); ++k) {
    const glm::dvec2 along = glm::normalize(part[(k + 1) % part.size()] - part[k]);
    const glm::dvec2 to = pixelOf(*graph.projectExactly(point)) - part[k];
    least = std::min(least, std::abs(along.x * to.y - along.y * to.x));
  }
  return least;
}

/// Of the diagonal of the world: an overlap of the default size would be a tenth of a pixel, and let jumps begin as far
/// from a border.
constexpr double kThinOverlap = 1e-7;

TEST(Continuity, ofGraphCamerasButAcrossSplitLines) {
  Numbers numbers;
  size_t cameras = 0;
  size_t within = 0;
  size_t crossings = 0;
  size_t jumps = 0;
  double worstShare = 0;  // of the bound
  double worstRest = 0;   // pixels, once the step is cut down to rounding
  while (cameras < 80) {
    const GraphCamera graph = randomGraph(numbers, 6, 0.2);
    if (graph.frusta().size() < 3 || !overlapsOf(graph, glm::dvec3(-40), glm::dvec3(40), kThinOverlap).empty()) {
      continue;
    }
    ++cameras;
    for (int path = 0; path < 20; ++path) {
      const Path way(numbers, graph, 25);
      for (int k = 0; k < kSteps; ++k) {
        PathStep step{static_cast<double>(k) / kSteps, static_cast<double>(k + 1) / kSteps};
        step.first = graph.frustumOf(way.at(step.from));
        step.second = graph.frustumOf(way.at(step.to));
        if (step.first < 0 || step.second < 0) {
          continue;
        }
        const double bound =
            std::max(speedIn(graph, step.first, way.at(step.from)), speedIn(graph, step.second, way.at(step.to))) *
            glm::distance(way.at(step.from), way.at(step.to));
        const double share = moved(graph, way, step) / bound;
        if (step.first == step.second) {
          ++within;
          worstShare = std::max(worstShare, share);
          continue;
        }
        step = cutDown(graph, way, step);
        if (step.second < 0) {
          continue;  // out of sight between the two
        }
        if (isAtPlane(graph, step, way.at(step.from))) {
          ++crossings;
          worstShare = std::max(worstShare, share);
          worstRest = std::max(worstRest, moved(graph, way, step));
          EXPECT_NEAR(graph.projectExactly(way.at(step.from))->t, graph.projectExactly(way.at(step.to))->t, 1e-9);
        } else {
          // A jump, then: from the border of one part to that of another.
          ++jumps;
          EXPECT_LT(fromBorder(graph, step.first, way.at(step.from)), 1e-3);
          EXPECT_LT(fromBorder(graph, step.second, way.at(step.to)), 1e-3);
        }
      }
    }
  }
  EXPECT_GT(within, 300000u);
  EXPECT_GT(crossings, 1500u);
  EXPECT_GT(jumps, 20u);
  EXPECT_LT(worstShare, 1);
  EXPECT_LT(worstRest, 1e-9);
}

// Both viewpoints lie in the plane x = 0 of the split line, so that the parts touch there all the way, and show the
// same points at different heights.
TEST(Continuity, ofGraphCamerasEndsAtSplitLines) {
  GraphCamera graph(test::smallCamera());
  graph.split(0, test::turnAt({0, 0, 0.5}, {-0.3, 0, -1}, {0, 0, 7}),
              test::turnAt({0, 0, 0.5}, {0.3, 0, -1}, {0, 0.5, 5}), "left", "right");
  const auto left = graph.projectExactly({-1e-5, 0.2, -3});
  const auto right = graph.projectExactly({1e-5, 0.2, -3});
  ASSERT_TRUE(left && right);
  EXPECT_NEAR(left->u, right->u, 1e-3);
  // Where (0, 0.2, -3) is seen from (0, 0, 7) and (0, 0.5, 5), on the line x = 0, z = 0.5.
  const double focal = static_cast<double>(graph.root().focalPixels());
  EXPECT_NEAR(left->v, 30 - focal * (0.2 * 6.5 / 10) / 9.5, 1e-3);
  EXPECT_NEAR(right->v, 30 - focal * (0.5 - 0.3 * 4.5 / 8) / 9.5, 1e-3);
}

/// As speedIn(), by differences.
double speedIn(const CurvedRayCamera& camera, const glm::dvec3& point) {
  constexpr double kStep = 1e-6;
  double sum = 0;
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 step(0);
    step[axis] = kStep;
    const auto before = camera.projectExactly(point - step);
    const auto beyond = camera.projectExactly(point + step);
    if (!before || !beyond) {
      return std::numeric_limits<double>::infinity();
    }
    const glm::dvec2 slope = (pixelOf(*beyond) - pixelOf(*before)) / (2 * kStep);
    sum += glm::dot(slope, slope);
  }
  return std::sqrt(sum);
}

/// The image of a point, if it is within the borders.
std::optional<ExactImagePoint> imageIn(const CurvedRayCamera& camera, const glm::dvec3& point) {
  const auto q = camera.projectExactly(point);
  const bool inside = q && q->u >= 0 && q->v >= 0 && q->u <= camera.width() && q->v <= camera.height();
  return inside ? q : std::nullopt;
}

/// The first of the planes that turns begin and end with that two points are on different sides of.
const Plane* planeBetween(const CurvedRayCamera& camera, const glm::dvec3& a, const glm::dvec3& b) {
  for (const RayTransition& turn : camera.bends()) {
    for (const Plane* plane : {&turn.planes().from, &turn.planes().to}) {
      if ((plane->height(a) < 0) != (plane->height(b) < 0)) {
        return plane;
      }
    }
  }
  return nullptr;
}

TEST(Continuity, ofCurvedRayCameras) {
  Numbers numbers;
  size_t steps = 0;
  size_t crossings = 0;
  double worstShare = 0;
  double worstRest = 0;
  for (int k = 0; k < 40; ++k) {
    const CurvedRayCamera camera = randomCurved(numbers, 1 + k % 8);
    const double farthest = 15 + 5 * static_cast<double>(camera.bends().size());
    for (int path = 0; path < 5; ++path) {
      const Path way(numbers, camera, farthest);
      for (int step = 0; step < kSteps; ++step) {
        double from = static_cast<double>(step) / kSteps;
        double to = static_cast<double>(step + 1) / kSteps;
        const auto first = imageIn(camera, way.at(from));
        const auto second = imageIn(camera, way.at(to));
        if (!first || !second) {
          continue;
        }
        const double bound = std::max(speedIn(camera, way.at(from)), speedIn(camera, way.at(to))) *
                             glm::distance(way.at(from), way.at(to));
        ++steps;
        worstShare = std::max(worstShare, glm::distance(pixelOf(*first), pixelOf(*second)) / bound);
        const Plane* plane = planeBetween(camera, way.at(from), way.at(to));
        if (plane == nullptr) {
          continue;
        }
        const bool below = plane->height(way.at(from)) < 0;
        for (int halving = 0; halving < 45; ++halving) {
          const double middle = (from + to) / 2;
          ((plane->height(way.at(middle)) < 0) == below ? from : to) = middle;
        }
        const auto before = camera.projectExactly(way.at(from));
        const auto beyond = camera.projectExactly(way.at(to));
        ASSERT_TRUE(before && beyond);
        ++crossings;
        worstRest = std::max(worstRest, glm::distance(pixelOf(*before), pixelOf(*beyond)));
        EXPECT_NEAR(before->t, beyond->t, 1e-7 * before->t);
      }
    }
  }
  EXPECT_GT(steps, 40000u);
  EXPECT_GT(crossings, 500u);
  EXPECT_LT(worstShare, 1) << "of the speed at the faster end of a step";
  EXPECT_LT(worstRest, 1e-9);
}

TEST(Continuity, raysOfCurvedRayCamerasHaveNoCorners) {
  Numbers numbers;
  size_t joints = 0;
  size_t most = 0;
  for (int k = 0; k < 100; ++k) {
    const CurvedRayCamera camera = randomCurved(numbers, 1 + k % 8);
    most = std::max(most, camera.bends().size());
    for (int ray = 0; ray < 20; ++ray) {
      const double u = numbers.between(0, camera.width());
      const double v = numbers.between(0, camera.height());
      const auto at = [&](double z) { return *camera.unprojectExactly({u, v, z}); };
      for (const RayTransition& turn : camera.bends()) {
        for (const Plane* plane : {&turn.planes().from, &turn.planes().to}) {
          // Where the ray crosses the plane; before that it is before it.
          double before = 0.02;
          double beyond = 500;
          for (int halving = 0; halving < 45; ++halving) {
            const double middle = (before + beyond) / 2;
            (plane->height(at(middle)) < 0 ? before : beyond) = middle;
          }
          const auto corner = [&](double step) {
            const glm::dvec3 in = glm::normalize(at(before) - at(before - step));
            const glm::dvec3 out = glm::normalize(at(before + step) - at(before));
            return glm::length(glm::cross(in, out));
          };
          ++joints;
          // A tenth of the step, a tenth of the angle: all of it is curvature.
          ASSERT_LT(corner(1e-3), 1e-2);
          ASSERT_LT(corner(1e-4), 0.11 * corner(1e-3) + 1e-8) << "which is rounding";
        }
      }
    }
  }
  EXPECT_GT(joints, 10000u);
  EXPECT_EQ(most, 8u);
}

// 10^5 pairs.
TEST(Continuity, raysOfCurvedRayCamerasDoNotCross) {
  Numbers numbers;
  for (int k = 0; k < 200; ++k) {
    const CurvedRayCamera camera = randomCurved(numbers, 1 + k % 8);
    for (int pair = 0; pair < 500; ++pair) {
      const glm::dvec2 a(numbers.between(0, camera.width()), numbers.between(0, camera.height()));
      const glm::dvec2 b(numbers.between(0, camera.width()), numbers.between(0, camera.height()));
      const double z = numbers.between(5, 15 + 5 * static_cast<double>(camera.bends().size()));
      const glm::dvec3 point = *camera.unprojectExactly({a.x, a.y, z});
      const auto q = camera.projectExactly(point);
      ASSERT_TRUE(q);
      // A point of one ray projects to that ray alone, and none of the other is there.
      ASSERT_LT(glm::distance(pixelOf(*q), a), 1e-9);
      // Pixels are 5 / 298 apart where z is 5, and rays only part from there.
      ASSERT_GT(glm::distance(point, *camera.unprojectExactly({b.x, b.y, z})), 0.016 * glm::distance(a, b));
    }
  }
}

}  // namespace
}  // namespace ocelli
