#include "oc_core/ocri/view_cell.h"

#include <glm/geometric.hpp>
#include <random>

#include "oc_core/base/check.h"
#include "oc_core/base/error.h"

namespace ocelli {
namespace {

/// Uniform numbers in [-1, 1). Not std::uniform_real_distribution: its values differ between standard libraries.
class SignedUnit {
 public:
  explicit SignedUnit(unsigned seed) : random_(seed) {}

  float next() { return 2 * (static_cast<float>(random_() >> 8) / static_cast<float>(1 << 24) - 0.5f); }
  glm::vec3 inCube() {
    const float x = next();
    const float y = next();
    const float z = next();
    return {x, y, z};
  }
  glm::vec3 inBall() {
    glm::vec3 point = inCube();
    while (glm::dot(point, point) > 1) {
      point = inCube();
    }
    return point;
  }

 private:
  std::mt19937 random_;
};

float sign(int bits, int bit) {
  return (bits & bit) != 0 ? 1.0f : -1.0f;
}

glm::vec3 cubeCorner(int corner) {
  return {sign(corner, 1), sign(corner, 2), sign(corner, 4)};
}

constexpr int kCubeEdges = 12;

/// The middle of an edge; four along each axis.
glm::vec3 cubeEdge(int edge) {
  const int axis = edge / 4;
  glm::vec3 place(0);
  place[(axis + 1) % 3] = sign(edge, 1);
  place[(axis + 2) % 3] = sign(edge, 2);
  return place;
}

/// A place on an edge, from -1 at one corner to 1 at the other.
glm::vec3 onCubeEdge(int edge, float along) {
  glm::vec3 place = cubeEdge(edge);
  place[edge / 4] = along;
  return place;
}

float stepAlong(int step, int between) {
  return 2 * static_cast<float>(step) / static_cast<float>(between + 1) - 1;
}

std::vector<glm::vec3> cubeEdges(int between) {
  std::vector<glm::vec3> places;
  for (int edge = 0; edge < kCubeEdges; ++edge) {
    for (int step = 1; step <= between; ++step) {
      places.push_back(onCubeEdge(edge, stepAlong(step, between)));
    }
  }
  for (int corner = 0; corner < 8; ++corner) {
    places.push_back(cubeCorner(corner));
  }
  return places;
}

/// On the unit sphere: the corners of a cube and of three golden rectangles.
std::vector<glm::vec3> dodecahedron() {
  const float golden = (1 + std::sqrt(5.0f)) / 2;
  std::vector<glm::vec3> places;
  for (int corner = 0; corner < 8; ++corner) {
    places.push_back(cubeCorner(corner) / std::sqrt(3.0f));
  }
  for (int axis = 0; axis < 3; ++axis) {
    for (int corner = 0; corner < 4; ++corner) {
      glm::vec3 place(0);
      place[(axis + 1) % 3] = sign(corner, 1) / golden;
      place[(axis + 2) % 3] = sign(corner, 2) * golden;
      places.push_back(place / std::sqrt(3.0f));
    }
  }
  return places;
}

std::vector<View> moved(const View& reference, const std::vector<glm::vec3>& places, float scale) {
  std::vector<View> views;
  for (const glm::vec3& place : places) {
    views.push_back(movedEye(reference, place * scale));
  }
  return views;
}

}  // namespace

std::vector<View> ViewCell::edgeViews(const View& reference, int between) const {
  switch (shape) {
    case Shape::kCube:
      return moved(reference, cubeEdges(between), halfSide());
    case Shape::kSphere:
      return moved(reference, dodecahedron(), halfSide());
    case Shape::kSegment:
      return moved(reference, directions(2, 0), halfSide());
  }
  OC_CHECK(false, "every shape has edges");
}

std::vector<EdgeSequence> ViewCell::edgeSequences(int between) const {
  std::vector<EdgeSequence> sequences;
  if (shape != Shape::kCube) {
    return sequences;
  }
  const auto inside = static_cast<size_t>(between);
  for (int edge = 0; edge < kCubeEdges; ++edge) {
    EdgeSequence sequence;
    for (int step = 0; step <= between + 1; ++step) {
      const glm::vec3 place = onCubeEdge(edge, stepAlong(step, between));
      const size_t corner = kCubeEdges * inside + (place.x > 0 ? 1 : 0) + (place.y > 0 ? 2 : 0) + (place.z > 0 ? 4 : 0);
      const bool isCorner = step == 0 || step == between + 1;
      sequence.views.push_back(isCorner ? corner : static_cast<size_t>(edge) * inside + static_cast<size_t>(step - 1));
      sequence.places.push_back(place);
    }
    sequences.push_back(std::move(sequence));
  }
  return sequences;
}

std::vector<View> ViewCell::interiorViews(const View& reference, int count, unsigned seed) const {
  SignedUnit random(seed);
  std::vector<glm::vec3> places;
  for (int i = 0; i < count; ++i) {
    switch (shape) {
      case Shape::kCube:
        places.push_back(random.inCube());
        break;
      case Shape::kSphere:
        places.push_back(random.inBall());
        break;
      case Shape::kSegment:
        places.push_back(glm::normalize(segmentDirection) * random.next());
        break;
    }
  }
  return moved(reference, places, halfSide());
}

std::vector<glm::vec3> ViewCell::directions(int count, unsigned seed) const {
  if (shape == Shape::kSegment) {
    const glm::vec3 direction = glm::normalize(segmentDirection);
    return {direction, -direction};
  }
  constexpr float kShortest = 0.01f;  // a shorter one has few bits left for its direction
  SignedUnit random(seed);
  std::vector<glm::vec3> directions;
  while (directions.size() < static_cast<size_t>(count)) {
    const glm::vec3 point = random.inBall();
    if (glm::length(point) >= kShortest) {
      directions.push_back(glm::normalize(point));
    }
  }
  return directions;
}

std::string cellShapeName(ViewCell::Shape shape) {
  switch (shape) {
    case ViewCell::Shape::kCube:
      return "cube";
    case ViewCell::Shape::kSphere:
      return "sphere";
    case ViewCell::Shape::kSegment:
      return "segment";
  }
  OC_CHECK(false, "every shape has a name");
}

ViewCell::Shape cellShapeFromName(const std::string& name, const std::string& where) {
  for (const auto shape : {ViewCell::Shape::kCube, ViewCell::Shape::kSphere, ViewCell::Shape::kSegment}) {
    if (name == cellShapeName(shape)) {
      return shape;
    }
  }
  throw InputError("there is no cell shape \"" + name + "\"", where, "use cube, sphere or segment");
}

}  // namespace ocelli
