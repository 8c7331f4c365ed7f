#include "oc_core/worlds/solids.h"

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

Mesh makeTurned(const std::vector<glm::vec2>& profile, int segments) {
  OC_CHECK(segments >= 3 && profile.size() >= 3, "a turned solid has a volume");
  const size_t last = profile.size() - 1;
  Mesh solid;
  solid.positions.push_back({0, profile[0].y, 0});
  for (size_t ring = 1; ring < last; ++ring) {
    OC_CHECK(profile[ring].x > 0, "only the ends of a profile are on the axis");
    for (int i = 0; i < segments; ++i) {
      solid.positions.push_back(glm::vec3(profile[ring].x * std::sin(turn(i, segments)), profile[ring].y,
                                          profile[ring].x * std::cos(turn(i, segments))));
    }
  }
  solid.positions.push_back({0, profile[last].y, 0});
  const auto vertex = [&](size_t ring, int i) {
    return static_cast<uint32_t>(ring == 0 ? 0
                                           : 1 + (ring - 1) * static_cast<size_t>(segments) +
                                                 (ring == last ? 0 : static_cast<size_t>(i % segments)));
  };
  for (int i = 0; i < segments; ++i) {
    for (size_t ring = 0; ring < last; ++ring) {
      if (ring > 0) {
        solid.triangles.push_back({vertex(ring, i), vertex(ring, i + 1), vertex(ring + 1, i + 1)});
      }
      if (ring + 1 < last) {
        solid.triangles.push_back({vertex(ring, i), vertex(ring + 1, i + 1), vertex(ring + 1, i)});
      }
    }
  }
  return solid;
}

Mesh makePrism(const std::vector<glm::vec2>& outline, float halfDepth) {
  OC_CHECK(outline.size() >= 3, "an outline has three corners or more");
  const auto count = static_cast<uint32_t>(outline.size());
  Mesh prism;
  for (const float z : {halfDepth, -halfDepth}) {
    for (const glm::vec2& corner : outline) {
      prism.positions.push_back({corner, z});
    }
  }
  for (uint32_t i = 0; i < count; ++i) {
    const uint32_t j = (i + 1) % count;
    if (i > 0 && j > 0) {
      prism.triangles.push_back({0, i, j});
      prism.triangles.push_back({count, count + j, count + i});
    }
    prism.triangles.push_back({i, i + count, j + count});
    prism.triangles.push_back({i, j + count, j});
  }
  return prism;
}

void paint(Mesh& mesh, const glm::vec3& color) {
  mesh.colors.assign(mesh.positions.size(), color);
}

}  // namespace ocelli
