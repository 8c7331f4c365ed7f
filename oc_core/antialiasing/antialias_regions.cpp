#include "oc_core/antialiasing/antialias_regions.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace ocelli {

double trianglesPerPixel(const AntialiasScene& scene, const PixelBounds& box) {
  constexpr int kBlock = AntialiasBins::kBlock;
  const AntialiasBins& bins = scene.bins();
  double triangles = 0;
  double pixels = 0;
  for (int y = box.y0 / kBlock; y * kBlock < box.y1; ++y) {
    for (int x = box.x0 / kBlock; x * kBlock < box.x1; ++x) {
      triangles += static_cast<double>(bins.trianglesOf(static_cast<size_t>(y * bins.across() + x)).size());
      pixels += kBlock * kBlock;
    }
  }
  return pixels > 0 ? triangles / pixels : 0;
}

AntialiasRegion fittedRegion(const AntialiasScene& scene, const PixelBounds& box, const AntialiasTile& tile) {
  const double density = trianglesPerPixel(scene, box);
  const int fits = std::min(tile.width / (box.x1 - box.x0), tile.height / (box.y1 - box.y0));
  const int asked = static_cast<int>(std::ceil(kSideOfOneTriangle * std::pow(density, 1.0 / 6)));
  return {box, std::clamp(std::min(fits, asked), 1, kMaxFittedSide), density};
}

std::vector<PixelBounds> objectRectangles(const AntialiasScene& scene, const std::vector<uint32_t>& objectOfTriangle,
                                          double dense) {
  struct Extent {
    ImageBox box{glm::vec2(1e30f), glm::vec2(-1e30f)};
    double triangles = 0;
  };
  std::map<uint32_t, Extent> objects;
  for (size_t i = 0; i < objectOfTriangle.size(); ++i) {
    if (objectOfTriangle[i] == 0) {
      continue;
    }
    ImageBox box = boxOfTriangle(scene.projected(), scene.bins().parts(), static_cast<uint32_t>(i));
    if (box.lower.x <= box.upper.x) {
      box = scene.view().imageBox(box);
      Extent& extent = objects[objectOfTriangle[i]];
      extent.box = {glm::min(extent.box.lower, box.lower), glm::max(extent.box.upper, box.upper)};
      extent.triangles += 1;
    }
  }
  std::vector<PixelBounds> rectangles;
  for (const auto& [object, extent] : objects) {
    const glm::vec2 size = extent.box.upper - extent.box.lower;
    const double pixels = std::max(static_cast<double>(size.x), 1.0) * std::max(static_cast<double>(size.y), 1.0);
    const PixelBounds within = pixelsOf(extent.box, scene.view().width(), scene.view().height());
    if (within.x0 < within.x1 && within.y0 < within.y1 && extent.triangles > dense * pixels) {
      rectangles.push_back(within);
    }
  }
  return rectangles;
}

AntialiasPlan regionPlan(const AntialiasView& view, const std::vector<AntialiasRegion>& regions,
                         const SamplePlacement& placement, size_t maxExactTriangles, const PixelRule& outside) {
  AntialiasPlan plan;
  plan.rules.push_back(outside);
  plan.ruleOfPixel = Image<uint8_t>(view.width(), view.height());
  std::map<int, uint8_t> ruleOfSide;
  for (const AntialiasRegion& region : regions) {
    if (region.side * region.side > outside.pattern->size()) {
      ruleOfSide[region.side] = 0;
    }
  }
  for (auto& [side, rule] : ruleOfSide) {  // from few samples to many: at most kMaxSide rules
    rule = static_cast<uint8_t>(plan.rules.size());
    plan.rules.push_back({std::make_shared<SamplePattern>(side, placement), false, maxExactTriangles});
  }
  for (const AntialiasRegion& region : regions) {
    if (!ruleOfSide.contains(region.side)) {
      continue;
    }
    for (int y = region.box.y0; y < region.box.y1; ++y) {
      for (int x = region.box.x0; x < region.box.x1; ++x) {
        uint8_t& rule = plan.ruleOfPixel(x, y);
        rule = std::max(rule, ruleOfSide[region.side]);
      }
    }
  }
  return plan;
}

}  // namespace ocelli
