#include "oc_core/sea_input/rendered_images.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <utility>

namespace ocelli {
namespace {

constexpr int kTile = 16;  ///< samples a side that are cast together

}  // namespace

RenderedImages::RenderedImages(std::string description, const Mesh& mesh, std::vector<SeaPose> poses,
                               const Options& options)
    : description_(std::move(description)), mesh_(mesh), rays_(mesh), poses_(std::move(poses)), options_(options) {}

Image<Rgb8> RenderedImages::image(uint32_t index) const {
  const SeaProjection& projection = options_.projection;
  const int samples = options_.samples;
  const int width = projection.width * samples;
  const int height = projection.height * samples;
  const glm::vec3 eye(poses_[index].position);
  const glm::quat worldFromCamera(poses_[index].worldFromCamera);
  const Box box = boundsOf(mesh_);
  const float far = 2 * (glm::distance(box.lower, box.upper) + glm::distance(eye, box.lower));
  Image<glm::vec3> sums(projection.width, projection.height, glm::vec3(0));
  std::vector<RayPath> rays;
  std::vector<Fragment> fragments;
  for (int top = 0; top < height; top += kTile) {
    for (int left = 0; left < width; left += kTile) {
      const int bottom = std::min(top + kTile, height);
      const int right = std::min(left + kTile, width);
      rays.clear();
      for (int y = top; y < bottom; ++y) {
        for (int x = left; x < right; ++x) {
          const glm::vec2 pixel = (glm::vec2(x, y) + 0.5f) / static_cast<float>(samples);
          rays.push_back({eye, eye + worldFromCamera * projection.direction(pixel) * far});
        }
      }
      fragments.resize(rays.size());
      rays_.intersect(rays, fragments);
      size_t at = 0;
      for (int y = top; y < bottom; ++y) {
        for (int x = left; x < right; ++x, ++at) {
          sums(x / samples, y / samples) +=
              fragments[at].covered() ? colorOf(fragments[at], mesh_) : options_.background;
        }
      }
    }
  }
  for (glm::vec3& sum : sums) {
    sum /= static_cast<float>(samples * samples);
  }
  return srgbFromLinear(sums);
}

}  // namespace ocelli
