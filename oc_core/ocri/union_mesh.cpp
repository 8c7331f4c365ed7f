#include "oc_core/ocri/union_mesh.h"

#include "oc_core/ocri/image_mesh.h"
#include "oc_core/ocri/layered_mesh.h"
#include "oc_core/ocri/row_mesh.h"

namespace ocelli {
namespace {

/// Less leaves holes in grazing surfaces, more lets squares stand out: measured on builtin:room with four viewers.
constexpr float kDeepestSquareFromAside = 2;

}  // namespace

Mesh unionMesh(const ReferenceImages& images) {
  Mesh mesh;
  const auto add = [&](Mesh part) {
    if (mesh.positions.empty()) {
      mesh = std::move(part);
    } else {
      append(mesh, part);
    }
  };
  for (size_t first = 0; first < images.size();) {
    size_t end = first + 1;
    while (end < images.size() && images[end].layer > 0) {
      ++end;
    }
    ImageMeshOptions options;
    if (images[first].seenFromAside) {
      options.deepestSquareFootprints = kDeepestSquareFromAside;
    }
    const auto part = images.begin() + static_cast<std::ptrdiff_t>(first);
    if (end - first > 1) {
      add(layeredMesh({part, part + static_cast<std::ptrdiff_t>(end - first)}, options));
    } else {
      add(part->rows == ImageRows::kAligned ? imageMesh(*part, options) : rowMesh(*part, options));
    }
    first = end;
  }
  return mesh;
}

}  // namespace ocelli
