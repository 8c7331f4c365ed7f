#include "oc_core/render/triangle_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>

#include "oc_core/base/parallel.h"
#include "oc_core/render/triangle_point.h"

namespace ocelli {
namespace {

constexpr uint32_t kLeafTriangles = 4;
constexpr size_t kNodesPerRange = 1 << 13;
constexpr size_t kMaxDepth = 64;  ///< nodes that wait: halves of 2^32 triangles, and some

/// Where the way enters a box, as a share of `step`; nothing where it misses it before `reach`.
std::optional<double> entry(const Box& box, const glm::dvec3& origin, const glm::dvec3& perStep, double reach) {
  double from = 0;
  double to = reach;
  for (int axis = 0; axis < 3; ++axis) {
    if (!std::isfinite(perStep[axis])) {  // the way runs along this side
      if (origin[axis] < static_cast<double>(box.lower[axis]) || origin[axis] > static_cast<double>(box.upper[axis])) {
        return std::nullopt;
      }
      continue;
    }
    const double a = (static_cast<double>(box.lower[axis]) - origin[axis]) * perStep[axis];
    const double b = (static_cast<double>(box.upper[axis]) - origin[axis]) * perStep[axis];
    from = std::max(from, std::min(a, b));
    to = std::min(to, std::max(a, b));
  }
  constexpr double kShareRounding = 1e-12;
  return from <= to + kShareRounding * std::abs(to) ? std::optional(from) : std::nullopt;
}

float distanceTo(const Box& box, const glm::vec3& point) {
  return glm::distance(point, glm::clamp(point, box.lower, box.upper));
}

}  // namespace

TriangleTree::TriangleTree(const Mesh& mesh) : mesh_(mesh), order_(mesh.triangles.size()) {
  std::iota(order_.begin(), order_.end(), 0u);
  std::vector<glm::vec3> centers;
  centers.reserve(order_.size());
  for (const glm::uvec3& t : mesh.triangles) {
    centers.push_back((mesh.positions[t.x] + mesh.positions[t.y] + mesh.positions[t.z]) / 3.0f);
  }
  if (!order_.empty()) {
    nodes_.reserve(order_.size());
    build(centers, 0, static_cast<uint32_t>(order_.size()));
  }
}

void TriangleTree::build(std::vector<glm::vec3>& centers, uint32_t begin, uint32_t end) {
  const size_t index = nodes_.size();
  nodes_.emplace_back();
  Box box;
  Box middles;
  for (uint32_t i = begin; i < end; ++i) {
    const glm::uvec3& t = mesh_.triangles[order_[i]];
    for (int corner = 0; corner < 3; ++corner) {
      box.add(mesh_.positions[t[corner]]);
    }
    middles.add(centers[order_[i]]);
  }
  nodes_[index].box = box;
  if (end - begin <= kLeafTriangles) {
    nodes_[index].begin = begin;
    nodes_[index].count = end - begin;
    return;
  }
  const glm::vec3 size = middles.size();
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const uint32_t middle = begin + (end - begin) / 2;
  std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end, [&](uint32_t a, uint32_t b) {
    return std::pair(centers[a][axis], a) < std::pair(centers[b][axis], b);
  });
  build(centers, begin, middle);
  nodes_[index].second = static_cast<uint32_t>(nodes_.size());
  build(centers, middle, end);
}

void TriangleTree::refit() {
  parallelFor(nodes_.size(), kNodesPerRange, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      Node& node = nodes_[i];
      node.box = Box{};
      for (uint32_t k = node.begin; k < node.begin + node.count; ++k) {
        const glm::uvec3& t = mesh_.triangles[order_[k]];
        for (int corner = 0; corner < 3; ++corner) {
          node.box.add(mesh_.positions[t[corner]]);
        }
      }
    }
  });
  // Children stand behind their parents.
  for (size_t i = nodes_.size(); i-- > 0;) {
    if (nodes_[i].count == 0) {
      for (const Box& box : {nodes_[i + 1].box, nodes_[nodes_[i].second].box}) {
        nodes_[i].box.lower = glm::min(nodes_[i].box.lower, box.lower);
        nodes_[i].box.upper = glm::max(nodes_[i].box.upper, box.upper);
      }
    }
  }
}

