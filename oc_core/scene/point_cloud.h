// Points without triangles, as scanners and simulations give them, and how they become geometry (point_mesh.h).
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

namespace ocelli {

/// The most points of a scene: as panels they have kMaxSceneTriangles (scene.h).
inline constexpr size_t kMaxScenePoints = 20'000'000;

struct PointCloud {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> colors;   ///< linear, one a point; empty where there are none
  std::vector<glm::vec3> normals;  ///< of any length, towards the outside, one a point; empty where there are none
};

struct PointSceneOptions {
  /// How wide each point and each line is, in the units of the scene before it is fitted. Nothing: a point by its
  /// nearest neighbours, lines by the size of the scene (line_mesh.h).
  std::optional<double> width{};
};

/// What became of the points of a scene.
struct PointFacts {
  size_t points = 0;             ///< in the file
  size_t repeated = 0;           ///< of them those that stand where another one does, and are left out
  size_t panels = 0;             ///< points that became a flat panel of two triangles
  size_t solids = 0;             ///< points that became an octahedron
  size_t lines = 0;              ///< segments of lines, which became tubes
  bool areWidthsChosen = false;  ///< from the neighbours
  /// Widths, in the units of the scene before it is fitted: the longer side of a panel, the height of an octahedron.
  double narrowest = 0;
  double medianWidth = 0;
  double widest = 0;
};

}  // namespace ocelli
