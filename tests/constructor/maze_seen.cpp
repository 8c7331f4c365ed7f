#include "tests/constructor/maze_seen.h"

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>

#include "oc_core/base/random.h"
#include "oc_core/render/rasterize_graph.h"
#include "oc_core/scene/scene.h"
#include "oc_core/worlds/maze_generator.h"
#include "oc_core/worlds/maze_mesh.h"
#include "oc_core/worlds/solids.h"

namespace ocelli::test {
namespace {

Maze makeMaze(uint64_t seed) {
  MazeOptions options;
  options.seed = seed;
  options.rows = 6 + static_cast<int>(seed % 5);
  options.columns = 6 + static_cast<int>(seed / 5 % 5);
  options.loops = 0.1 * static_cast<double>(seed % 4);
  options.minFourWay = seed % 3;
  return generateMaze(options);
}

/// Triangles that are seen edge on may leave single pixels behind the plane where a ray turns.
constexpr size_t kMinRegion = 4;

/// Of the pixels of an object: 8-connected, the largest and all others of kMinRegion pixels.
size_t countRegions(const Image<uint32_t>& identity, uint32_t object) {
  Image<uint8_t> seen(identity.width(), identity.height());
  std::vector<std::pair<int, int>> stack;
  std::vector<size_t> sizes;
  for (int y = 0; y < identity.height(); ++y) {
    for (int x = 0; x < identity.width(); ++x) {
      if (identity(x, y) != object || seen(x, y) != 0) {
        continue;
      }
      sizes.push_back(0);
      seen(x, y) = 1;
      stack.push_back({x, y});
      while (!stack.empty()) {
        const auto [u, v] = stack.back();
        stack.pop_back();
        ++sizes.back();
        for (int ny = std::max(v - 1, 0); ny <= std::min(v + 1, identity.height() - 1); ++ny) {
          for (int nx = std::max(u - 1, 0); nx <= std::min(u + 1, identity.width() - 1); ++nx) {
            if (identity(nx, ny) == object && seen(nx, ny) == 0) {
              seen(nx, ny) = 1;
              stack.push_back({nx, ny});
            }
          }
        }
      }
    }
  }
  const auto counted = std::count_if(sizes.begin(), sizes.end(), [](size_t size) { return size >= kMinRegion; });
  return sizes.empty() ? 0 : std::max<size_t>(1, static_cast<size_t>(counted));
}

Image<uint32_t> identityImage(const FragmentImage& fragments, const std::vector<uint32_t>& objectOfTriangle) {
  Image<uint32_t> identity(fragments.width(), fragments.height());
  for (size_t i = 0; i < fragments.size(); ++i) {
    identity[i] = fragments[i].covered() ? objectOfTriangle[fragments[i].triangle] : 0;
  }
  return identity;
}

size_t regionsAlone(const GraphCamera& camera, const GuidedScene& scene, uint32_t object) {
  Mesh alone = scene.mesh;
  alone.triangles.clear();
  for (size_t i = 0; i < scene.mesh.triangles.size(); ++i) {
    if (scene.objectOfTriangle[i] == object) {
      alone.triangles.push_back(scene.mesh.triangles[i]);
    }
  }
  const std::vector<uint32_t> objects(alone.triangles.size(), object);
  return countRegions(identityImage(rasterize(camera, alone), objects), object);
}

bool isInClearBox(const Maze& maze, const MazeCell& cell, const glm::vec3& point) {
  const Box box = maze.clearBox(cell);
  const float rounding = 1e-4f * maze.cellSize;  // of coordinates in single precision
  for (int axis = 0; axis < 3; ++axis) {
    if (!(point[axis] >= box.lower[axis] - rounding && point[axis] <= box.upper[axis] + rounding)) {
      return false;
    }
  }
  return true;
}

}  // namespace

MazeWithObjects::MazeWithObjects(uint64_t seed) : maze(makeMaze(seed)) {
  Scene parts = makeMazeScene(maze);
  std::vector<MazeCell> free;
  for (int row = 0; row < maze.rows(); ++row) {
    for (int column = 0; column < maze.columns(); ++column) {
      const MazeCell cell{row, column};
      if (std::none_of(maze.landmarks.begin(), maze.landmarks.end(),
                       [&](const Landmark& l) { return l.cell == cell; })) {
        free.push_back(cell);
      }
    }
  }
  Random random(seed);
  random.shuffle(free);
  objects = maze.landmarks.size();
  for (size_t i = 0; i < maze.landmarks.size() && i < free.size(); ++i) {
    const float radius = 0.1f * maze.cellSize;
    Mesh mesh = i % 2 == 0 ? makeSphere(16) : makeBox(glm::vec3(0.7f));
    const float reach = 0.3f * maze.cellSize;
    const float east = random.inRange(-reach, reach);
    const float south = random.inRange(-reach, reach);
    const glm::vec3 at = maze.centerOf(free[i]) + glm::vec3(east, radius, south);
    transform(mesh, glm::scale(glm::translate(glm::mat4(1), at), glm::vec3(radius)));
    parts.add(mesh);
    parts.instances.back().object = static_cast<uint32_t>(++objects);
  }
  scene = {flatten(parts), objectOfTriangles(parts), parts.guides};
}

SeenMaze seenMaze(const GraphCamera& camera, const Maze& maze, const GuidedScene& scene, size_t objects) {
  const FragmentImage fragments = rasterize(camera, scene.mesh);
  const Image<uint32_t> identity = identityImage(fragments, scene.objectOfTriangle);
  SeenMaze seen;
  seen.cellPixels.assign(maze.cellCount(), 0);
  seen.objectPixels.assign(objects, 0);
  for (int y = 0; y < fragments.height(); ++y) {
    for (int x = 0; x < fragments.width(); ++x) {
      const Fragment& fragment = fragments(x, y);
      if (!fragment.covered()) {
        continue;
      }
      const glm::vec3 point = positionOf(fragment, scene.mesh);
      const auto cell = maze.cellAt(point);
      if (cell && isInClearBox(maze, *cell, point)) {
        ++seen.cellPixels[maze.indexOf(*cell)];
      }
      const uint32_t object = identity(x, y);
      if (object != 0) {
        ++seen.objectPixels[object - 1];
      }
      if (object != 0 || (x + y) % 7 == 0) {  // of all else a sample
        const auto back = camera.projectExactly(glm::dvec3(point));
        const double away = back ? std::hypot(back->u - x - 0.5, back->v - y - 0.5) : 1e9;
        if (away > 1) {
          ++(object != 0 ? seen.strayObjectPixels : seen.strayPixels);
        } else {
          seen.worstReturn = std::max(seen.worstReturn, away);
        }
      }
    }
  }
  for (uint32_t object = 1; object <= objects; ++object) {
    const size_t regions = countRegions(identity, object);
    seen.regions.push_back(regions > 1 ? regionsAlone(camera, scene, object) : regions);
  }
  return seen;
}

}  // namespace ocelli::test
