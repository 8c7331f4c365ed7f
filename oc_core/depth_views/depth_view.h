// A view with depth: colours, and how far away what is seen is, from one viewpoint. Pinholes and panoramas.
#pragma once

#include <string>
#include <vector>

#include "oc_core/ocri/reference_image.h"
#include "oc_core/ocri/set_difference.h"

namespace ocelli {

struct DepthView {
  std::string name;  ///< of its file, or as views.json says
  /// A depth image: of a pinhole, displaced nowhere, or placed samples of a panorama.
  ReferenceImage image;
};

/// Throws InputError, naming `where`, where this is a reference image of another camera, or holds no sample.
void requireDepthView(const ReferenceImage& image, const std::string& where);

/// Throws InputError, naming `where`, where there is no view, or where two of them are the same view: the same eye,
/// direction, field of view and kind of camera.
void requireDifferentViews(const std::vector<DepthView>& views, const std::string& where);

/// Where the camera of such an image shows a world point.
Projection projectionOf(const ReferenceImage& image);

/// How far apart rays of neighbouring pixels are at a distance of 1, world units.
float pixelAngle(const ReferenceImage& image);

/// Samples of all of them.
size_t sampleCount(const std::vector<DepthView>& views);

}  // namespace ocelli
