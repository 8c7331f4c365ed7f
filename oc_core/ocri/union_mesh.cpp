#include "oc_core/ocri/union_mesh.h"

#include "oc_core/ocri/image_mesh.h"

namespace ocelli {

Mesh unionMesh(const ReferenceImages& images) {
  Mesh mesh;
  for (const ReferenceImage& image : images) {
    append(mesh, imageMesh(image));
  }
  return mesh;
}

}  // namespace ocelli
