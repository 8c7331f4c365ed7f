// The image that a solid scene would give: its surfaces opaque, seen by the observer's eye at the observer's size.
#pragma once

#include "display_sim/observing/observer.h"
#include "oc_core/camera/view.h"
#include "oc_core/image/png_file.h"
#include "oc_core/scene/mesh.h"

namespace ocelli {

/// Samples of a pixel of such images, along u and along v.
inline constexpr int kOpaqueSamplesASide = 2;

/// The observer's eye as a pinhole's: that of EyePerspective.
View viewOfObserver(const ObserverOptions& options);

/// An image whose pixels are the means of those samples, in sRGB.
Image<Rgb8> meanOfSamples(const Image<glm::vec3>& samples);

/// On black, each pixel the mean of its samples. Of `options` counts what says where the eye is and what its image
/// holds.
Image<Rgb8> opaqueImage(const Mesh& scene, const ObserverOptions& options);

}  // namespace ocelli
