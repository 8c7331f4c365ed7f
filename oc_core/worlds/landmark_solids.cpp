#include "oc_core/worlds/landmark_solids.h"

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>

#include "oc_core/base/conventions.h"
#include "oc_core/scene/scene.h"
#include "oc_core/worlds/palette.h"
#include "oc_core/worlds/solids.h"

namespace ocelli {
namespace {

constexpr int kSegments = 32;

/// An arch that spans x from -halfWidth to halfWidth: two legs and half an ellipse.
Mesh makeArch(float halfWidth, float height, float halfDepth) {
  const float leg = 0.16f * halfWidth;
  const float rise = std::min(halfWidth, 0.5f * height);
  const float spring = height - rise;
  std::vector<glm::vec2> outer{{halfWidth, 0}};
  std::vector<glm::vec2> inner{{halfWidth - leg, 0}};
  for (int i = 0; i <= kSegments; ++i) {
    const double angle = kPi * i / kSegments;
    const glm::vec2 unit(std::cos(angle), std::sin(angle));
    outer.push_back({halfWidth * unit.x, spring + rise * unit.y});
    inner.push_back({(halfWidth - leg) * unit.x, spring + (rise - 0.16f * rise) * unit.y});
  }
  outer.push_back({-halfWidth, 0});
  inner.push_back({-(halfWidth - leg), 0});
  Mesh arch;
  for (size_t i = 0; i < outer.size(); ++i) {
    for (const glm::vec2& point : {outer[i], inner[i]}) {
      arch.positions.push_back({point, halfDepth});
      arch.positions.push_back({point, -halfDepth});
    }
  }
  // Four corners a step: outer front, outer back, inner front, inner back.
  const auto quad = [&](uint32_t a, uint32_t b, uint32_t c, uint32_t d) {
    arch.triangles.push_back({a, b, c});
    arch.triangles.push_back({a, c, d});
  };
  const auto last = static_cast<uint32_t>(4 * (outer.size() - 1));
  for (uint32_t i = 0; i < last; i += 4) {
    quad(i, i + 4, i + 6, i + 2);      // front
    quad(i + 1, i + 3, i + 7, i + 5);  // back
    quad(i, i + 1, i + 5, i + 4);      // outside
    quad(i + 2, i + 6, i + 7, i + 3);  // inside
  }
  quad(0, 2, 3, 1);
  quad(last, last + 1, last + 3, last + 2);
  return arch;
}

Mesh makeShape(LandmarkShape shape, float radius, float clearWidth, float wallHeight) {
  const float r = radius;
  switch (shape) {
    case LandmarkShape::kCone:
      return makeTurned({{0, 0}, {r, 0}, {r, 0.15f * r}, {0, 2.8f * r}}, kSegments);
    case LandmarkShape::kCube: {
      const float half = r / std::sqrt(2.0f);
      Mesh cube = makeBox(glm::vec3(half));
      transform(cube, glm::translate(glm::rotate(glm::mat4(1), 0.35f, glm::vec3(0, 1, 0)), {0, half, 0}));
      return cube;
    }
    case LandmarkShape::kSphere: {
      Mesh sphere = makeSphere(kSegments);
      transform(sphere, glm::scale(glm::translate(glm::mat4(1), {0, r, 0}), glm::vec3(r)));
      return sphere;
    }
    case LandmarkShape::kColumn: {
      const float top = 0.8f * wallHeight;
      return makeTurned({{0, 0},
                         {r, 0},
                         {r, 0.08f * top},
                         {0.62f * r, 0.14f * top},
                         {0.5f * r, 0.86f * top},
                         {0.9f * r, 0.92f * top},
                         {0.9f * r, top},
                         {0, top}},
                        kSegments);
    }
    case LandmarkShape::kPyramid:
      return makeTurned({{0, 0}, {r, 0}, {0, 1.8f * r}}, 4);
    case LandmarkShape::kRing: {
      Mesh ring = makeTorus(0.28f, kSegments);
      transform(ring, glm::scale(glm::translate(glm::mat4(1), {0, r, 0}), glm::vec3(r)));
      return ring;
    }
    case LandmarkShape::kArch:
      // A little off the walls, so that no two faces coincide.
      return makeArch(0.49f * clearWidth, 0.9f * wallHeight, 0.5f * r);
  }
  return {};
}

}  // namespace

const char* nameOf(LandmarkShape shape) {
  switch (shape) {
    case LandmarkShape::kCone:
      return "cone";
    case LandmarkShape::kCube:
      return "cube";
    case LandmarkShape::kSphere:
      return "sphere";
    case LandmarkShape::kColumn:
      return "column";
    case LandmarkShape::kPyramid:
      return "pyramid";
    case LandmarkShape::kRing:
      return "ring";
    case LandmarkShape::kArch:
      return "arch";
  }
  return "";
}

const char* nameOf(LandmarkColor color) {
  switch (color) {
    case LandmarkColor::kOrange:
      return "orange";
    case LandmarkColor::kSkyBlue:
      return "sky_blue";
    case LandmarkColor::kGreen:
      return "green";
    case LandmarkColor::kYellow:
      return "yellow";
    case LandmarkColor::kBlue:
      return "blue";
    case LandmarkColor::kVermilion:
      return "vermilion";
    case LandmarkColor::kPurple:
      return "purple";
    case LandmarkColor::kIvory:
      return "ivory";
  }
  return "";
}

glm::vec3 colorOf(LandmarkColor color) {
  switch (color) {
    case LandmarkColor::kOrange:
      return palette::orange();
    case LandmarkColor::kSkyBlue:
      return palette::skyBlue();
    case LandmarkColor::kGreen:
      return palette::green();
    case LandmarkColor::kYellow:
      return palette::yellow();
    case LandmarkColor::kBlue:
      return palette::blue();
    case LandmarkColor::kVermilion:
      return palette::vermilion();
    case LandmarkColor::kPurple:
      return palette::purple();
    case LandmarkColor::kIvory:
      return palette::ivory();
  }
  return glm::vec3(1);
}

Mesh makeLandmark(const Maze& maze, const Landmark& landmark) {
  Mesh mesh =
      makeShape(landmark.shape, kLandmarkRadius * maze.cellSize, maze.cellSize - maze.wallThickness, maze.wallHeight);
  glm::mat4 worldFromShape = glm::translate(
      glm::mat4(1), maze.centerOf(landmark.cell) + maze.cellSize * glm::vec3(landmark.east, 0, landmark.south));
  const std::vector<Direction> ways = maze.passages(landmark.cell);
  // Arches and rings face the passage.
  if (!ways.empty() && isEastWest(ways[0])) {
    worldFromShape = glm::rotate(worldFromShape, static_cast<float>(kPi / 2), glm::vec3(0, 1, 0));
  }
  transform(mesh, worldFromShape);
  return mesh;
}

}  // namespace ocelli
