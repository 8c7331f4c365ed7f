#include "oc_core/scene/solids.h"

#include <algorithm>
#include <cmath>

#include "oc_core/base/check.h"
#include "oc_core/base/conventions.h"

namespace ocelli {
namespace {

double turn(int step, int steps) {
  return 2 * kPi * step / steps;
}

}  // namespace

Mesh makeBox(const glm::vec3& half) {
  Mesh box;
  for (int i = 0; i < 8; ++i) {
    box.positions.push_back(half * glm::vec3((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1, (i & 4) != 0 ? 1 : -1));
  }
  box.triangles = {{0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}, {0, 1, 5}, {0, 5, 4},
                   {2, 6, 7}, {2, 7, 3}, {0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}};
  return box;
}

Mesh makeSphere(int segments) {
  OC_CHECK(segments >= 3, "a sphere has at least three segments");
  const int rings = std::max(segments / 2, 2);
  Mesh sphere;
  sphere.positions.push_back({0, 1, 0});
  for (int ring = 1; ring < rings; ++ring) {
    const double fromPole = kPi * ring / rings;
    for (int i = 0; i < segments; ++i) {
      sphere.positions.push_back(glm::vec3(std::sin(fromPole) * std::sin(turn(i, segments)), std::cos(fromPole),
                                           std::sin(fromPole) * std::cos(turn(i, segments))));
    }
  }
  sphere.positions.push_back({0, -1, 0});
  const auto last = static_cast<uint32_t>(sphere.positions.size() - 1);
  const auto vertex = [&](int ring, int i) {
    return ring == 0 ? 0u : ring == rings ? last : static_cast<uint32_t>(1 + (ring - 1) * segments + i % segments);
  };
  for (int ring = 0; ring < rings; ++ring) {
    for (int i = 0; i < segments; ++i) {
      if (ring > 0) {
        sphere.triangles.push_back({vertex(ring, i), vertex(ring + 1, i), vertex(ring, i + 1)});
      }
      if (ring + 1 < rings) {
        sphere.triangles.push_back({vertex(ring, i + 1), vertex(ring + 1, i), vertex(ring + 1, i + 1)});
      }
    }
  }
  return sphere;
}

Mesh makeTorus(float tubeRadius, int segments) {
  OC_CHECK(segments >= 3, "a torus has at least three segments");
  const int around = std::max(segments / 2, 3);
  Mesh torus;
  for (int i = 0; i < segments; ++i) {
    for (int j = 0; j < around; ++j) {
      const double r = 1 - tubeRadius + tubeRadius * std::cos(turn(j, around));
      torus.positions.push_back(glm::vec3(r * std::cos(turn(i, segments)), r * std::sin(turn(i, segments)),
                                          tubeRadius * std::sin(turn(j, around))));
    }
  }
  const auto vertex = [&](int i, int j) { return static_cast<uint32_t>((i % segments) * around + j % around); };
  for (int i = 0; i < segments; ++i) {
    for (int j = 0; j < around; ++j) {
      torus.triangles.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
      torus.triangles.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
    }
  }
  return torus;
}

void paint(Mesh& mesh, const glm::vec3& color) {
  mesh.colors.assign(mesh.positions.size(), color);
}

}  // namespace ocelli
