// The rays of the toolkit's own cameras as ray maps (oc_core/camera/ray_map.h), for files that other programs read: one
// ray for each pixel, as ray casting follows it.
#pragma once

#include "oc_core/camera/ray_map.h"
#include "oc_core/constructor/multiperspective_camera.h"
#include "oc_core/ocri/camera_choice.h"
#include "oc_core/volume_camera/volume_camera.h"

namespace ocelli {

/// Of a camera that builds reference images, in a scene, which those that are made from the view alone do not look at
/// (needsScene()). `image` is the number of the image, from 1 on, of cameras with several; 0 for those with one. Throws
/// InputError as cameraMaps() does, for what has no rays, where the eye lies inside an object, and for an image that is
/// not there.
RayMap rayMapOf(const CameraChoice& choice, const PinholeCamera& reference, const Mesh& mesh, int image,
                const Progress& progress = {});
bool needsScene(const CameraChoice& choice);

/// Of a graph or curved ray camera; `view` is the one that it was made for.
RayMap rayMapOf(const MultiperspectiveCamera& camera, const std::string& name, const View& view,
                const Progress& progress = {});

/// Of a camera that looks at a volume.
RayMap rayMapOf(const VolumeCamera& camera, const View& view, const Progress& progress = {});

}  // namespace ocelli
