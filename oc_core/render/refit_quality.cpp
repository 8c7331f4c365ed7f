#include "oc_core/render/refit_quality.h"

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <utility>

#include "oc_core/base/parallel.h"

namespace ocelli {
namespace {

constexpr size_t kGroup = 16;
/// Groups that are looked at; of larger meshes evenly spaced ones.
constexpr size_t kMaxGroups = 1 << 12;

double areaOf(const Box& box) {
  const glm::dvec3 size(box.size());
  return size.x * size.y + size.y * size.z + size.z * size.x;
}

/// The bits of `value` with two zeros between neighbours; 10 bits.
uint32_t spread(uint32_t value) {
  value = (value | (value << 16)) & 0x030000ffu;
  value = (value | (value << 8)) & 0x0300f00fu;
  value = (value | (value << 4)) & 0x030c30c3u;
  return (value | (value << 2)) & 0x09249249u;
}

glm::vec3 centerOf(const Mesh& mesh, uint32_t triangle) {
  const glm::uvec3& t = mesh.triangles[triangle];
  return (mesh.positions[t.x] + mesh.positions[t.y] + mesh.positions[t.z]) / 3.0f;
}

}  // namespace

RefitQuality::RefitQuality(const Mesh& mesh) : mesh_(&mesh) {
  if (mesh.triangles.empty()) {
    return;
  }
  // Neighbours along a curve that fills space: Morton's.
  const Box box = boundsOf(mesh);
  const glm::vec3 perCell = 1023.0f / glm::max(box.size(), glm::vec3(1e-30f));
  std::vector<std::pair<uint32_t, uint32_t>> order(mesh.triangles.size());
  parallelFor(order.size(), 1 << 14, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const auto triangle = static_cast<uint32_t>(i);
      const glm::uvec3 cell((centerOf(mesh, triangle) - box.lower) * perCell);
      order[i] = {spread(cell.x) | spread(cell.y) << 1 | spread(cell.z) << 2, triangle};
    }
  });
  std::sort(order.begin(), order.end());
  const size_t groups = (order.size() + kGroup - 1) / kGroup;
  const size_t every = (groups + kMaxGroups - 1) / kMaxGroups;
  for (size_t group = 0; group < groups; group += every) {
    for (size_t i = group * kGroup; i < (group + 1) * kGroup; ++i) {
      // The last group is filled up with its last triangle.
      triangles_.push_back(order[std::min(i, order.size() - 1)].second);
    }
  }
  atBegin_ = meanShare();
}

double RefitQuality::meanShare() const {
  Box whole;
  double sum = 0;
  for (size_t first = 0; first < triangles_.size(); first += kGroup) {
    Box box;
    for (size_t i = first; i < first + kGroup; ++i) {
      const glm::uvec3& t = mesh_->triangles[triangles_[i]];
      box.add(mesh_->positions[t.x]);
      box.add(mesh_->positions[t.y]);
      box.add(mesh_->positions[t.z]);
    }
    sum += areaOf(box);
    whole.add(box.lower);
    whole.add(box.upper);
  }
  const double area = areaOf(whole);
  return area > 0 ? sum / area : 0;
}

double RefitQuality::ratio() const {
  return atBegin_ > 0 ? meanShare() / atBegin_ : 1;
}

}  // namespace ocelli
