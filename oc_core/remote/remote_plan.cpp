#include "oc_core/remote/remote_plan.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "oc_core/image_codecs/image_codec.h"
#include "oc_core/remote/region_wishes.h"

namespace ocelli {
namespace {

/// Farther to the side, samples lie so far apart that more of them show next to nothing.
constexpr double kMaxSideDegrees = 80;

/// Pixels of the image.
glm::ivec2 imageSize(const glm::ivec2& screen, double size) {
  const glm::dvec2 wanted = glm::dvec2(screen) * size;
  const double least = std::min({1.0, kMaxCodedSide / std::max(wanted.x, wanted.y),
                                 std::sqrt(0.999 * static_cast<double>(kMaxCodedPixels) / (wanted.x * wanted.y))});
  const glm::dvec2 pixels = glm::round(wanted * least);
  return {std::max(1, static_cast<int>(pixels.x)), std::max(1, static_cast<int>(pixels.y))};
}

View widened(const RemoteRequest& request, double reach) {
  View view = request.view;
  const double aspect = static_cast<double>(request.screen.x) / request.screen.y;
  const double own = std::tan(radiansFromDegrees(view.resolvedFovVerticalDegrees()) / 2);
  const double side = std::tan(radiansFromDegrees(kMaxSideDegrees)) / std::max(1.0, aspect);
  const double half = std::max(own, std::min(own * reach, side));
  view.fovVerticalDegrees = degreesFromRadians(2 * std::atan(half));
  view.centerShift *= static_cast<float>(own / half);
  return view;
}

/// What a lens shows at its full zoom, in the image.
RegionWish wishOf(const GpcRegion& lens, const glm::dvec2& imageFromScreen, double samplesPerScreenPixel) {
  const auto zoom = static_cast<double>(lens.zoom);
  return {.center = 0.5 + (glm::dvec2(lens.center) - 0.5) * imageFromScreen,
          .content = glm::dvec2(lens.extent) / zoom * imageFromScreen,
          .zoom = zoom / samplesPerScreenPixel,
          .transition = static_cast<double>(lens.transitionWidth)};
}

}  // namespace

RemotePlan planRemoteImage(const RemoteRequest& request, const RemoteSettings& settings) {
  validate(settings, "settings");
  const glm::ivec2 size = imageSize(request.screen, settings.size);
  const PinholeCamera screen(request.view, request.screen.x, request.screen.y);
  const PinholeCamera reference(widened(request, settings.reach), size.x, size.y);
  const double rate = static_cast<double>(reference.focalPixels()) / static_cast<double>(screen.focalPixels());
  const glm::dvec2 imageFromScreen = glm::dvec2(request.screen) * rate / glm::dvec2(size);

  std::vector<RegionWish> wishes;
  for (const GpcRegion& lens : request.lenses) {
    wishes.push_back(wishOf(lens, imageFromScreen, rate));
  }
  const RegionWish middle{.center = glm::dvec2(0.5),
                          .content = glm::dvec2(settings.middle / settings.zoom),
                          .zoom = settings.zoom,
                          .transition = 1 / settings.middle - 1};
  RemotePlan plan{reference, {.sampling = findGpcSampling(settings.sampling.c_str()), .regions = {}}};
  plan.layout.regions = regionsOf(std::move(wishes), middle);
  validate(plan.layout, "planned regions");
  return plan;
}

}  // namespace ocelli
