#include "oc_core/multiperspective/ray_pieces.h"

namespace ocelli {
namespace {

constexpr double kInside = 1e-3;  // of the way to the middle

void addCorners(const GraphCamera::Part& part, std::vector<glm::vec2>& pixels) {
  const glm::dvec2 middle = GraphCamera::middleOf(part);
  for (const glm::dvec2& corner : part) {
    pixels.emplace_back(corner + (middle - corner) * kInside);
  }
}

}  // namespace

std::vector<RayPiece> rayPieces(const GraphCamera& camera, const glm::vec2& pixel) {
  const RayPath path = camera.rayPath(pixel);
  std::vector<RayPiece> pieces;
  int frustum = GraphCamera::kRoot;
  for (size_t i = 0; i + 1 < path.size(); ++i) {
    pieces.push_back({frustum, {path[i], path[i + 1]}});
    frustum = camera.childAt(frustum, glm::dvec2(pixel));
  }
  return pieces;
}

std::vector<RayPiece> rayPieces(const CurvedRayCamera& camera, const glm::vec2& pixel) {
  const RayPath path = camera.rayPath(pixel);
  std::vector<RayPiece> pieces;
  size_t bend = 0;
  bool turning = false;
  for (size_t i = 0; i + 1 < path.size(); ++i) {
    const glm::dvec3 middle((path[i] + path[i + 1]) * 0.5f);
    const auto beyond = [&](Plane TransitionPlanes::*plane) {
      return bend < camera.bends().size() && (camera.bends()[bend].planes().*plane).height(middle) > 0;
    };
    if (turning && beyond(&TransitionPlanes::to)) {
      turning = false;
      ++bend;
    }
    if (!turning && beyond(&TransitionPlanes::from)) {
      turning = true;
    }
    const int part = static_cast<int>(2 * bend) + (turning ? 1 : 0);
    if (pieces.empty() || pieces.back().part != part) {
      pieces.push_back({part, {path[i]}});
    }
    pieces.back().points.push_back(path[i + 1]);
  }
  return pieces;
}

std::vector<glm::vec2> cornerPixels(const GraphCamera& camera) {
  std::vector<glm::vec2> pixels;
  for (const GraphCamera::Frustum& frustum : camera.frusta()) {
    addCorners(frustum.part, pixels);
  }
  return pixels;
}

std::vector<glm::vec2> cornerPixels(const CurvedRayCamera& camera) {
  std::vector<glm::vec2> pixels;
  const double width = camera.width();
  const double height = camera.height();
  addCorners({{0, 0}, {width, 0}, {width, height}, {0, height}}, pixels);
  return pixels;
}

std::vector<std::string> partNames(const GraphCamera& camera) {
  std::vector<std::string> names;
  for (const GraphCamera::Frustum& frustum : camera.frusta()) {
    names.push_back(frustum.name);
  }
  return names;
}

std::vector<std::string> partNames(const CurvedRayCamera& camera) {
  std::vector<std::string> names{"root"};
  for (size_t i = 1; i <= camera.bends().size(); ++i) {
    names.push_back("turn " + std::to_string(i));
    names.push_back("after turn " + std::to_string(i));
  }
  return names;
}

std::vector<glm::vec3> partViewpoints(const GraphCamera& camera) {
  std::vector<glm::vec3> viewpoints;
  for (const GraphCamera::Frustum& frustum : camera.frusta()) {
    viewpoints.emplace_back(frustum.viewpoint);
  }
  return viewpoints;
}

std::vector<glm::vec3> partViewpoints(const CurvedRayCamera& camera) {
  std::vector<glm::vec3> viewpoints{camera.root().eye()};
  for (const RayTransition& bend : camera.bends()) {
    viewpoints.emplace_back(bend.before());
    viewpoints.emplace_back(bend.beyond());
  }
  return viewpoints;
}

std::vector<RayPiece> rayPieces(const RayMapCamera& camera, const glm::vec2& pixel) {
  const RayPath path = camera.rayPath(pixel);
  return path.empty() ? std::vector<RayPiece>{}
                      : std::vector<RayPiece>{{0, std::vector<glm::vec3>(path.begin(), path.end())}};
}

std::vector<glm::vec2> cornerPixels(const RayMapCamera&) {
  return {};
}

std::vector<std::string> partNames(const RayMapCamera& camera) {
  return {camera.map().notes().name};
}

std::vector<glm::vec3> partViewpoints(const RayMapCamera& camera) {
  const RayMapFacts facts = factsOf(camera.map());
  return {(facts.lower + facts.upper) * 0.5f};
}

}  // namespace ocelli
