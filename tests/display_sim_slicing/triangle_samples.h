// Where the fast slicer samples a mesh, for tests: what its pass hands to its loops.
#pragma once

#include <vector>

#include "display_sim/frames/display_profile.h"
#include "oc_core/scene/mesh.h"

namespace ocelli::test {

/// Of one triangle. Where it is found exactly there are no samples.
struct TriangleSamples {
  bool foundExactly = false;
  std::vector<glm::vec3> points;  ///< its corners and the others
};

/// In the order of the triangles.
std::vector<TriangleSamples> samplesOf(const Mesh& mesh, const DisplayProfile& profile);

}  // namespace ocelli::test
