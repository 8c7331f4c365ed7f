// One mesh for one or several reference images (section 3.5.1).
#pragma once

#include "oc_core/ocri/reference_image.h"
#include "oc_core/scene/mesh.h"

namespace ocelli {

/// The meshes of the images, one behind the other; each as its rows ask for.
Mesh unionMesh(const ReferenceImages& images);

}  // namespace ocelli
