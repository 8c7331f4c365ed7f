// Builds the single pole occlusion camera of a scene (section 3.1), its baseline the reverse pinhole, and their
// reference images.
//
// The text leaves it to the user to say which object the pole goes through. Here it is the foreground of the reference
// view: the samples of its depth image nearer than the depth that parts them best (the greatest variance of 1/z between
// the two sides).
#pragma once

#include "oc_core/camera/reverse_pinhole_camera.h"
#include "oc_core/camera/spoc_camera.h"
#include "oc_core/ocri/reference_image.h"
#include "oc_core/scene/mesh.h"

namespace ocelli {

/// Throws InputError where the view sees nothing, or all of it is equally far away. Where `renderer` has rays,
/// z_f is that of the farthest surface along the pinhole's, instead of the farthest vertex in view: that takes a look
/// from behind.
SpocCamera buildSpocCamera(const PinholeCamera& reference, const Mesh& mesh, const SpocOptions& options = {},
                           const SceneRenderer* renderer = nullptr);

/// Around all that is in view. Throws InputError where that is nothing, or too deep.
ReversePinholeCamera buildReversePinhole(const PinholeCamera& reference, const Mesh& mesh,
                                         const SceneRenderer* renderer = nullptr);

/// Displacements are relative to `reference`. Its `triangleBound` is that of the depth image of the same view.
ReferenceImage buildSpocImage(const SpocCamera& camera, const Mesh& mesh, const SceneRenderer* renderer = nullptr);
ReferenceImage buildReversePinholeImage(const ReversePinholeCamera& camera, const PinholeCamera& reference,
                                        const Mesh& mesh, const SceneRenderer* renderer = nullptr);

}  // namespace ocelli
