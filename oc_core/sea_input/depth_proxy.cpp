#include "oc_core/sea_input/depth_proxy.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

#include "oc_core/base/error.h"
#include "oc_core/depth_views/depth_views_folder.h"
#include "oc_core/depth_views/views_surface.h"
#include "oc_core/ocri/simplified_mesh.h"

namespace ocelli {

std::vector<size_t> spreadPositions(const std::vector<glm::vec3>& positions, size_t count) {
  std::vector<size_t> chosen;
  std::vector<float> distances(positions.size(), std::numeric_limits<float>::infinity());
  while (chosen.size() < std::min(count, positions.size())) {
    const auto farthest = std::max_element(distances.begin(), distances.end());
    chosen.push_back(static_cast<size_t>(farthest - distances.begin()));
    for (size_t i = 0; i < positions.size(); ++i) {
      distances[i] = std::min(distances[i], glm::distance(positions[i], positions[chosen.back()]));
    }
    distances[chosen.back()] = -1;  // images of one place are taken once each
  }
  return chosen;
}

Mesh proxyOfDepths(const std::filesystem::path& folder, size_t triangles) {
  std::error_code ignored;
  if (!std::filesystem::is_directory(folder, ignored)) {
    throw InputError("these images have no depth images beside them", folder.string(),
                     "put views with depth there (docs/views_with_depth.md), or give another --proxy");
  }
  std::vector<DepthView> views = readDepthViews(folder);
  std::vector<glm::vec3> eyes;
  eyes.reserve(views.size());
  for (const DepthView& view : views) {
    eyes.push_back(view.image.view.eye);
  }
  std::vector<DepthView> chosen;
  for (const size_t i : spreadPositions(eyes, kMaxProxyViews)) {
    chosen.push_back(std::move(views[i]));
  }
  const Mesh surface = surfaceOfViews(std::move(chosen)).mesh;
  // Colours would keep vertices apart that stand at one place.
  const Mesh bare{surface.positions, {}, surface.triangles, surface.isPart};
  const SimplifiedMesh simplified = simplifyMesh(bare, triangles, SimplifyMethod::kTopological);
  // Where many pieces end, topology stands in the way.
  return simplified.reachedTarget() ? simplified.mesh : simplifyMesh(bare, triangles, SimplifyMethod::kSloppy).mesh;
}

}  // namespace ocelli
