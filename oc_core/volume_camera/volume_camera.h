// The rays of any camera of the toolkit at a volume: from what a user writes after `--camera`, the name of a camera or
// of a constructor, or a JSON file, to a ray for each pixel (sections 4.2.1, 4.4.2 and 5.2).
//
// Pinholes, general pinholes and panoramas are made from the view alone. Constructors of graph and curved ray cameras
// know of a volume what guided_volume.h says. Occlusion cameras (DDOC, EOC, ...) are made from what hides what, which
// is told by the places where rays first hit something opaque: as their reference images are (oc_core/volume_ocri).
#pragma once

#include <functional>
#include <string>

#include "oc_core/base/progress.h"
#include "oc_core/camera/pinhole_camera.h"
#include "oc_core/camera/ray_hull.h"
#include "oc_core/constructor/multiperspective_camera.h"
#include "oc_core/ocri/camera_choice.h"
#include "oc_core/render/ray_target.h"
#include "oc_core/volume/volume_scene.h"

namespace ocelli {

struct VolumeCamera {
  std::string name;         ///< what the user called it
  std::string description;  ///< JSON: the view, and of graph and curved ray cameras all that they are
  glm::ivec2 size{0};       ///< of its image, pixels
  RayFunction ray;          ///< safe to call from many threads
  RayHull hull = {};        ///< where its rays run, likewise; empty where that is not known
  bool isSmooth = false;    ///< kHasSmoothRays
};

/// `firstHits` is called where the camera needs to know what hides what, and must outlive the call alone. Throws
/// InputError for a name or a file that is wrong, for cameras of several images and for meshes, where the options do
/// not fit the volume.
VolumeCamera volumeCamera(const std::string& nameOrFile, const PinholeCamera& reference, const VolumeScene& scene,
                          const std::function<const RayTarget&()>& firstHits, const Progress& progress = {});

/// The same of a camera with options, such as one that is being edited; none of graph and curved ray cameras.
VolumeCamera volumeCamera(const CameraChoice& choice, const PinholeCamera& reference,
                          const std::function<const RayTarget&()>& firstHits, const Progress& progress = {});

/// The same of a graph or curved ray camera that was constructed for the volume (guided_volume.h).
VolumeCamera volumeCamera(const std::string& name, MultiperspectiveCamera camera, const VolumeScene& scene);

}  // namespace ocelli
