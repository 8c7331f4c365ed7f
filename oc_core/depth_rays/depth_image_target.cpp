#include "oc_core/depth_rays/depth_image_target.h"

#include "oc_core/render/ray_segment.h"

namespace ocelli {
namespace {

/// `meet(straight)` for each straight piece, until one meets something.
template <class Meet>
std::optional<Hit> firstHit(const RayPath& path, const Mesh& mesh, const Meet& meet) {
  for (size_t i = 1; i < path.size(); ++i) {
    const StraightRay straight{path[i - 1], path[i] - path[i - 1], 1};
    if (!castable(straight.origin, straight.step) || !straight.hasDirection()) {
      continue;
    }
    StraightRay reaching = straight;
    reaching.reach = reachOf(path, i);
    const std::optional<TriangleMeeting> meeting = meet(reaching);
    if (!meeting) {
      continue;
    }
    const glm::uvec3& t = mesh.triangles[meeting->triangle];
    const auto between = [&](const auto& corner) {
      return corner(t.x) * (1 - meeting->b1 - meeting->b2) + corner(t.y) * meeting->b1 + corner(t.z) * meeting->b2;
    };
    Hit hit;
    hit.t = path.tAt({i - 1, std::min(static_cast<float>(meeting->share), 1.0f)});
    hit.position = between([&](uint32_t vertex) { return mesh.positions[vertex]; });
    hit.color = between([&](uint32_t vertex) { return mesh.color(vertex); });
    hit.element = meeting->triangle;
    return hit;
  }
  return std::nullopt;
}

}  // namespace

DepthImageTarget::DepthImageTarget(const ReferenceImages& images) : DepthImageTarget(sampleCells(images), kCells) {}

DepthImageTarget::DepthImageTarget(SampleCells cells, Cells)
    : cells_(std::make_unique<SampleCells>(std::move(cells))), pyramid_(*cells_) {}

std::optional<Hit> DepthImageTarget::hit(const RayPath& ray) const {
  RayCost ignored;
  return hit(ray, ignored);
}

std::optional<Hit> DepthImageTarget::hit(const RayPath& ray, RayCost& cost) const {
  return firstHit(ray, cells_->mesh, [&](const StraightRay& straight) { return pyramid_.meet(straight, cost); });
}

std::optional<Hit> DepthImageTarget::hitSlowly(const RayPath& ray) const {
  return firstHit(ray, cells_->mesh, [&](const StraightRay& straight) { return meetEveryCell(*cells_, straight); });
}

}  // namespace ocelli
