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

/// How far an image reaches from its middle, by how far the screen does: tangents of angles.
glm::dvec2 reachOf(const PinholeCamera& screen, double reach) {
  const glm::dvec2 own =
      glm::dvec2(screen.width(), screen.height()) / (2.0 * static_cast<double>(screen.focalPixels()));
  const double most = radiansFromDegrees(kMaxSideDegrees);
  const auto wider = [&](double tangent) {
    return std::max(tangent, std::tan(std::min(std::atan(tangent) * reach, most))) / tangent;
  };
  return {wider(own.x), wider(own.y)};
}

/// Pixels of the image: `wanted` where an image may be as large.
glm::ivec2 imageSize(const glm::dvec2& wanted) {
  const double least = std::min({1.0, kMaxCodedSide / std::max(wanted.x, wanted.y),
                                 std::sqrt(0.999 * static_cast<double>(kMaxCodedPixels) / (wanted.x * wanted.y))});
  const glm::dvec2 pixels = glm::round(wanted * least);
  return {std::max(1, static_cast<int>(pixels.x)), std::max(1, static_cast<int>(pixels.y))};
}

View widened(const RemoteRequest& request, double reachDown) {
  View view = request.view;
  const double own = std::tan(radiansFromDegrees(view.resolvedFovVerticalDegrees()) / 2);
  view.fovVerticalDegrees = degreesFromRadians(2 * std::atan(own * reachDown));
  view.centerShift /= static_cast<float>(reachDown);
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
  validate(request, "request");
  validate(settings, "settings");
  const PinholeCamera screen(request.view, request.screen.x, request.screen.y);
  const glm::dvec2 reach = reachOf(screen, settings.reach);
  const glm::ivec2 size = imageSize(glm::dvec2(request.screen) * reach * (settings.size / settings.reach));
  const PinholeCamera reference(widened(request, reach.y), size.x, size.y);
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
