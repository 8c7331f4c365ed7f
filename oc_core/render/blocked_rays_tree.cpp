// BlockedRays without Embree: slower, with the same results but for rounding.
#include "oc_core/base/check.h"
#include "oc_core/render/blocked_rays.h"
#include "oc_core/render/ray_segment.h"
#include "oc_core/render/triangle_tree.h"

namespace ocelli {

struct BlockedRays::Impl {
  explicit Impl(const Mesh& mesh) : tree(mesh) {}
  TriangleTree tree;
};

BlockedRays::BlockedRays(const Mesh& mesh, bool /*fast*/) : impl_(std::make_unique<Impl>(mesh)) {}
BlockedRays::~BlockedRays() = default;

void BlockedRays::find(std::span<const SightLine> lines, std::span<uint8_t> blocked) const {
  OC_CHECK(lines.size() == blocked.size(), "one entry a line");
  for (size_t i = 0; i < lines.size(); ++i) {
    const glm::vec3 step = lines[i].to - lines[i].from;
    blocked[i] = castable(lines[i].from, step) && impl_->tree.meet(lines[i].from, step, 1) ? 1 : 0;
  }
}

}  // namespace ocelli
