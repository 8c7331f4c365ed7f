// The image-set-difference of two reference images, by any two cameras (section 3.1.4): a sample of the first that the
// second holds too is a duplicate. The union of an image and of what a second one adds to it lacks nothing that the
// first one shows.
#pragma once

#include <cstdint>
#include <functional>

#include "oc_core/ocri/reference_image.h"

namespace ocelli {

/// Where a camera shows a world point: its `project`.
using Projection = std::function<std::optional<ImagePoint>(const glm::vec3& worldPoint)>;

struct SetDifferenceOptions {
  /// A sample is held where one of the 3x3 samples around its place in the other image is at most so many pixel
  /// footprints away in space.
  /// DEVIATION: the text compares z alone. On a grazing surface z changes by many footprints from pixel to pixel.
  float maxFootprints = 1.5f;
  /// Around what is left, so many duplicates of the same surface stay: the meshes of both images then overlap.
  int seamPixels = 1;
};

/// Empties the samples of `image` that `other` holds, whose camera projects as `projection` says. Returns how many are
/// left.
size_t subtract(ReferenceImage& image, const ReferenceImage& other, const Projection& projection,
                const SetDifferenceOptions& options = {});

/// Also marks (not 0) the neighbours of marked samples that lie on the same surface, to judge by their depth: along
/// rows and, where the rows of the image are aligned, columns.
void growAlongSurface(Image<uint8_t>& marks, const ReferenceImage& image);

/// Empties the samples that are not marked.
void keepMarked(ReferenceImage& image, const Image<uint8_t>& marks);

}  // namespace ocelli
