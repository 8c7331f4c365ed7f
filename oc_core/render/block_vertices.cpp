#include "oc_core/render/block_vertices.h"

namespace ocelli {

uint8_t BlockVertices::placeOf(const Mesh& mesh, uint32_t vertex) {
  Slot& slot = slots_[vertex % kSlots];
  const uint64_t tag = serial_ << 32 | vertex;
  if (slot.tag != tag) {
    const glm::vec3& p = mesh.positions[vertex];
    x_[count_] = p.x;
    y_[count_] = p.y;
    z_[count_] = p.z;
    slot = {tag, static_cast<uint8_t>(count_++)};
  }
  return slot.place;
}

void BlockVertices::collect(const Mesh& mesh, const MeshBlocks& blocks, uint32_t block) {
  ++serial_;
  count_ = 0;
  triangleCount_ = 0;
  blocks.forEachTriangle(block, [&](uint32_t triangle) {
    const glm::uvec3& t = mesh.triangles[triangle];
    Triangle& held = triangles_[triangleCount_++];
    held.index = triangle;
    held.corners = {placeOf(mesh, t.x), placeOf(mesh, t.y), placeOf(mesh, t.z)};
  });
}

}  // namespace ocelli
