// In place of surface_quads_openvdb.cpp where the toolkit is built without OpenVDB.
#include "oc_core/base/error.h"
#include "oc_core/isosurface/isosurface.h"
#include "oc_core/isosurface/surface_quads.h"

namespace ocelli {

bool canExtractIsosurfaces() {
  return false;
}

SurfaceQuads surfaceQuads(const ScalarVolume& /*volume*/, double /*value*/, size_t /*maxQuads*/,
                          const Progress& /*progress*/) {
  throw InputError("this build cannot extract surfaces of volumes: it was built without OpenVDB", "--iso",
                   "install libopenvdb-dev and build it with -DOCELLI_WITH_OPENVDB=ON (docs/install.md)");
}

}  // namespace ocelli
