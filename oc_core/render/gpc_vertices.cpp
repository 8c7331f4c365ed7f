#include "oc_core/render/gpc_vertices.h"

#include <algorithm>
#include <memory>

#include "oc_core/base/parallel.h"
#include "oc_core/render/frustum_clip.h"

namespace ocelli {

GpcVertices::GpcVertices(std::span<const GpcRasterZone> zones, const ProjectedMesh& projected)
    : zones_(zones),
      lowest_(-kClipMargin),
      highest_(glm::vec2(projected.camera().width(), projected.camera().height()) + kClipMargin),
      vertices_(std::allocator<GpcVertex>().allocate(projected.vertices().size()), {projected.vertices().size()}) {
  const std::span<const ProjectedVertex> points = projected.vertices();
  const std::span<GpcVertex> placed(vertices_.get(), points.size());
  const size_t runs = (points.size() + GpcRun::kSize - 1) / GpcRun::kSize;
  parallelFor(runs, 32, [&](size_t firstRun, size_t lastRun) {
    for (size_t run = firstRun; run < lastRun; ++run) {
      const size_t first = run * GpcRun::kSize;
      const size_t count = std::min(GpcRun::kSize, points.size() - first);
      place(points.subspan(first, count), placed.subspan(first, count));
    }
  });
}

void GpcVertices::place(std::span<const ProjectedVertex> points, std::span<GpcVertex> placed) const {
  GpcRun run;
  constexpr float kFar = 1e30f;
  glm::vec2 lower(kFar);
  glm::vec2 upper(-kFar);
  for (size_t i = 0; i < points.size(); ++i) {
    const ProjectedVertex& q = points[i];
    const bool isKnown =
        (q.inverseZ > 0) & (q.u > lowest_.x) & (q.v > lowest_.y) & (q.u < highest_.x) & (q.v < highest_.y);
    run.u[i] = isKnown ? q.u : lowest_.x;
    run.v[i] = isKnown ? q.v : lowest_.y;
    lower.x = std::min(lower.x, isKnown ? q.u : kFar);
    lower.y = std::min(lower.y, isKnown ? q.v : kFar);
    upper.x = std::max(upper.x, isKnown ? q.u : -kFar);
    upper.y = std::max(upper.y, isKnown ? q.v : -kFar);
  }
  // How far the run is from the zones that it does not touch.
  float away = kFar;
  for (const GpcRasterZone& zone : zones_) {
    const ImageBox& box = zone.outerBox();
    const glm::vec2 gap = glm::max(glm::max(box.lower - upper, lower - box.upper), 0.0f);
    const float squared = gap.x * gap.x + gap.y * gap.y;
    away = squared > 0 ? std::min(away, squared) : away;
  }
  run.x = run.u;
  run.y = run.v;
  run.xx.fill(1 / away);
  run.yy = run.xx;
  run.xy.fill(0);
  run.part.fill(GpcRasterZone::kAround);
  for (const GpcRasterZone& zone : zones_) {
    const ImageBox& box = zone.outerBox();
    if (lower.x <= box.upper.x && lower.y <= box.upper.y && upper.x >= box.lower.x && upper.y >= box.lower.y) {
      zone.place(run);
    }
  }
  for (size_t i = 0; i < points.size(); ++i) {
    const bool isKnown = run.u[i] > lowest_.x && points[i].inverseZ > 0;
    std::construct_at(&placed[i],
                      GpcVertex{run.x[i], run.y[i], points[i].inverseZ,
                                isKnown ? CentreCell::at(run.x[i], run.y[i]) : CentreCell::unknown(), run.part[i],
                                isKnown ? GpcBend{run.xx[i], run.yy[i], run.xy[i]} : GpcBend{}});
  }
}

}  // namespace ocelli
