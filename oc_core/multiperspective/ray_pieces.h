// The ray of a pixel, cut where it passes from one part of a camera into the next. The parts of a graph camera are its
// frusta. Those of a curved ray camera are its segments, straight ones at even numbers and bends at odd ones. A ray map
// (oc_core/camera/ray_map.h) is one part.
#pragma once

#include <string>
#include <vector>

#include "oc_core/camera/ray_map_camera.h"
#include "oc_core/constructor/multiperspective_camera.h"

namespace ocelli {

struct RayPiece {
  int part = 0;
  std::vector<glm::vec3> points;  ///< in the world; two or more, from near to far
};

std::vector<RayPiece> rayPieces(const GraphCamera& camera, const glm::vec2& pixel);
std::vector<RayPiece> rayPieces(const CurvedRayCamera& camera, const glm::vec2& pixel);
std::vector<RayPiece> rayPieces(const RayMapCamera& camera, const glm::vec2& pixel);

/// Pixels just within the corners of each part's share of the image.
std::vector<glm::vec2> cornerPixels(const GraphCamera& camera);
std::vector<glm::vec2> cornerPixels(const CurvedRayCamera& camera);
std::vector<glm::vec2> cornerPixels(const RayMapCamera& camera);

/// What people call each part.
std::vector<std::string> partNames(const GraphCamera& camera);
std::vector<std::string> partNames(const CurvedRayCamera& camera);
std::vector<std::string> partNames(const RayMapCamera& camera);

/// Where the straight rays of each part come from; a bend has no one viewpoint, and takes that of the segment before.
/// Of a ray map the middle of where its rays begin.
std::vector<glm::vec3> partViewpoints(const GraphCamera& camera);
std::vector<glm::vec3> partViewpoints(const CurvedRayCamera& camera);
std::vector<glm::vec3> partViewpoints(const RayMapCamera& camera);

}  // namespace ocelli
