// Draws many triangles on all threads: the workers take blocks of triangles from a common counter, each fills a
// visibility buffer of its own, and the buffers are merged. Merging keeps the closest, so the image is the same for any
// number of threads.
#pragma once

#include <cstddef>
#include <functional>

#include "oc_core/render/visibility_buffer.h"

namespace ocelli {

FragmentImage drawParallel(int width, int height, size_t triangleCount,
                           const std::function<void(VisibilityBuffer& buffer, size_t begin, size_t end)>& draw);

}  // namespace ocelli
