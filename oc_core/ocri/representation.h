// What stands for a scene near a viewpoint: reference images with their mesh, or a mesh alone.
#pragma once

#include "oc_core/ocri/camera_choice.h"

namespace ocelli {

struct Representation {
  std::string name;
  ReferenceImages images;  ///< none for those that are a mesh alone
  Mesh mesh;

  size_t sampleCount() const;  ///< of the images; vertices of the mesh where there are none
  size_t pixelCount() const;   ///< of the images, empty ones too
};

/// How long the two steps took.
struct RepresentationTimes {
  double buildMilliseconds = 0;
  double meshMilliseconds = 0;
};

/// Throws as buildReferenceImages() does.
Representation buildRepresentation(const CameraChoice& choice, const PinholeCamera& reference, const Mesh& mesh,
                                   const Progress& progress = {}, RepresentationTimes* times = nullptr);

/// The same of what is no mesh.
Representation buildRepresentation(const CameraChoice& choice, const PinholeCamera& reference,
                                   const TargetRenderer& target, const Progress& progress = {},
                                   RepresentationTimes* times = nullptr);

}  // namespace ocelli
