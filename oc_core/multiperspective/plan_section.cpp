#include "oc_core/multiperspective/plan_section.h"

#include "oc_core/base/finite.h"

namespace ocelli {

std::vector<SectionLine> sectionOf(const Mesh& mesh, PlanSide side, float at) {
  const int axis = axisOf(side);
  std::vector<SectionLine> lines;
  for (const glm::uvec3& t : mesh.triangles) {
    SectionLine line;
    size_t ends = 0;
    for (int k = 0; k < 3; ++k) {
      const glm::vec3& a = mesh.positions[t[k]];
      const glm::vec3& b = mesh.positions[t[(k + 1) % 3]];
      if (!isFinite(a) || !isFinite(b)) {
        ends = 0;
        break;
      }
      // A corner in the plane counts as above it, so that a triangle has two ends or none.
      if ((a[axis] < at) != (b[axis] < at)) {
        const float share = (at - a[axis]) / (b[axis] - a[axis]);
        line[ends++] = onPaper(side, a + (b - a) * share);
      }
    }
    if (ends == 2) {
      lines.push_back(line);
    }
  }
  return lines;
}

}  // namespace ocelli
