// Images of graph and curved ray cameras that rays can hit, by what a user writes: the name of a constructor
// ("comprehensive"), or a JSON file of one (camera_constructors.h).
#pragma once

#include <string>

#include "oc_core/constructor/multiperspective_camera.h"
#include "oc_core/ocri/reference_image.h"
#include "oc_core/render/fragment_image.h"
#include "oc_core/worlds/scene_source.h"

namespace ocelli {

struct PerspectiveImage {
  MultiperspectiveCamera camera;
  FragmentImage fragments;  ///< of the mesh that was drawn

  /// Its samples, where they are in the world.
  ReferenceImage samples(const Mesh& mesh, const std::string& name) const;
};

/// The camera is constructed for `scene` and the reference view, and draws `mesh`. A file that says a size has its
/// image of that size. Throws InputError where the camera cannot be constructed.
PerspectiveImage perspectiveImage(const std::string& nameOrFile, const GuidedScene& scene, const Mesh& mesh,
                                  const PinholeCamera& reference);

/// The graph camera of an image. Throws InputError for a curved ray camera, which has no frusta.
const GraphCamera& graphCameraOf(const PerspectiveImage& image, const std::string& nameOrFile);

}  // namespace ocelli
