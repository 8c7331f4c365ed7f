#include "oc_core/sea/sea_tree.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <limits>
#include <queue>
#include <set>
#include <tuple>

#include "oc_core/base/check.h"
#include "oc_core/sea/sea_graph.h"

namespace ocelli {
namespace {

/// The shortest first; of equally long ones the lowest numbers.
struct WaitingEdge {
  double length = 0;
  uint32_t a = 0;
  uint32_t b = 0;

  bool operator>(const WaitingEdge& other) const {
    return std::tie(length, a, b) > std::tie(other.length, other.a, other.b);
  }
};

class Collapse {
 public:
  explicit Collapse(std::span<const glm::dvec3> positions)
      : positions_(positions),
        neighbors_(positions.size()),
        images_(positions.size(), 1),
        height_(positions.size(), 0),
        parent_(positions.size(), SeaNode::kNone),
        isGone_(positions.size(), false),
        isInner_(positions.size(), false) {
    const std::vector<glm::dvec2> plane = planePositions(positions);
    for (const auto& [a, b] : delaunayEdges(plane)) {
      connect(a, b);
    }
  }

  /// Until one image stands for all. No tree below an I-node gets more levels than that.
  void run(int spacing) {
    while (!queue_.empty()) {
      const WaitingEdge edge = queue_.top();
      queue_.pop();
      if (!isGone_[edge.a] && !isGone_[edge.b]) {
        collapse(edge.a, edge.b, spacing);
      }
    }
  }

  const std::vector<uint32_t>& parents() const { return parent_; }
  /// Whether it is an I-node, the root of all included.
  bool isInner(uint32_t image) const { return isInner_[image] || parent_[image] == SeaNode::kNone; }

 private:
  void connect(uint32_t a, uint32_t b) {
    if (neighbors_[a].insert(b).second) {
      neighbors_[b].insert(a);
      queue_.push({glm::distance(positions_[a], positions_[b]), std::min(a, b), std::max(a, b)});
    }
  }

  /// The one with more images below it stays: of equal ones the first.
  void collapse(uint32_t a, uint32_t b, int spacing) {
    const bool staysFirst = std::tie(height_[a], images_[a]) >= std::tie(height_[b], images_[b]);
    const uint32_t stays = staysFirst ? a : b;
    const uint32_t goes = staysFirst ? b : a;
    parent_[goes] = stays;
    isGone_[goes] = true;
    const int height = std::max(height_[stays], height_[goes] + 1);
    if (height > spacing) {
      isInner_[goes] = true;
    } else {
      height_[stays] = height;
      images_[stays] += images_[goes];
    }
    for (const uint32_t neighbor : neighbors_[goes]) {
      neighbors_[neighbor].erase(goes);
      if (neighbor != stays) {
        connect(stays, neighbor);
      }
    }
    neighbors_[goes].clear();
  }

  std::span<const glm::dvec3> positions_;
  std::vector<std::set<uint32_t>> neighbors_;
  std::vector<uint32_t> images_;  ///< that it stands for, as I-node
  std::vector<int> height_;       ///< levels below it, down to leaves, that are no I-nodes
  std::vector<uint32_t> parent_;
  std::vector<bool> isGone_;
  std::vector<bool> isInner_;
  std::priority_queue<WaitingEdge, std::vector<WaitingEdge>, std::greater<>> queue_;
};

/// The nearest I-node from `image` up the tree.
uint32_t innerAbove(const Collapse& collapse, uint32_t image) {
  while (!collapse.isInner(image)) {
    image = collapse.parents()[image];
  }
  return image;
}

void orderNodes(SeaTree& tree) {
  std::vector<std::vector<uint32_t>> below(tree.nodes.size());
  std::vector<uint32_t> waiting;
  for (uint32_t i = static_cast<uint32_t>(tree.nodes.size()); i-- > 0;) {
    const uint32_t reference = tree.nodes[i].reference;
    (reference == SeaNode::kNone ? waiting : below[reference]).push_back(i);
  }
  // Down each branch to its end before the next one: few images are needed at a time.
  while (!waiting.empty()) {
    const uint32_t image = waiting.back();
    waiting.pop_back();
    tree.order.push_back(image);
    for (const uint32_t next : below[image]) {
      tree.nodes[next].additions = tree.nodes[image].additions + 1;
      waiting.push_back(next);
    }
  }
  OC_CHECK(tree.order.size() == tree.nodes.size(), "every image hangs on an I-node");
}

constexpr std::array kSeaWays{SeaWay::kRoot, SeaWay::kIndirect, SeaWay::kDirect};

}  // namespace

std::string_view nameOf(SeaWay way) {
  constexpr std::array<std::string_view, kSeaWays.size()> kNames{"root", "indirect", "direct"};
  return kNames[static_cast<size_t>(way)];
}

std::span<const SeaWay> allSeaWays() {
  return kSeaWays;
}

SeaTree makeSeaTree(std::span<const glm::dvec3> positions, SeaWay way, int spacing) {
  OC_CHECK(!positions.empty() && spacing >= 0, "a sea has images");
  Collapse collapse(positions);
  collapse.run(way == SeaWay::kRoot ? std::numeric_limits<int>::max() : spacing);
  SeaTree tree;
  tree.nodes.resize(positions.size());
  for (uint32_t i = 0; i < positions.size(); ++i) {
    SeaNode& node = tree.nodes[i];
    node.parent = collapse.parents()[i];
    if (!collapse.isInner(i)) {
      node.reference = way == SeaWay::kDirect ? innerAbove(collapse, i) : node.parent;
    }
  }
  orderNodes(tree);
  return tree;
}

}  // namespace ocelli
