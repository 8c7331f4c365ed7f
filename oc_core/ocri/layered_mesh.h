// The triangle mesh of a layered depth image.
//
// DEVIATION: the text renders LDIs by splatting, since they have no connectivity. Here they have: a surface goes on in
// another layer where something comes in front of it, and its samples are joined across layers.
#pragma once

#include "oc_core/ocri/image_mesh.h"
#include "oc_core/ocri/reference_image.h"
#include "oc_core/scene/mesh.h"

namespace ocelli {

/// The mesh of all layers: each pair of neighbouring pixels joins those samples, one to one and of any layers, that
/// continue each other best, by the rules of imageMesh(); a single layer is joined as imageMesh() joins it.
/// Vertices come in pixel order, the layers of a pixel from near to far, then the corners of squares. Layers must be of
/// one view and size; they displace nothing. No layer gives an empty mesh. `sampleOfVertex` receives where each
/// vertex comes from: the index of its pixel, plus the number of its layer times the pixels of one.
Mesh layeredMesh(const ReferenceImages& layers, const ImageMeshOptions& options = {},
                 std::vector<uint32_t>* sampleOfVertex = nullptr);

}  // namespace ocelli
