// RayScene without Embree: slower, with the same results but for rounding.
#include <algorithm>
#include <limits>
#include <optional>

#include "oc_core/render/ray_segment.h"
#include "oc_core/render/raycast.h"
#include "oc_core/render/refit_quality.h"
#include "oc_core/render/triangle_tree.h"

namespace ocelli {

struct RayScene::Impl {
  Impl(const Mesh& ofMesh, Motion motion) : mesh(ofMesh), tree(ofMesh) {
    if (motion == Motion::kMoves) {
      quality.emplace(mesh);
    }
  }

  Fragment met(const SightLine& line) const {
    const glm::vec3 step = line.to - line.from;
    const auto meeting = castable(line.from, step) ? tree.meet(line.from, step, 1) : std::nullopt;
    return meeting ? Fragment{std::min(static_cast<float>(meeting->share), 1.0f), meeting->triangle, meeting->b1,
                              meeting->b2}
                   : Fragment{};
  }

  const Mesh& mesh;
  TriangleTree tree;
  std::optional<RefitQuality> quality;  ///< of a scene that moves
};

RayScene::RayScene(const Mesh& mesh, Quality /*quality*/, Motion motion)
    : impl_(std::make_unique<Impl>(mesh, motion)) {}
RayScene::~RayScene() = default;

RayScene::Update RayScene::update() {
  OC_CHECK(impl_->quality.has_value(), "only a scene that moves is updated");
  if (impl_->quality->ratio() < RefitQuality::kMaxRatio) {
    impl_->tree.refit();
    return Update::kRefitted;
  }
  impl_ = std::make_unique<Impl>(impl_->mesh, Motion::kMoves);
  return Update::kRebuilt;
}

Fragment RayScene::intersect(const RayPath& path) const {
  for (size_t i = 1; i < path.size(); ++i) {
    const glm::vec3& origin = path[i - 1];
    const glm::vec3 step = path[i] - origin;
    if (!castable(origin, step)) {
      continue;
    }
    if (const auto meeting = impl_->tree.meet(origin, step, static_cast<double>(reachOf(path, i)))) {
      const float share = std::min(static_cast<float>(meeting->share), 1.0f);
      return {path.tAt({i - 1, share}), meeting->triangle, meeting->b1, meeting->b2};
    }
  }
  return {};
}

void RayScene::intersect(std::span<const RayPath> paths, std::span<Fragment> fragments) const {
  OC_CHECK(paths.size() == fragments.size(), "one fragment a path");
  std::transform(paths.begin(), paths.end(), fragments.begin(), [&](const RayPath& path) { return intersect(path); });
}

void RayScene::meet(std::span<const SightLine> lines, std::span<float> shares) const {
  OC_CHECK(lines.size() == shares.size(), "one share a line");
  std::transform(lines.begin(), lines.end(), shares.begin(), [&](const SightLine& line) {
    const Fragment met = impl_->met(line);
    return met.covered() ? met.t : std::numeric_limits<float>::infinity();
  });
}

void RayScene::meet(std::span<const SightLine> lines, std::span<Fragment> fragments) const {
  OC_CHECK(lines.size() == fragments.size(), "one fragment a line");
  std::transform(lines.begin(), lines.end(), fragments.begin(),
                 [&](const SightLine& line) { return impl_->met(line); });
}

const Mesh& RayScene::mesh() const {
  return impl_->mesh;
}

Box RayScene::bounds() const {
  return impl_->tree.bounds();
}

bool RayScene::hasSurfaceNear(const glm::vec3& point, float reach) const {
  return impl_->tree.nearest(point, reach).has_value();
}

std::optional<RayScene::SurfacePoint> RayScene::closestSurface(const glm::vec3& point, float reach) const {
  const auto found = impl_->tree.nearest(point, reach);
  return found ? std::optional(SurfacePoint{found->position, found->triangle}) : std::nullopt;
}

}  // namespace ocelli
