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
  cut_.clear();
  const float cut = receivers.lower.z * (1 - 2 * kBeforeReceiver);
  for (const OccluderEdge* edge : edges_) {
    a_.push(edge->a);
    b_.push(edge->b);
    const int own = sideOfBox(planes[edge->plane], receivers);
    const int other = edge->isRim() ? 1 : sideOfBox(planes[edge->other], receivers);
    weight_.push_back(own == 0 || other == 0 ? kVaries : static_cast<int8_t>(own + other * edge->otherSign));
    if (edge->a.z >= cut || edge->b.z >= cut) {
      cut_.push_back(static_cast<uint32_t>(weight_.size() - 1));
    }
  }
  for (std::vector<float>* projected : {&ax_, &ay_, &bx_, &by_}) {
    projected->resize(edges_.size());
  }
  isOver_.resize(edges_.size());
  over_.resize(edges_.size());
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
  const float nearest = receiver.z * (1 - kBeforeReceiver);
  for (const uint32_t i : cut_) {
    projectCut(i, receiver, middle, scale, nearest);
  }
  Projected projected;
  const size_t over = overLight(static_cast<float>(grid.side()));
  for (size_t each = 0; each < over; ++each) {
    const uint32_t i = over_[each];
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

/// An edge that may reach behind the plane of the receiver, cut before it; beside the light where all of it is behind.
void OutlineBlock::projectCut(uint32_t i, const glm::vec3& receiver, const glm::vec2& middle, const glm::vec2& scale,
                              float nearest) {
  glm::vec3 a = edges_[i]->a;
  glm::vec3 b = edges_[i]->b;
  if (a.z >= nearest && b.z >= nearest) {
    ax_[i] = bx_[i] = ay_[i] = by_[i] = -1;
    return;
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

/// Writes the numbers of the edges that come over the light to over_, and returns how many. What passes beside the
/// light on one side of it changes nothing, or all of its samples alike. Without branches: which edges do is as good as
/// random.
size_t OutlineBlock::overLight(float rows) {
  const size_t count = edges_.size();
  const float* ax = ax_.data();
  const float* ay = ay_.data();
  const float* bx = bx_.data();
  const float* by = by_.data();
  int32_t* isOver = isOver_.data();
  for (size_t i = 0; i < count; ++i) {
    const float left = ax[i] < bx[i] ? ax[i] : bx[i];
    const float right = ax[i] < bx[i] ? bx[i] : ax[i];
    const float low = ay[i] < by[i] ? ay[i] : by[i];
    const float high = ay[i] < by[i] ? by[i] : ay[i];
    isOver[i] = static_cast<int32_t>(right >= 0) & static_cast<int32_t>(left < rows) & static_cast<int32_t>(high > 0) &
                static_cast<int32_t>(low <= rows - 1);
  }
  uint32_t* over = over_.data();
  size_t found = 0;
  for (size_t i = 0; i < count; ++i) {
    over[found] = static_cast<uint32_t>(i);
    found += static_cast<size_t>(isOver[i]);
  }
  return found;
}

}  // namespace ocelli
