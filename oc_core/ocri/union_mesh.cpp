#include "oc_core/ocri/union_mesh.h"

#include "oc_core/ocri/image_mesh.h"
#include "oc_core/ocri/row_mesh.h"

namespace ocelli {

Mesh unionMesh(const ReferenceImages& images) {
  Mesh mesh;
  for (const ReferenceImage& image : images) {
    append(mesh, image.rows == ImageRows::kAligned ? imageMesh(image) : rowMesh(image));
  }
  return mesh;
}

}  // namespace ocelli
