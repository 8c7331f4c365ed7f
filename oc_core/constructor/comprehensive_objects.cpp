#include "oc_core/constructor/comprehensive_objects.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <optional>
#include <set>

#include "oc_core/base/error.h"

namespace ocelli {
namespace {

constexpr size_t kPointsOfObject = 256;  // about, on the surface of an object
constexpr size_t kEnoughPixels = 2;      // of which rounding may take one
/// What is tried instead of the given options. Higher viewpoints look over objects; another order or other shares show
/// them from another side, or larger.
struct Variation {
  double eyeHeight = 1;  ///< factors of the given ones
  double nearness = 1;
  double evenness = 1;
  bool otherOrder = false;
};

constexpr Variation kVariations[] = {
    {},
    {1.25, 1, 1, false},
    {1, 1, 0.75, false},
    {1.5, 1, 1, false},
    {1, 0.67, 1.25, false},
    {1, 0.67, 0.75, false},
    {3, 1, 1, false},
    {1, 0.2, 1, false},
    {0.6, 0.67, 1, false},
    {5, 0.67, 1, false},
    {1, 1, 1, true},
    {1.5, 0.67, 1, true},
};

ComprehensiveOptions varied(const ComprehensiveOptions& options, const Variation& by) {
  ComprehensiveOptions other = options;
  other.eyeHeight = std::max(1.0, other.eyeHeight * by.eyeHeight);
  other.nearness *= by.nearness;
  other.evenness = std::min(1.0, other.evenness * by.evenness);
  if (by.otherOrder) {
    other.order = options.order == TourOrder::kBreadthFirst ? TourOrder::kDepthFirst : TourOrder::kBreadthFirst;
  }
  return other;
}

using Corners = std::array<glm::dvec3, 3>;

struct ObjectSurface {
  Box box;
  std::vector<Corners> triangles;
};

/// By identity; none of what is no object.
std::vector<ObjectSurface> surfacesOf(const GuidedScene& scene) {
  std::vector<ObjectSurface> surfaces;
  for (size_t i = 0; i < scene.objectOfTriangle.size(); ++i) {
    const size_t object = scene.objectOfTriangle[i];
    if (object == 0) {
      continue;
    }
    if (object >= surfaces.size()) {
      surfaces.resize(object + 1);
    }
    Corners corners;
    for (int k = 0; k < 3; ++k) {
      const glm::vec3& corner = scene.mesh.positions[scene.mesh.triangles[i][k]];
      surfaces[object].box.add(corner);
      corners[static_cast<size_t>(k)] = glm::dvec3(corner);
    }
    surfaces[object].triangles.push_back(corners);
  }
  return surfaces;
}

/// The share of a segment at which it meets a triangle, from either side.
std::optional<double> crossing(const Corners& corners, const glm::dvec3& from, const glm::dvec3& to) {
  const glm::dvec3 way = to - from;
  const glm::dvec3 one = corners[1] - corners[0];
  const glm::dvec3 other = corners[2] - corners[0];
  const glm::dvec3 across = glm::cross(way, other);
  const double volume = glm::dot(one, across);
  if (volume == 0) {
    return std::nullopt;
  }
  const glm::dvec3 offset = from - corners[0];
  const double u = glm::dot(offset, across) / volume;
  const glm::dvec3 up = glm::cross(offset, one);
  const double v = glm::dot(way, up) / volume;
  const double along = glm::dot(other, up) / volume;
  return u >= 0 && v >= 0 && u + v <= 1 && along >= 0 && along <= 1 ? std::optional(along) : std::nullopt;
}

/// Whether a segment runs through a wall between two cells of the maze, or a post. The outer walls are left out: rays
/// come in over them or at the entrance.
bool meetsWall(const Maze& maze, const glm::dvec3& from, const glm::dvec3& to) {
  const double size = static_cast<double>(maze.cellSize);
  const double half = static_cast<double>(maze.wallThickness) / 2;
  const glm::dvec3 start = from - glm::dvec3(maze.origin);
  const glm::dvec3 way = to - from;
  const double top = static_cast<double>(maze.wallHeight);
  // Across lines of the grid that run north, then across those that run east: at both faces of their walls.
  for (const bool north : {true, false}) {
    const int across = north ? 0 : 2;
    const int along = north ? 2 : 0;
    const int lines = north ? maze.columns() : maze.rows();
    const int places = north ? maze.rows() : maze.columns();
    for (int line = 1; way[across] != 0 && line < lines; ++line) {
      for (const double face : {-half, half}) {
        const double t = (line * size + face - start[across]) / way[across];
        const glm::dvec3 at = start + way * t;
        const double placeAlong = std::floor(at[along] / size);
        if (!(t > 0 && t < 1) || at.y >= top || !(placeAlong >= 0 && placeAlong < places)) {
          continue;
        }
        const int place = static_cast<int>(placeAlong);
        const MazeCell cell = north ? MazeCell{place, line - 1} : MazeCell{line - 1, place};
        const double beside = at[along] - place * size;
        if (!maze.isOpen(cell, north ? Direction::kEast : Direction::kSouth) || beside < half || beside > size - half) {
          return true;
        }
      }
    }
  }
  return false;
}

/// The object that a ray meets first; nothing where it meets none, or a wall before.
std::optional<size_t> firstObject(const RayPath& path, const Maze& maze, const std::vector<ObjectSurface>& surfaces) {
  for (size_t i = 0; i + 1 < path.size(); ++i) {
    const glm::dvec3 from(path[i]);
    const glm::dvec3 to(path[i + 1]);
    std::optional<size_t> first;
    double nearest = 1;
    for (size_t k = 0; k < surfaces.size(); ++k) {
      if (surfaces[k].box.empty() || !partWithin(surfaces[k].box, from, to)) {
        continue;
      }
      for (const Corners& corners : surfaces[k].triangles) {
        const std::optional<double> along = crossing(corners, from, to);
        if (along && *along <= nearest) {
          nearest = *along;
          first = k;
        }
      }
    }
    if (meetsWall(maze, from, glm::mix(from, to, nearest))) {
      return std::nullopt;
    }
    if (first) {
      return first;
    }
  }
  return std::nullopt;
}

/// Evenly on the triangles of a surface, none on their edges; of many triangles, on some of them.
std::vector<glm::vec3> pointsOn(const ObjectSurface& surface) {
  std::vector<glm::vec3> points;
  const size_t step = surface.triangles.size() / kPointsOfObject + 1;
  int rows = 1;  // of points on a triangle, of 1, 2, 3, ... points
  while (surface.triangles.size() * static_cast<size_t>(rows * (rows + 1) / 2) < kPointsOfObject) {
    ++rows;
  }
  for (size_t i = 0; i < surface.triangles.size(); i += step) {
    const Corners& corners = surface.triangles[i];
    for (int row = 0; row < rows; ++row) {
      for (int k = 0; k <= row; ++k) {
        const double one = (k + 1.0 / 3) / rows;
        const double other = (row - k + 1.0 / 3) / rows;
        points.emplace_back(corners[0] * (1 - one - other) + corners[1] * one + corners[2] * other);
      }
    }
  }
  return points;
}

const Maze& mazeOfObjects(const GuidedScene& scene) {
  if (!scene.guides.maze) {
    throw InputError("the scene has no maze", "comprehensive camera",
                     "use builtin:maze, or builtin:maze,file=MAZE.json");
  }
  return *scene.guides.maze;
}

std::vector<size_t> pixelsOfSurfaces(const GraphCamera& camera, const Maze& maze,
                                     const std::vector<ObjectSurface>& surfaces) {
  std::vector<size_t> pixels;
  for (const ObjectSurface& surface : surfaces) {
    std::set<std::pair<int, int>> near;  // pixels in which points of the object lie, seen or not
    for (const glm::vec3& point : surface.triangles.empty() ? std::vector<glm::vec3>{} : pointsOn(surface)) {
      const std::optional<ImagePoint> image = camera.project(point);
      if (image && image->u >= 0 && image->v >= 0 && image->u < static_cast<float>(camera.width()) &&
          image->v < static_cast<float>(camera.height())) {
        near.emplace(static_cast<int>(image->u), static_cast<int>(image->v));
      }
    }
    pixels.push_back(static_cast<size_t>(std::count_if(near.begin(), near.end(), [&](const auto& pixel) {
      const glm::vec2 middle = glm::vec2(pixel.first, pixel.second) + 0.5f;
      return firstObject(camera.rayPath(middle), maze, surfaces) == pixels.size();
    })));
  }
  return pixels;
}

}  // namespace

std::vector<size_t> pixelsOfObjects(const GraphCamera& camera, const GuidedScene& scene) {
  return pixelsOfSurfaces(camera, mazeOfObjects(scene), surfacesOf(scene));
}

ComprehensiveChoice chooseComprehensive(const GuidedScene& scene, const ComprehensiveOptions& options, int width,
                                        int height) {
  const Maze& maze = mazeOfObjects(scene);
  const std::vector<ObjectSurface> surfaces = surfacesOf(scene);
  std::optional<ComprehensiveChoice> best;
  for (const Variation& variation : kVariations) {
    ComprehensiveChoice tried{varied(options, variation), {}};
    std::vector<size_t> pixels;
    try {
      pixels = pixelsOfSurfaces(makeComprehensiveCamera(maze, tried.options, width, height), maze, surfaces);
    } catch (const InputError&) {
      if (!best) {
        throw;  // the given options
      }
      continue;
    }
    for (size_t object = 0; object < surfaces.size(); ++object) {
      if (!surfaces[object].triangles.empty() && pixels[object] < kEnoughPixels) {
        tried.unseen.push_back(static_cast<uint32_t>(object));
      }
    }
    if (!best || tried.unseen.size() < best->unseen.size()) {
      best = std::move(tried);
    }
    if (best->unseen.empty()) {
      break;
    }
  }
  return *best;
}

}  // namespace ocelli
