// Reference images of a packed scene (oc_core/pack): each is built from the clusters that its construction can look at,
// as coarse as its pixels allow, so that its cost does not grow with the scene.
#pragma once

#include "oc_core/ocri/camera_choice.h"
#include "oc_core/pack/packed_scene.h"
#include "oc_core/render/view_cut.h"

namespace ocelli {

/// The part of the scene that the reference images of this choice are made of: everything that the construction takes a
/// mesh for takes this one, but for the question whether an eye lies inside an object (requireViewpointsOutside), which
/// it does not ask of this mesh (Mesh::isPart).
///
/// `maxErrorPixels`: how far a surface may be off, pixels of the reference view, or where a camera has more samples
/// than that, spaces between those. With an error near 0 the samples are those of the scene itself, bit by bit, and
/// colours within a step of 1/65535.
Mesh meshForView(const PackedScene& scene, const CameraChoice& choice, const PinholeCamera& reference,
                 float maxErrorPixels = kPackedErrorPixels);

/// Throws InputError where the eye, or an end of a view segment of this choice, lies inside an object of the scene.
void requireViewpointsOutside(const PackedScene& scene, const CameraChoice& choice, const PinholeCamera& reference);

/// As from a mesh (camera_choice.h), and throws as that does.
ReferenceImages buildReferenceImages(const CameraChoice& choice, const PinholeCamera& reference,
                                     const PackedScene& scene, const Progress& progress = {});

}  // namespace ocelli
