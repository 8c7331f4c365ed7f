#include "oc_core/render/block_vertices.h"

namespace ocelli {

void BlockVertices::collect(const Mesh& mesh, const MeshBlocks& blocks, uint32_t block) {
  ++serial_;
  size_t count = 0;
  size_t triangles = 0;
  // Whether a vertex is there already cannot be foreseen, so nothing branches on it: what is written behind the last
  // one is written over.
  const auto placeOf = [&](uint32_t vertex) {
    Slot& slot = slots_[vertex % kSlots];
    const uint64_t tag = serial_ << 32 | vertex;
    const bool isNew = slot.tag != tag;
    const glm::vec3& p = mesh.positions[vertex];
    x_[count] = p.x;
    y_[count] = p.y;
    z_[count] = p.z;
    slot.place = isNew ? static_cast<uint8_t>(count) : slot.place;
    slot.tag = tag;
    count += isNew ? 1 : 0;
    return slot.place;
  };
  blocks.forEachTriangle(block, [&](uint32_t triangle) {
    const glm::uvec3& t = mesh.triangles[triangle];
    triangles_[triangles++] = {triangle, {placeOf(t.x), placeOf(t.y), placeOf(t.z)}};
  });
  count_ = count;
  triangleCount_ = triangles;
}

}  // namespace ocelli
