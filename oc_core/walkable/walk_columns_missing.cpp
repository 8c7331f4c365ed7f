// What a program without Recast has of walk_columns.h and walkable.h: it says so.
#include "oc_core/base/error.h"
#include "oc_core/walkable/walk_columns.h"
#include "oc_core/walkable/walkable.h"

namespace ocelli {

bool canFindWalkable() {
  return false;
}

WalkColumns rasterizedColumns(const Mesh&, const WalkRaster&, const Progress&) {
  throw InputError("where one can walk is found by Recast, and this program was built without it", "walkable floor",
                   "install librecast-dev and build with OCELLI_WITH_RECAST=ON, or give a map (--ways FILE.json)");
}

}  // namespace ocelli
