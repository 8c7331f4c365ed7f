#include "bench/naive_slicer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>

#include "display_sim/frames/sweep_geometry.h"

namespace ocelli {
namespace {

void drawSegment(Volume& volume, int slice, const glm::dvec2& from, const glm::dvec2& to) {
  const int steps = 1 + static_cast<int>(std::max(std::abs(to.x - from.x), std::abs(to.y - from.y)));
  for (int i = 0; i <= steps; ++i) {
    const glm::dvec2 p = glm::mix(from, to, static_cast<double>(i) / steps);
    if (p.x >= 0 && p.x < volume.width() && p.y >= 0 && p.y < volume.height()) {
      volume.light(slice, static_cast<int>(p.x), static_cast<int>(p.y), 7);
    }
  }
}

}  // namespace

Volume sliceNaively(const Mesh& mesh, const DisplayProfile& profile) {
  const SweepGeometry sweep(profile);
  const int count = profile.slicesPerHalfTurn;
  Volume volume(profile);
  for (const glm::uvec3& triangle : mesh.triangles) {
    std::array<glm::dvec3, 3> p;
    std::array<double, 3> steps;
    for (int k = 0; k < 3; ++k) {
      p[static_cast<size_t>(k)] = glm::dvec3(mesh.positions[triangle[k]]);
      steps[static_cast<size_t>(k)] =
          std::atan2(p[static_cast<size_t>(k)].z, p[static_cast<size_t>(k)].x) / sweep.stepRadians();
    }
    double lo = std::min({steps[0], steps[1], steps[2]});
    double hi = std::max({steps[0], steps[1], steps[2]});
    if (hi - lo > count) {  // across the angle where turns begin: all planes
      lo = 0;
      hi = count - 1;
    }
    for (int step = static_cast<int>(std::ceil(lo)); step <= static_cast<int>(std::floor(hi)); ++step) {
      const int slice = ((step % count) + count) % count;
      const glm::dvec2& d = sweep.sectorDirection(slice);
      std::array<glm::dvec2, 2> ends;
      size_t found = 0;
      for (size_t k = 0; k < 3 && found < 2; ++k) {
        const glm::dvec3& a = p[k];
        const glm::dvec3& b = p[(k + 1) % 3];
        const double acrossA = a.z * d.x - a.x * d.y;
        const double acrossB = b.z * d.x - b.x * d.y;
        if ((acrossA < 0) != (acrossB < 0)) {
          const glm::dvec3 at = glm::mix(a, b, acrossA / (acrossA - acrossB));
          ends[found++] = {sweep.columnsPerRadius() * (1 + at.x * d.x + at.z * d.y), sweep.rowOfY(at.y)};
        }
      }
      if (found == 2) {
        drawSegment(volume, slice, ends[0], ends[1]);
      }
    }
  }
  return volume;
}

}  // namespace ocelli
