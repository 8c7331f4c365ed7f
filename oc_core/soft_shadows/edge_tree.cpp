#include "oc_core/soft_shadows/edge_tree.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "oc_core/base/parallel.h"

namespace ocelli {
namespace {

/// Two zeros between its 21 lowest bits.
uint64_t spread(uint64_t x) {
  x &= 0x1fffff;
  x = (x | x << 32) & 0x1f00000000ffffu;
  x = (x | x << 16) & 0x1f0000ff0000ffu;
  x = (x | x << 8) & 0x100f00f00f00f00fu;
  x = (x | x << 4) & 0x10c30c30c30c30c3u;
  return (x | x << 2) & 0x1249249249249249u;
}

void sortAlongCurve(std::vector<OccluderEdge>& edges) {
  Box box;
  for (const OccluderEdge& edge : edges) {
    box.add(edge.a + edge.b);
  }
  const float size = std::max({box.size().x, box.size().y, box.size().z, 1e-20f});
  constexpr float kCells = 0x1fffff;
  std::vector<std::pair<uint64_t, uint32_t>> keys(edges.size());
  parallelFor(edges.size(), 1 << 14, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const glm::vec3 p = (edges[i].a + edges[i].b - box.lower) / size * kCells;
      keys[i] = {spread(static_cast<uint64_t>(p.x)) | spread(static_cast<uint64_t>(p.y)) << 1 |
                     spread(static_cast<uint64_t>(p.z)) << 2,
                 static_cast<uint32_t>(i)};
    }
  });
  std::sort(keys.begin(), keys.end());
  std::vector<OccluderEdge> sorted(edges.size());
  for (size_t i = 0; i < keys.size(); ++i) {
    sorted[i] = edges[keys[i].second];
  }
  edges = std::move(sorted);
}

void widen(glm::vec3& lower, glm::vec3& upper, const glm::vec3& l, const glm::vec3& u) {
  lower = glm::min(lower, l);
  upper = glm::max(upper, u);
}

}  // namespace

EdgeTree::EdgeTree(std::vector<OccluderEdge>& edges, const std::vector<glm::vec4>& planes)
    : edges_(edges), planes_(planes) {
  if (edges.empty()) {
    return;
  }
  sortAlongCurve(edges);
  const auto levelOf = [&](size_t count, size_t group, const auto& nodeOf) {
    std::vector<Node> nodes((count + group - 1) / group);
    parallelFor(nodes.size(), 256, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) {
        nodes[i] = nodeOf(i * group, std::min((i + 1) * group, count));
      }
    });
    levels_.push_back(std::move(nodes));
  };
  levelOf(edges.size(), kEdgesALeaf, [this](size_t first, size_t end) { return leafOf(first, end); });
  while (levels_.back().size() > 1) {
    const size_t below = levels_.size() - 1;
    levelOf(levels_.back().size(), kChildren,
            [this, below](size_t first, size_t end) { return over(below, first, end); });
  }
}

EdgeTree::Node EdgeTree::leafOf(size_t first, size_t end) const {
  Node node{edges_[first].a, edges_[first].a};
  glm::vec3 sum(0);
  bool isFolds = true;
  // A fold's two triangles face alike up to the sign with which they run along it.
  const auto normals = [&](const OccluderEdge& edge, const auto& visit) {
    visit(glm::vec3(planes_[edge.plane]));
    visit(glm::vec3(planes_[edge.other]) * static_cast<float>(-edge.otherSign));
  };
  for (size_t i = first; i < end; ++i) {
    widen(node.lower, node.upper, glm::min(edges_[i].a, edges_[i].b), glm::max(edges_[i].a, edges_[i].b));
    isFolds = isFolds && !edges_[i].isRim();
    if (isFolds) {
      normals(edges_[i], [&](const glm::vec3& n) { sum += glm::dot(sum, n) < 0 ? -n : n; });
    }
  }
  if (!isFolds || !(glm::length(sum) > 0)) {
    return node;
  }
  node.axis = glm::normalize(sum);
  float cosine = 1;
  for (size_t i = first; i < end; ++i) {
    // Both of a fold's normals must lie on the same side: otherwise it is an outline from nearly everywhere.
    float sign = 0;
    normals(edges_[i], [&](const glm::vec3& n) {
      const float own = glm::dot(node.axis, n);
      if (sign == 0) {
        sign = own < 0 ? -1.0f : 1.0f;
      }
      cosine = std::min(cosine, own * sign);
    });
  }
  if (cosine > 0) {
    node.cosine = std::min(cosine, 1.0f);
    node.sine = std::sqrt(1 - node.cosine * node.cosine);
  }
  return node;
}

