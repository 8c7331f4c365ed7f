// One mesh for one or several reference images (section 3.5.1).
#pragma once

#include <cstdint>
#include <vector>

#include "oc_core/ocri/reference_image.h"
#include "oc_core/scene/mesh.h"

namespace ocelli {

/// The meshes of the images, one behind the other; each as its rows ask for.
Mesh unionMesh(const ReferenceImages& images);

/// What is meshed as one: an image, or the layers of a layered depth image.
struct MeshedImages {
  size_t first = 0;  ///< of the union
  size_t end = 0;
  Mesh mesh;
  /// Where each vertex comes from: the index of its pixel, plus the number of its layer times the pixels of one.
  std::vector<uint32_t> sampleOfVertex;
};

/// The meshes that unionMesh() puts behind each other, in its order, and where their vertices come from.
std::vector<MeshedImages> meshEach(const ReferenceImages& images);

}  // namespace ocelli
