// The layered depth image (LDI; section 2.1.1 and Table 3.6): along each ray of the reference pinhole not one surface
// but the first few.
//
// Layers hold what faces the eye. The surface of a solid that faces away bounds it from behind and takes the place of a
// layer; its flanks, which other viewpoints of a view cell do see, cover too few pixels to gain anything by it
// (measured: docs/results.md). An open surface has no inside and counts from both sides. oc_core/scene/closed_parts.h
// decides which is which.
//
// DEVIATION: the text counts on 4 x 4 construction images from other viewpoints, warped and merged into one. Here the
// layers are peeled along the rays of the reference view itself: no sample is moved, none is resampled, and the cost is
// one pass over the scene. Surfaces edge-on to the reference view are sampled as sparsely as in the depth image.
#pragma once

#include "oc_core/ocri/reference_image.h"
#include "oc_core/ocri/view_cell.h"
#include "oc_core/render/rasterize_layers.h"

namespace ocelli {

/// The sides of each triangle that an eye outside of all solids can see.
std::vector<DrawnSides> visibleSides(const Mesh& mesh);

/// Of a mesh that is made of samples (Mesh::isSampled), surfaces that lie on each other are one layer.
/// One image a layer, all of the same view, the closest first; trailing layers without a sample are left out, except
/// the first. Layers are those of `renderer`, where there is one that draws them. Throws InputError where `layers` is
/// not in 1 to kMaxLayers.
ReferenceImages buildLayeredDepthImage(const PinholeCamera& reference, const Mesh& mesh, int layers,
                                       const SceneRenderer* renderer = nullptr);

/// Empties the samples behind the first layer that none of the viewpoints on the edges of `cell` sees: those that have
/// nothing more than 1.5 pixel footprints in front of them at one of the 3x3 pixels around their image. What is left is
/// what an LDI merged from the images of these viewpoints would hold, where it holds it. Layers must be of one view and
/// size.
void dropUnseenSamples(ReferenceImages& layers, const Mesh& mesh, const ViewCell& cell);

}  // namespace ocelli