EdgeTree::Node EdgeTree::over(size_t level, size_t first, size_t end) const {
  const std::vector<Node>& below = levels_[level];
  Node node{below[first].lower, below[first].upper};
  glm::vec3 sum(0);
  for (size_t i = first; i < end; ++i) {
    widen(node.lower, node.upper, below[i].lower, below[i].upper);
    sum += glm::dot(sum, below[i].axis) < 0 ? -below[i].axis : below[i].axis;
  }
  if (!(glm::length(sum) > 0)) {
    return node;
  }
  node.axis = glm::normalize(sum);
  double angle = 0;
  for (size_t i = first; i < end; ++i) {
    if (below[i].cosine <= 0) {
      return node;
    }
    angle =
        std::max(angle, std::acos(std::min(1.0, std::abs(static_cast<double>(glm::dot(node.axis, below[i].axis))))) +
                            std::acos(static_cast<double>(below[i].cosine)));
  }
  if (angle < 1.5) {
    node.cosine = static_cast<float>(std::cos(angle));
    node.sine = static_cast<float>(std::sin(angle));
  }
  return node;
}

/// Whether no way from a point of the node's box to one of the receivers' is within a right angle of any normal's
/// plane.
bool EdgeTree::isOneSided(const Node& node, const Box& receivers) {
  if (node.cosine <= 0) {
    return false;
  }
  const glm::vec3 middle = receivers.center() - (node.lower + node.upper) * 0.5f;
  const float radius = glm::length(receivers.size() + node.upper - node.lower) * 0.5f * 1.001f;
  const float along = glm::dot(middle, node.axis);
  const float across = std::sqrt(std::max(0.0f, glm::dot(middle, middle) - along * along));
  return (std::abs(along) - radius) * node.cosine > (across + radius) * node.sine * 1.001f;
}

uint64_t EdgeTree::find(const LightShaft& shaft, std::vector<const OccluderEdge*>& found) const {
  return levels_.empty() ? 0 : visit(levels_.size() - 1, 0, shaft, found);
}

uint64_t EdgeTree::visit(size_t level, size_t index, const LightShaft& shaft,
                         std::vector<const OccluderEdge*>& found) const {
  const Node& node = levels_[level][index];
  if (!shaft.meets(node.lower, node.upper) || isOneSided(node, shaft.receivers())) {
    return 1;
  }
  uint64_t looked = 1;
  if (level > 0) {
    const size_t end = std::min((index + 1) * kChildren, levels_[level - 1].size());
    for (size_t child = index * kChildren; child < end; ++child) {
      looked += visit(level - 1, child, shaft, found);
    }
    return looked;
  }
  const size_t end = std::min((index + 1) * kEdgesALeaf, edges_.size());
  for (size_t i = index * kEdgesALeaf; i < end; ++i) {
    const OccluderEdge& edge = edges_[i];
    ++looked;
    if (!shaft.meets(glm::min(edge.a, edge.b), glm::max(edge.a, edge.b))) {
      continue;
    }
    if (!edge.isRim()) {
      const int own = sideOfBox(planes_[edge.plane], shaft.receivers());
      const int other = sideOfBox(planes_[edge.other], shaft.receivers());
      if (own != 0 && other != 0 && own + other * edge.otherSign == 0) {
        continue;
      }
    }
    found.push_back(&edge);
  }
  return looked;
}

}  // namespace ocelli
