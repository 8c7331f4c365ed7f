#include "display_sim/volume_solidity/volume_sight.h"

#include <algorithm>
#include <cmath>

#include "display_sim/solidity/opaque_image.h"
#include "display_sim/solidity/voxel_visibility.h"
#include "oc_core/base/parallel.h"

namespace ocelli {
namespace {

/// Where the opacity of each pixel's ray reaches the renderer's threshold.
Image<float> opacityDepths(const PinholeCamera& camera, const VolumeRenderer& renderer) {
  Image<float> depths(camera.width(), camera.height());
  parallelFor(static_cast<size_t>(camera.height()), 1, [&](size_t begin, size_t end) {
    std::vector<RayPath> rays(static_cast<size_t>(camera.width()));
    std::vector<VolumePixel> pixels(rays.size());
    for (size_t y = begin; y < end; ++y) {
      for (size_t x = 0; x < rays.size(); ++x) {
        rays[x] = camera.rayPath({static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f});
      }
      renderer.firstHits(rays, pixels);
      for (size_t x = 0; x < rays.size(); ++x) {
        depths(static_cast<int>(x), static_cast<int>(y)) = std::min(pixels[x].t, pixels[x].surfaceT);
      }
    }
  });
  return depths;
}

}  // namespace

VolumeSight::VolumeSight(const VolumeRenderer& renderer, const std::vector<glm::vec3>& eyes, int side,
                         const Progress& progress) {
  for (size_t i = 0; i < eyes.size(); ++i) {
    report(progress, "looking into the volume", static_cast<double>(i) / static_cast<double>(eyes.size()));
    const PinholeCamera camera(viewOfObserver({.eye = eyes[i]}), side, side);
    eyes_.push_back({camera, opacityDepths(camera, renderer)});
  }
  report(progress, "looking into the volume", 1);
}

bool VolumeSight::sees(const glm::dvec3& point, double cellSide) const {
  return std::ranges::any_of(eyes_, [&](const Eye& eye) {
    const std::optional<ImagePoint> image = eye.camera.project(glm::vec3(point));
    if (!image) {
      return false;
    }
    // The pixels around: the point lies between the centres of four.
    const int u = static_cast<int>(std::floor(image->u - 0.5f));
    const int v = static_cast<int>(std::floor(image->v - 0.5f));
    const auto reach = static_cast<float>(kVoxelReach * cellSide);
    for (int y = std::max(v, 0); y <= std::min(v + 1, eye.depths.height() - 1); ++y) {
      for (int x = std::max(u, 0); x <= std::min(u + 1, eye.depths.width() - 1); ++x) {
        if (image->t <= eye.depths(x, y) + reach) {
          return true;
        }
      }
    }
    return false;
  });
}

}  // namespace ocelli
