#include "oc_core/explore/split_visibility.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>

namespace ocelli {
namespace {

constexpr int kSplitRows = 24;         // looked at along a line
constexpr float kBesidePixels = 1.5f;  // how far from it, on either side
constexpr double kApartMetres = 0.3;   // between what is seen on both sides
constexpr double kMinSplitPixels = 2;  // a shorter line is none

/// Whether the image jumps there.
bool jumpsAt(const GraphCamera& camera, const ExploreScene& scene, const glm::vec2& pixel) {
  const auto seen = [&](float offset) {
    const RayPath ray = camera.rayPath(pixel + glm::vec2(offset, 0));
    return ray.size() < 2 ? std::nullopt : scene.cast(ray);
  };
  const std::optional<ExploreHit> left = seen(-kBesidePixels);
  const std::optional<ExploreHit> right = seen(kBesidePixels);
  if (!left || !right) {
    return left.has_value() != right.has_value();
  }
  return static_cast<double>(glm::distance(left->position, right->position)) > kApartMetres * scene.metre();
}

}  // namespace

std::vector<SplitLine> SplitVisibility::next(const GraphCamera& camera, const ExploreScene& scene) {
  std::vector<SplitLine> lines = splitLines(camera);
  std::vector<SplitDepth> depths;
  for (size_t i = 0; i < lines.size(); ++i) {
    const SplitLine& line = lines[i];
    const double middle = (line.top + line.bottom) / 2;
    double above = 0;
    double below = 0;
    for (int row = 0; row < kSplitRows; ++row) {
      const double v = line.top + (line.bottom - line.top) * (row + 0.5) / kSplitRows;
      if (jumpsAt(camera, scene, glm::vec2(line.u, v))) {
        above = std::max(above, middle - v);
        below = std::max(below, v - middle);
      }
    }
    depths.push_back({std::to_string(i) + " above", above});
    depths.push_back({std::to_string(i) + " below", below});
  }
  const std::vector<SplitDepth> means = means_.next(depths);
  for (size_t i = 0; i < lines.size(); ++i) {
    const double middle = (lines[i].top + lines[i].bottom) / 2;
    lines[i].top = middle - means[2 * i].depth;
    lines[i].bottom = middle + means[2 * i + 1].depth;
  }
  std::erase_if(lines, [](const SplitLine& line) { return line.bottom - line.top < kMinSplitPixels; });
  return lines;
}

}  // namespace ocelli
