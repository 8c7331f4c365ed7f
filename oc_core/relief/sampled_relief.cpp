#include "oc_core/relief/sampled_relief.h"

#include <algorithm>
#include <glm/common.hpp>

#include "oc_core/base/parallel.h"

namespace ocelli {
namespace {

/// A block looks at all cells that its rays run through. Where these are many more than rays, they go on alone.
constexpr float kWideTexels = 1.8f;

}  // namespace

SampledRelief::SampledRelief(const ReferenceImages& images, const SurfaceLabels& labels)
    : cells_(sampleCells(images)), pyramid_(cells_), surfaceOfVertex_(cells_.mesh.positions.size()) {
  if (!labels.mesh().empty()) {
    parallelFor(surfaceOfVertex_.size(), 1 << 14, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) {
        surfaceOfVertex_[i] = labels.surfaceOf(cells_.mesh.color(static_cast<uint32_t>(i)));
      }
    });
  }
  for (const ReferenceImage& image : images) {
    texels_ += image.t.size();
    samples_ += image.sampleCount();
  }
  if (!images.empty()) {
    const PinholeCamera reference = images[0].reference();
    const View& view = reference.view();
    texelSize_ = glm::distance(view.eye, view.target) / reference.focalPixels();
  }
}

std::optional<TriangleMeeting> SampledRelief::meet(const StraightRay& ray, RayCost& cost) const {
  return pyramid_.meet(ray, cost);
}

std::optional<TriangleMeeting> SampledRelief::meetSlowly(const StraightRay& ray) const {
  return meetEveryCell(cells_, ray);
}

void SampledRelief::meetBlock(RayBlock& block, RayCost& cost) const {
  if (block.rays() == 1) {
    ReliefObject::meetBlock(block, cost);
  } else if (raySpacingAt(block) < kWideTexels * texelSize_) {
    pyramid_.meetBlock(block, cost);
  } else {
    pyramid_.meetWideBlock(block, cost);
  }
}

/// At the nearest point of the object, about.
float SampledRelief::raySpacingAt(const RayBlock& block) const {
  const Box box = pyramid_.bounds();
  const glm::vec3 way = glm::max(glm::max(box.lower - block.origin, block.origin - box.upper), glm::vec3(0));
  const float stepLength = glm::length(block.first);
  return std::max(glm::length(block.perColumn), glm::length(block.perRow)) * glm::length(way) / stepLength;
}

ReliefSurface SampledRelief::surfaceAt(const TriangleMeeting& meeting) const {
  const glm::uvec3& t = cells_.mesh.triangles[meeting.triangle];
  const float b0 = 1 - meeting.b1 - meeting.b2;
  const ReliefSurface& p = surfaceOfVertex_[t.x];
  const ReliefSurface& q = surfaceOfVertex_[t.y];
  const ReliefSurface& r = surfaceOfVertex_[t.z];
  return {p.color * b0 + q.color * meeting.b1 + r.color * meeting.b2,
          p.normal * b0 + q.normal * meeting.b1 + r.normal * meeting.b2};
}

}  // namespace ocelli
