#include "oc_core/focus/focus_comparison.h"

#include <chrono>
#include <glm/common.hpp>

#include "oc_core/base/check.h"

namespace ocelli {
namespace {

template <class Draw>
double millisecondsOf(const Draw& draw) {
  const auto start = std::chrono::steady_clock::now();
  draw();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

void keepLeast(std::optional<double>& least, double milliseconds) {
  least = std::min(least.value_or(milliseconds), milliseconds);
}

/// In turn for all ways, so that what else the machine does hits all alike.
void measureTimes(std::vector<FocusResult>& results, const std::vector<std::unique_ptr<FocusMap>>& maps,
                  const GpcLayout& layout, const PinholeCamera& plain, const Mesh& mesh, const RayScene& rays, int runs,
                  const Progress& progress) {
  std::vector<std::optional<double>> byRays(results.size());
  for (int run = 0; run < runs; ++run) {
    for (size_t i = 0; i < results.size(); ++i) {
      report(progress, "drawing in turn",
             static_cast<double>(run * static_cast<int>(results.size()) + static_cast<int>(i)) /
                 (runs * static_cast<double>(results.size())));
      keepLeast(byRays[i], millisecondsOf([&] { drawFocus(*maps[i], plain, rays); }));
      if (results[i].way->raster) {
        keepLeast(results[i].rasterMilliseconds, millisecondsOf([&] { results[i].way->raster(layout, plain, mesh); }));
      }
    }
  }
  for (size_t i = 0; i < results.size(); ++i) {
    results[i].raysMilliseconds = byRays[i].value_or(0);
  }
}

/// The plain view in the colours of how it is sampled.
Image<Rgb8> keptImage(const Image<float>& rates, const RateRange& range, const Image<Rgb8>& plainPicture) {
  Image<Rgb8> image = rateHeat(rates, range, plainPicture);
  for (size_t i = 0; i < rates.size(); ++i) {
    if (!(rates[i] > 0)) {
      image[i] = kHiddenColor;
    }
  }
  return image;
}

}  // namespace

FragmentImage drawFocus(const FocusMap& map, const PinholeCamera& plain, const RayScene& rays) {
  return castRays(plain.width(), plain.height(), rays, [&](const glm::vec2& pixel) {
    return plain.rayPath(glm::vec2(map.plainFromPicture(glm::dvec2(pixel))));
  });
}

FocusComparison compareFocusWays(std::span<const FocusWay> ways, const GpcLayout& layout, const PinholeCamera& plain,
                                 const Mesh& mesh, const FocusComparisonOptions& options, const Progress& progress) {
  validate(layout, "camera");
  requireFoci(layout, "camera");
  OC_CHECK(options.runs > 0, "times come from runs");
  FocusComparison comparison{{plain.width(), plain.height()}, {}, {}};
  report(progress, "acceleration structure", 0);
  const RayScene rays(mesh);
  std::vector<std::unique_ptr<FocusMap>> maps;
  std::vector<Image<float>> rates;
  for (const FocusWay& way : ways) {
    report(progress, std::string("measuring ") + way.name,
           static_cast<double>(comparison.results.size()) / static_cast<double>(ways.size()));
    maps.push_back(way.map(layout, comparison.size));
    FocusResult result{.way = &way, .figures = focusFigures(*maps.back(), layout, comparison.size)};
    result.picture = srgbFromLinear(colorImage(drawFocus(*maps.back(), plain, rays), mesh, glm::vec3(0)));
    rates.push_back(pictureRates(*maps.back(), comparison.size));
    for (const float rate : rates.back()) {
      comparison.range.least = std::min(comparison.range.least, static_cast<double>(rate));
      comparison.range.greatest = std::max(comparison.range.greatest, static_cast<double>(rate));
    }
    comparison.results.push_back(std::move(result));
  }
  const Image<Rgb8> plainPicture = srgbFromLinear(
      colorImage(castRays(plain.width(), plain.height(), rays, [&](const glm::vec2& p) { return plain.rayPath(p); }),
                 mesh, glm::vec3(0)));
  for (size_t i = 0; i < maps.size(); ++i) {
    FocusResult& result = comparison.results[i];
    result.rates = rateHeat(rates[i], comparison.range, result.picture);
    result.kept = keptImage(plainRates(*maps[i], comparison.size), comparison.range, plainPicture);
  }
  measureTimes(comparison.results, maps, layout, plain, mesh, rays, options.runs, progress);
  return comparison;
}

}  // namespace ocelli