std::optional<TriangleTree::Meeting> TriangleTree::meet(const glm::vec3& from, const glm::vec3& way,
                                                        double reach) const {
  const glm::dvec3 origin(from);
  const glm::dvec3 step(way);
  const glm::dvec3 perStep = 1.0 / step;
  std::optional<Meeting> best;
  const auto meetTriangle = [&](uint32_t triangle) {
    const glm::uvec3& t = mesh_.triangles[triangle];
    const glm::dvec3 a = glm::dvec3(mesh_.positions[t.x]) - origin;
    const glm::dvec3 b = glm::dvec3(mesh_.positions[t.y]) - origin;
    const glm::dvec3 c = glm::dvec3(mesh_.positions[t.z]) - origin;
    const double wa = glm::dot(step, glm::cross(b, c));
    const double wb = glm::dot(step, glm::cross(c, a));
    const double wc = glm::dot(step, glm::cross(a, b));
    const double sum = wa + wb + wc;
    const bool inside = (wa >= 0 && wb >= 0 && wc >= 0) || (wa <= 0 && wb <= 0 && wc <= 0);
    if (!inside || sum == 0) {
      return;
    }
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    const double share = glm::dot(normal, a) / glm::dot(normal, step);
    if (share >= 0 && share <= reach &&
        (!best || std::pair(share, triangle) < std::pair(best->share, best->triangle))) {
      best = Meeting{triangle, share, static_cast<float>(wb / sum), static_cast<float>(wc / sum)};
      reach = share;
    }
  };
  std::array<uint32_t, kMaxDepth> waiting;
  size_t count = 0;
  if (!nodes_.empty()) {
    waiting[count++] = 0;
  }
  while (count > 0) {
    const uint32_t index = waiting[--count];
    const Node& node = nodes_[index];
    if (!entry(node.box, origin, perStep, reach)) {
      continue;
    }
    if (node.count > 0) {
      for (uint32_t i = node.begin; i < node.begin + node.count; ++i) {
        meetTriangle(order_[i]);
      }
      continue;
    }
    const std::optional<double> first = entry(nodes_[index + 1].box, origin, perStep, reach);
    const std::optional<double> second = entry(nodes_[node.second].box, origin, perStep, reach);
    // The nearer one is visited first.
    const bool firstIsNearer = first && (!second || *first <= *second);
    if (firstIsNearer ? second.has_value() : first.has_value()) {
      waiting[count++] = firstIsNearer ? node.second : index + 1;
    }
    if (first || second) {
      waiting[count++] = firstIsNearer ? index + 1 : node.second;
    }
  }
  return best;
}

std::optional<TriangleTree::Nearest> TriangleTree::nearest(const glm::vec3& point, float reach) const {
  std::optional<Nearest> best;
  std::array<uint32_t, kMaxDepth> waiting;
  size_t count = 0;
  if (!nodes_.empty()) {
    waiting[count++] = 0;
  }
  while (count > 0) {
    const uint32_t index = waiting[--count];
    const Node& node = nodes_[index];
    constexpr float kBoxRounding = 1 + 1e-5f;
    if (!(distanceTo(node.box, point) <= reach * kBoxRounding)) {
      continue;
    }
    if (node.count == 0) {
      const bool firstIsNearer = distanceTo(nodes_[index + 1].box, point) <= distanceTo(nodes_[node.second].box, point);
      waiting[count++] = firstIsNearer ? node.second : index + 1;
      waiting[count++] = firstIsNearer ? index + 1 : node.second;
      continue;
    }
    for (uint32_t i = node.begin; i < node.begin + node.count; ++i) {
      const glm::uvec3& t = mesh_.triangles[order_[i]];
      const glm::vec3 closest = closestPoint(point, mesh_.positions[t.x], mesh_.positions[t.y], mesh_.positions[t.z]);
      const float distance = glm::distance(closest, point);
      if (distance <= reach && (!best || distance < reach || order_[i] < best->triangle)) {
        best = Nearest{order_[i], closest};
        reach = distance;
      }
    }
  }
  return best;
}

}  // namespace ocelli
