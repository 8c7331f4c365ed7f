#include "oc_core/antialiasing/block_triangles.h"

namespace ocelli {

void BlockTriangles::start(const glm::ivec2& base) {
  base_ = base;
  kept_.clear();
  prepared_.clear();
}

void BlockTriangles::prepare(Kept& kept) {
  prepared_.reserve(kept_.size());
  const auto place = static_cast<uint32_t>(prepared_.size());
  AntialiasTriangle& t = prepared_.emplace_back();
  if (prepareTriangle(t, kept.triangle, kept.corners[0], kept.corners[1], kept.corners[2], base_)) {
    kept.prepared = place;
  } else {
    prepared_.pop_back();
    kept.prepared = kNone;
  }
}

}  // namespace ocelli
