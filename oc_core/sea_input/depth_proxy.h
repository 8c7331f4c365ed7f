// A proxy for images that come with depth: the surface that some of the depth images show together
// (oc_core/depth_views), with fewer triangles.
#pragma once

#include <filesystem>

#include "oc_core/scene/mesh.h"

namespace ocelli {

/// Of so many depth images at most, which are spread well.
inline constexpr size_t kMaxProxyViews = 16;

/// Where the depth images of a folder of images are.
inline constexpr const char* kDepthFolder = "depth";

/// `folder` has views with depth (docs/views_with_depth.md), in the coordinates of the sea. At most so many triangles.
/// Throws InputError where it has none, and as readDepthViews() does.
Mesh proxyOfDepths(const std::filesystem::path& folder, size_t triangles);

/// The numbers of `count` positions, or of all: the first one, then again and again the one that is farthest from all
/// before it.
std::vector<size_t> spreadPositions(const std::vector<glm::vec3>& positions, size_t count);

}  // namespace ocelli
