#include "oc_core/sea/sea_between.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

#include "oc_core/base/check.h"

namespace ocelli {
namespace {

constexpr size_t kNeighbors = 3;

}  // namespace

std::vector<SeaNeighbor> nearestNeighbors(std::span<const glm::dvec3> positions, const glm::dvec3& place) {
  OC_CHECK(!positions.empty(), "a sea has images");
  std::vector<std::pair<double, uint32_t>> byDistance;
  byDistance.reserve(positions.size());
  for (uint32_t i = 0; i < positions.size(); ++i) {
    byDistance.emplace_back(glm::distance(positions[i], place), i);
  }
  const size_t count = std::min(byDistance.size(), kNeighbors + 1);
  std::partial_sort(byDistance.begin(), byDistance.begin() + static_cast<ptrdiff_t>(count), byDistance.end());
  const bool hasFourth = count > kNeighbors;
  const double reach = hasFourth ? byDistance[kNeighbors].first : 2 * byDistance[count - 1].first;
  std::vector<SeaNeighbor> neighbors;
  double sum = 0;
  for (size_t i = 0; i < std::min(count, kNeighbors); ++i) {
    const double distance = byDistance[i].first;
    // The nearer, the more without bound: at its own place an image is all that is seen.
    constexpr double kNone = 1e-9;
    const double weight =
        reach > 0 ? std::max(0.0, 1 - distance / reach) / std::max(distance / reach, kNone) : (i == 0 ? 1.0 : 0.0);
    neighbors.push_back({byDistance[i].second, weight});
    sum += weight;
  }
  if (sum <= 0) {  // all are equally far
    for (SeaNeighbor& neighbor : neighbors) {
      neighbor.weight = 1;
    }
    sum = static_cast<double>(neighbors.size());
  }
  for (SeaNeighbor& neighbor : neighbors) {
    neighbor.weight /= sum;
  }
  return neighbors;
}

Image<Rgb8> blendedView(const SeaDecoder& decoder, std::span<const BlendedImage> images, const SeaCamera& target) {
  const SeaProjection& projection = target.projection;
  Image<glm::vec4> sums(projection.width, projection.height, glm::vec4(0));
  for (const BlendedImage& each : images) {
    const PartialImage warped =
        warpedOver(decoder.proxy(), *each.image, each.pose, target, decoder.settings().warpCell);
    const auto weight = static_cast<float>(each.weight);
    for (size_t i = 0; i < sums.size(); ++i) {
      if (warped.isKnown[i] != 0) {
        sums[i] += glm::vec4(glm::vec3(warped.image[i]), 1.0f) * weight;
      }
    }
  }
  PartialImage view{Image<Rgb8>(projection.width, projection.height, Rgb8(0)),
                    Image<uint8_t>(projection.width, projection.height, 0)};
  for (size_t i = 0; i < sums.size(); ++i) {
    if (sums[i].w > 0) {
      view.isKnown[i] = 1;
      view.image[i] = Rgb8(glm::clamp(glm::vec3(sums[i]) / sums[i].w + 0.5f, 0.0f, 255.0f));
    }
  }
  fillUnknown(view);
  return std::move(view.image);
}

}  // namespace ocelli
