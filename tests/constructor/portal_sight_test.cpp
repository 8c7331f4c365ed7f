// Why no frame of a portal camera jumps where the head turns, and where openings come in at the border of the image or
// from behind walls: no ray of it moves then. And that the usual curve shows all openings in view that are far enough.
#include <gtest/gtest.h>

#include <cstdio>
#include <glm/geometric.hpp>

#include "oc_core/base/conventions.h"
#include "oc_core/constructor/image_parts.h"
#include "oc_core/constructor/maze_openings.h"
#include "oc_core/constructor/portal_constructor.h"
#include "oc_core/render/rasterize_graph.h"
#include "oc_core/worlds/maze_generator.h"
#include "oc_core/worlds/scene_source.h"
#include "oc_core/worlds/town_plan.h"
#include "tests/constructor/image_motion.h"
#include "tests/constructor/random_walk.h"

namespace ocelli {
namespace {

/// A place in a corridor, and a direction to look in.
View anyView(const Maze& maze, Random& random) {
  for (;;) {
    const glm::vec3 eye(random.inRange(0, maze.cellSize * static_cast<float>(maze.columns())), test::kEyeHeight,
                        random.inRange(0, maze.cellSize * static_cast<float>(maze.rows())));
    if (!maze.isInWall(eye)) {
      const float angle = random.inRange(0, 6.28f);
      return test::viewAt(eye, {std::cos(angle), std::sin(angle)});
    }
  }
}

View turnedBy(const View& view, float angle) {
  const glm::vec3 ahead = view.target - view.eye;
  View turned = view;
  turned.target = view.eye + glm::vec3(ahead.x * std::cos(angle) - ahead.z * std::sin(angle), ahead.y,
                                       ahead.x * std::sin(angle) + ahead.z * std::cos(angle));
  return turned;
}

/// Whether a pixel is nowhere near the border of a part, where rounding decides to which side it belongs.
bool isInside(const GraphCamera& camera, const glm::vec2& pixel) {
  const int child = camera.childAt(GraphCamera::kRoot, pixel);
  for (const glm::vec2 aside : {glm::vec2(0.02f, 0), glm::vec2(-0.02f, 0), glm::vec2(0, 0.02f), glm::vec2(0, -0.02f)}) {
    if (camera.childAt(GraphCamera::kRoot, pixel + aside) != child) {
      return false;
    }
  }
  return true;
}

/// Compares the rays of both cameras that leave the eye in the same direction. How many of them bend.
size_t compareRays(const GraphCamera& before, const GraphCamera& after, Random& random) {
  size_t bent = 0;
  for (int i = 0; i < 200; ++i) {
    const glm::vec2 pixel(random.inRange(1, 159), random.inRange(1, 89));
    const std::optional<ImagePoint> there = after.root().project(before.root().rayPath(pixel).back());
    if (!there || there->u < 1 || there->u > 159 || there->v < 1 || there->v > 89 || !isInside(before, pixel) ||
        !isInside(after, {there->u, there->v})) {
      continue;
    }
    const RayPath one = before.rayPath(pixel);
    const RayPath other = after.rayPath({there->u, there->v});
    EXPECT_EQ(one.size(), other.size());
    if (one.size() == 3 && other.size() == 3) {
      ++bent;
      // Single precision: a pixel is known to 1e-5 of its place, and rays that meet a portal at a grazing angle meet
      // it up to 30 times that far along.
      EXPECT_LT(glm::distance(one[1], other[1]), 0.02f);
      EXPECT_LT(glm::distance(glm::normalize(one[2] - one[1]), glm::normalize(other[2] - other[1])), 2e-3f);
    }
  }
  return bent;
}

TEST(PortalSight, noRayMovesWhenTheHeadTurns) {
  size_t bent = 0;
  Random random(11);
  SceneGuides town;
  town.portals = townPortals();
  for (uint64_t seed = 1; seed <= 30; ++seed) {
    MazeOptions options;
    options.seed = seed;
    SceneGuides maze;
    maze.maze = generateMaze(options);
    for (int i = 0; i < 10; ++i) {
      const View view = anyView(*maze.maze, random);
      const View turned = turnedBy(view, random.inRange(-0.7f, 0.7f));
      bent += compareRays(buildPortalCamera({}, maze, {view, 160, 90}), buildPortalCamera({}, maze, {turned, 160, 90}),
                          random);
      View street = view;
      street.eye = (view.eye - glm::vec3(10.5f, 0, 10.5f)) * glm::vec3(4, 1, 3);
      street.target = street.eye + (view.target - view.eye);
      View streetTurned = turned;
      streetTurned.eye = street.eye;
      streetTurned.target = street.eye + (turned.target - turned.eye);
      bent += compareRays(buildPortalCamera({}, town, {street, 160, 90}),
                          buildPortalCamera({}, town, {streetTurned, 160, 90}), random);
    }
  }
  EXPECT_GT(bent, 300u);
}

/// All openings of a maze, those behind walls too, but for those that the eye is behind.
std::vector<Portal> allOpenings(const Maze& maze, const glm::vec3& eye) {
  // Over the walls nothing hides any of them.
  std::vector<Portal> all = openingsInSight(maze, {eye.x, maze.origin.y + 2 * maze.wallHeight, eye.z});
  std::erase_if(all, [&](const Portal& each) { return glm::dot(each.normal, eye - each.center) <= 0; });
  return all;
}

TEST(PortalSight, whatWallsHideMakesNoDifference) {
  // So an opening that comes into sight, all at once in the list of those that are, changes no pixel.
  size_t more = 0;
  for (uint64_t seed = 1; seed <= 6; ++seed) {
    const GuidedScene scene = loadGuidedScene("builtin:maze,seed=" + std::to_string(seed), {.fit = false});
    Random random(seed);
    for (int i = 0; i < 12; ++i) {
      const PinholeCamera reference(anyView(*scene.guides.maze, random), 320, 180);
      SceneGuides all;
      all.portals = allOpenings(*scene.guides.maze, reference.eye());
      more += all.portals.size() - openingsInSight(*scene.guides.maze, reference.eye()).size();
      const Image<glm::vec3> inSight =
          colorImage(rasterize(buildPortalCamera({}, scene.guides, reference), scene.mesh), scene.mesh, glm::vec3(0));
      const Image<glm::vec3> ofAll =
          colorImage(rasterize(buildPortalCamera({}, all, reference), scene.mesh), scene.mesh, glm::vec3(0));
      size_t different = 0;
      for (size_t k = 0; k < ofAll.size(); ++k) {
        different += glm::distance(ofAll[k], inSight[k]) > 0.01f;
      }
      // Where the borders of parts run, surfaces are drawn up to 1/64 pixel beyond (straight_segment.h).
      EXPECT_LE(different, ofAll.size() / 1000) << "seed " << seed << ", view " << i;
    }
  }
  EXPECT_GT(more, 1000u);
}

TEST(PortalSight, everyOpeningInViewThatIsFarEnoughIsBentInFull) {
  const PortalOptions usual;
  size_t shown = 0;
  size_t faced = 0;
  size_t near = 0;
  size_t behind = 0;
  size_t giving = 0;
  double farthest = 0;
  for (uint64_t seed = 1; seed <= 80; ++seed) {
    MazeOptions options;
    options.seed = seed;
    options.rows = 5 + static_cast<int>(seed % 20);
    options.columns = 25 - static_cast<int>(seed % 20);
    SceneGuides guides;
    guides.maze = generateMaze(options);
    Random random(seed);
    for (const View& view : test::walkAlong(test::randomLine(*guides.maze, 6, random), 0, 0.5f, 20)) {
      const PinholeCamera reference(view, 1280, 720);
      const glm::dvec3 eye(reference.eye());
      const GraphCamera camera = buildPortalCamera({}, guides, reference);
      for (const Portal& portal : openingsInSight(*guides.maze, reference.eye())) {
        std::vector<glm::dvec3> corners;
        for (const glm::vec3& corner : portal.corners()) {
          corners.emplace_back(corner);
        }
        const GraphCamera::Part part = imagePart(corners, reference);
        if (part.empty()) {
          continue;
        }
        const glm::dvec3 offset = eye - glm::dvec3(portal.center);
        const double across = std::abs(glm::dot(offset, glm::normalize(glm::dvec3(portal.halfRight))));
        const double before = glm::dot(offset, glm::dvec3(portal.normal));
        const double beside = std::max(0.0, across - glm::length(glm::dvec3(portal.halfRight)));
        const double shorter = 2 * std::min(glm::length(portal.halfRight), glm::length(portal.halfUp));
        if (std::hypot(beside, before) < usual.bentBeyond * shorter) {
          ++near;
        } else if (std::atan2(across, before) < radiansFromDegrees(usual.bentDegrees)) {
          ++faced;
        } else {
          const glm::dvec2 middle = GraphCamera::middleOf(part);
          const int child = camera.childAt(GraphCamera::kRoot, middle);
          ASSERT_GE(child, 0) << "seed " << seed;
          const GraphCamera::Frustum& frustum = camera.frusta()[static_cast<size_t>(child)];
          if (!test::samePlane(frustum.plane, Plane::through(glm::dvec3(portal.center), -glm::dvec3(portal.normal)))) {
            ++behind;  // it would be seen through another one, whose rays bend
            continue;
          }
          if (glm::length(frustum.viewpoint - portalViewpoint(portal, eye, 1)) > 1e-9) {
            ++giving;  // it is seen through one that begins to bend, or ends
            continue;
          }
          farthest = std::max(farthest, glm::length(offset));
          ++shown;
        }
      }
    }
  }
  std::printf(
      "bent in full: %zu openings, up to %.0f m away; %zu nearer than where they collapse, %zu faced, %zu behind "
      "others that bend, %zu behind others that begin to\n",
      shown, farthest, near, faced, behind, giving);
  EXPECT_GT(shown, 450u);
  EXPECT_LT(giving, shown / 5);
  EXPECT_GT(farthest, 30);
}

}  // namespace
}  // namespace ocelli
