// Other people's ways from a mesh to slices, for slicer_bench. Each is there where its library was found.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "display_sim/frames/display_profile.h"
#include "oc_core/scene/mesh.h"

namespace ocelli {

struct SlicerPeer {
  std::string name;
  std::string what;         ///< what it gives, where that is less than a volume
  size_t maxTriangles = 0;  ///< more would take minutes
  /// What is made once for a mesh, and the work of one volume.
  std::function<std::function<void()>(const Mesh&, const DisplayProfile&)> prepare;
};

std::vector<SlicerPeer> vtkPeers();
/// The library whose threads VTK's filters run on. "TBB" has as many for VTK as for Ocelli (parallel.h).
std::string vtkThreads();
std::vector<SlicerPeer> openVdbPeers();

}  // namespace ocelli
