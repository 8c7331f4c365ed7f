#include "oc_core/remote/client/image_cover.h"

#include <array>
#include <limits>
#include <vector>

namespace ocelli {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr size_t kOutermost = 20;  ///< one sample of so many is nearer than `near`, and one farther than `far`

/// Where a direction meets the pinhole of the image; nothing behind it.
std::optional<glm::dvec2> placeInPinhole(const PinholeCamera& pinhole, const glm::dvec3& direction) {
  const glm::dvec3 d(glm::dot(direction, glm::dvec3(pinhole.right())), glm::dot(direction, glm::dvec3(pinhole.down())),
                     glm::dot(direction, glm::dvec3(pinhole.forward())));
  if (!(d.z > 0)) {
    return std::nullopt;
  }
  return glm::dvec2(pinhole.centerPixels()) + glm::dvec2(d) * (static_cast<double>(pinhole.focalPixels()) / d.z);
}

}  // namespace

DepthSpan depthSpanOf(const ReferenceImage& image) {
  std::vector<float> depths;
  depths.reserve(image.t.size());
  for (size_t i = 0; i < image.t.size(); ++i) {
    if (image.holds(i) && image.t[i] > 0) {
      depths.push_back(image.t[i]);
    }
  }
  if (depths.empty()) {
    return {};
  }
  const auto rank = static_cast<std::ptrdiff_t>(depths.size() / kOutermost);
  const auto near = depths.begin() + rank;
  std::nth_element(depths.begin(), near, depths.end());
  const auto nearZ = static_cast<double>(*near);
  const auto far = depths.end() - 1 - rank;
  std::nth_element(depths.begin(), far, depths.end());
  return {nearZ, static_cast<double>(*far)};
}

ImageCover::ImageCover(const ReferenceImage& image, bool hasDepth)
    : reference(image.reference()),
      map(image.layout, image.width(), image.height()),
      depths(hasDepth ? depthSpanOf(image) : DepthSpan{}) {}

CoverLoad coverLoad(const ImageCover& image, const PinholeCamera& view, const CoverLimits& limits) {
  const PinholeCamera& pinhole = image.reference;
  const auto focal = static_cast<double>(view.focalPixels());
  const glm::dvec2 half = glm::dvec2(pinhole.width(), pinhole.height()) / 2.0;
  const glm::dvec2 size(view.width(), view.height());
  const auto place = [&](const glm::dvec2& pixel) {
    const glm::dvec2 d = (pixel - glm::dvec2(view.centerPixels())) / focal;
    return placeInPinhole(pinhole,
                          glm::dvec3(view.forward()) + glm::dvec3(view.right()) * d.x + glm::dvec3(view.down()) * d.y);
  };
  CoverLoad load;
  const std::array<glm::dvec2, 4> corners{{{0, 0}, {size.x, 0}, {0, size.y}, size}};
  for (const glm::dvec2& corner : corners) {
    const std::optional<glm::dvec2> at = place(corner);
    const glm::dvec2 out = at ? glm::abs(*at - half) / half : glm::dvec2(kInfinity);
    load.reach = std::max({load.reach, out.x, out.y});
  }
  const std::optional<glm::dvec2> middle = place(size / 2.0);
  if (middle) {
    const glm::dvec2 within = glm::clamp(*middle, glm::dvec2(0), half * 2.0);
    const double rate = image.map.rateAt(image.map.imageFromPinhole(within));
    load.detail = limits.leastDetail * focal / (rate * static_cast<double>(pinhole.focalPixels()));
  } else {
    load.detail = kInfinity;
  }
  const double offset = glm::length(glm::dvec3(view.eye()) - glm::dvec3(pinhole.eye()));
  if (offset > 0) {
    const double parallax = offset * image.depths.inverseSpan() * focal / size.y / limits.largestParallax;
    const double angle = offset / image.depths.nearZ / limits.largestAngle;
    load.shift = image.depths.nearZ > 0 ? std::max(parallax, angle) : kInfinity;
  }
  return load;
}

CoverLoad coverLoad(const ImageCover& image, const View& view, const glm::ivec2& screen, const CoverLimits& limits) {
  return coverLoad(image, PinholeCamera(view, screen.x, screen.y), limits);
}

}  // namespace ocelli
