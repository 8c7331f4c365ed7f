#include "oc_core/soft_shadows/outline_block.h"

#include <algorithm>

namespace ocelli {
namespace {

/// Edges are cut so far before the plane of the receiver that is parallel to the light, of its distance from the light:
/// there, projections go to infinity.
constexpr float kBeforeReceiver = 1e-5f;

}  // namespace

void OutlineBlock::Ends::clear() {
  x.clear();
  y.clear();
  z.clear();
}

void OutlineBlock::Ends::push(const glm::vec3& p) {
  x.push_back(p.x);
  y.push_back(p.y);
  z.push_back(p.z);
}

void OutlineBlock::take(const std::vector<const OccluderEdge*>& shared, const std::vector<glm::vec4>& planes,
                        const Box& receivers) {
  edges_ = shared;
  a_.clear();
  b_.clear();
  weight_.clear();
  isCut_.clear();
  const float cut = receivers.lower.z * (1 - 2 * kBeforeReceiver);
  for (const OccluderEdge* edge : edges_) {
    a_.push(edge->a);
    b_.push(edge->b);
    const int own = sideOfBox(planes[edge->plane], receivers);
    const int other = edge->isRim() ? 1 : sideOfBox(planes[edge->other], receivers);
    weight_.push_back(own == 0 || other == 0 ? kVaries : static_cast<int8_t>(own + other * edge->otherSign));
    isCut_.push_back(edge->a.z >= cut || edge->b.z >= cut ? 1 : 0);
  }
  for (std::vector<float>* projected : {&ax_, &ay_, &bx_, &by_}) {
    projected->resize(edges_.size());
  }
}

OutlineBlock::Projected OutlineBlock::project(const glm::vec3& receiver, const LightGrid& grid,
                                              const std::vector<glm::vec4>& planes, float shiftPerDistance,
                                              LightCover& cover) {
  const glm::vec2 scale = grid.scale();
  const glm::vec2 middle = glm::vec2(receiver) * scale + grid.offset();
  const auto projectAll = [&](const Ends& ends, std::vector<float>& px, std::vector<float>& py) {
    const size_t count = edges_.size();
    const float* x = ends.x.data();
    const float* y = ends.y.data();
    const float* z = ends.z.data();
    float* u = px.data();
    float* v = py.data();
    for (size_t i = 0; i < count; ++i) {
      const float enlarged = receiver.z / (receiver.z - z[i]);
      u[i] = middle.x + (x[i] - receiver.x) * enlarged * scale.x;
      v[i] = middle.y + (y[i] - receiver.y) * enlarged * scale.y;
    }
  };
  projectAll(a_, ax_, ay_);
  projectAll(b_, bx_, by_);
  const auto rows = static_cast<float>(grid.side());
  const float nearest = receiver.z * (1 - kBeforeReceiver);
  Projected projected;
  for (size_t i = 0; i < edges_.size(); ++i) {
    if (isCut_[i] != 0) {
      glm::vec3 a = edges_[i]->a;
      glm::vec3 b = edges_[i]->b;
      if (a.z >= nearest && b.z >= nearest) {
        continue;
      }
      if (a.z >= nearest) {
        a = b + (a - b) * ((nearest - b.z) / (a.z - b.z));
        a.z = nearest;
      } else if (b.z >= nearest) {
        b = a + (b - a) * ((nearest - a.z) / (b.z - a.z));
        b.z = nearest;
      }
      const float enlargedA = receiver.z / (receiver.z - a.z);
      const float enlargedB = receiver.z / (receiver.z - b.z);
      ax_[i] = middle.x + (a.x - receiver.x) * enlargedA * scale.x;
      ay_[i] = middle.y + (a.y - receiver.y) * enlargedA * scale.y;
      bx_[i] = middle.x + (b.x - receiver.x) * enlargedB * scale.x;
      by_[i] = middle.y + (b.y - receiver.y) * enlargedB * scale.y;
    }
    // What passes beside the light on one side of it changes nothing, or all of its samples alike.
    if (std::max(ax_[i], bx_[i]) < 0 || std::min(ax_[i], bx_[i]) >= rows || std::max(ay_[i], by_[i]) <= 0 ||
        std::min(ay_[i], by_[i]) > rows - 1) {
      continue;
    }
    const int weight = weight_[i] == kVaries ? weightOf(*edges_[i], planes, receiver) : weight_[i];
    if (weight == 0) {
      continue;
    }
    cover.add({ax_[i], ay_[i]}, {bx_[i], by_[i]}, weight);
    ++projected.edges;
    const float z = std::min(a_.z[i], nearest);
    projected.shift += std::min(1.0f, shiftPerDistance * z * receiver.z / (receiver.z - z));
  }
  return projected;
}

}  // namespace ocelli
