#include "oc_core/ocri/union_mesh.h"

#include "oc_core/ocri/image_mesh.h"
#include "oc_core/ocri/layered_mesh.h"
#include "oc_core/ocri/row_mesh.h"

namespace ocelli {

Mesh unionMesh(const ReferenceImages& images) {
  Mesh mesh;
  for (size_t first = 0; first < images.size();) {
    size_t end = first + 1;
    while (end < images.size() && images[end].layer > 0) {
      ++end;
    }
    const auto part = images.begin() + static_cast<std::ptrdiff_t>(first);
    if (end - first > 1) {
      append(mesh, layeredMesh({part, part + static_cast<std::ptrdiff_t>(end - first)}));
    } else {
      append(mesh, part->rows == ImageRows::kAligned ? imageMesh(*part) : rowMesh(*part));
    }
    first = end;
  }
  return mesh;
}

}  // namespace ocelli
