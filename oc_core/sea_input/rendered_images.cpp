#include "oc_core/sea_input/rendered_images.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <utility>

namespace ocelli {
namespace {

constexpr int kBatch = 16;  ///< pixels in a row whose rays are cast together

DirectionTable directionsOf(const RenderedImages::Options& options) {
  const float step = 1 / static_cast<float>(options.samples);
  return {options.projection,
          {options.projection.width * options.samples, options.projection.height * options.samples, step / 2, step}};
}

}  // namespace

RenderedImages::RenderedImages(std::string description, const Mesh& mesh, std::vector<SeaPose> poses,
                               const Options& options)
    : description_(std::move(description)),
      mesh_(mesh),
      rays_(mesh),
      poses_(std::move(poses)),
      options_(options),
      directions_(directionsOf(options)) {}

Image<Rgb8> RenderedImages::image(uint32_t index) const {
  const SeaProjection& projection = options_.projection;
  const int samples = options_.samples;
  const glm::vec3 eye(poses_[index].position);
  const glm::mat3 worldFromCamera = glm::mat3_cast(glm::quat(poses_[index].worldFromCamera));
  const Box box = rays_.bounds();
  const float far = 2 * (glm::distance(box.lower, box.upper) + glm::distance(eye, box.lower));
  Image<Rgb8> image(projection.width, projection.height);
  std::vector<SightLine> lines;
  std::vector<Fragment> fragments;
  for (int y = 0; y < projection.height; ++y) {
    for (int left = 0; left < projection.width; left += kBatch) {
      const int right = std::min(left + kBatch, projection.width);
      // Those of a pixel one after another: so the rays of a packet run alike.
      lines.clear();
      for (int x = left; x < right; ++x) {
        for (int row = y * samples; row < (y + 1) * samples; ++row) {
          for (int column = x * samples; column < (x + 1) * samples; ++column) {
            lines.push_back({eye, eye + worldFromCamera * directions_(column, row) * far});
          }
        }
      }
      fragments.resize(lines.size());
      rays_.meet(lines, fragments);
      auto fragment = fragments.begin();
      for (int x = left; x < right; ++x) {
        glm::vec3 sum(0);
        for (int sample = 0; sample < samples * samples; ++sample, ++fragment) {
          sum += fragment->covered() ? colorOf(*fragment, mesh_) : options_.background;
        }
        image(x, y) = encoder_.bytesFromLinear(sum / static_cast<float>(samples * samples));
      }
    }
  }
  return image;
}

}  // namespace ocelli
