#include "oc_core/pack/cluster_groups.h"

#include <algorithm>
#include <glm/common.hpp>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

#include "oc_core/pack/place_bits.h"
#include "oc_core/scene/box.h"

namespace ocelli {
namespace {

/// Bits of a 21-bit number, with two zeros after each.
uint64_t spread(uint64_t x) {
  x = (x | x << 32U) & 0x1f00000000ffffU;
  x = (x | x << 16U) & 0x1f0000ff0000ffU;
  x = (x | x << 8U) & 0x100f00f00f00f00fU;
  x = (x | x << 4U) & 0x10c30c30c30c30c3U;
  return (x | x << 2U) & 0x1249249249249249U;
}

struct Neighbor {
  uint32_t cluster;
  uint32_t shared;  ///< vertices
};

/// The neighbours of each cluster, in their order.
std::vector<std::vector<Neighbor>> neighborsOf(std::span<const Cluster* const> clusters) {
  struct Place {
    PlaceBits bits;
    uint32_t cluster = 0;

    auto operator<=>(const Place&) const = default;
  };
  std::vector<Place> places;
  for (uint32_t i = 0; i < clusters.size(); ++i) {
    for (const glm::vec3& p : clusters[i]->positions) {
      places.push_back({placeBits(p), i});
    }
  }
  std::sort(places.begin(), places.end());
  std::vector<uint64_t> pairs;
  for (size_t begin = 0; begin < places.size();) {
    size_t end = begin;
    while (end < places.size() && places[end].bits == places[begin].bits) {
      ++end;
    }
    // A point at which very many clusters meet joins only those that follow each other.
    constexpr size_t kMaxMeeting = 16;
    for (size_t i = begin; i < end; ++i) {
      for (size_t k = i + 1; k < std::min(end, i + kMaxMeeting); ++k) {
        if (places[i].cluster != places[k].cluster) {
          pairs.push_back(uint64_t{places[i].cluster} << 32U | places[k].cluster);
          pairs.push_back(uint64_t{places[k].cluster} << 32U | places[i].cluster);
        }
      }
    }
    begin = end;
  }
  std::sort(pairs.begin(), pairs.end());
  std::vector<std::vector<Neighbor>> neighbors(clusters.size());
  for (size_t begin = 0; begin < pairs.size();) {
    size_t end = begin;
    while (end < pairs.size() && pairs[end] == pairs[begin]) {
      ++end;
    }
    neighbors[pairs[begin] >> 32U].push_back({static_cast<uint32_t>(pairs[begin]), static_cast<uint32_t>(end - begin)});
    begin = end;
  }
  return neighbors;
}

/// Grows a group around a cluster: always by the neighbour that shares the most vertices with it.
class GroupGrower {
 public:
  explicit GroupGrower(const std::vector<std::vector<Neighbor>>& neighbors)
      : neighbors_(neighbors), isTaken_(neighbors_.size(), 0) {}

  bool isTaken(uint32_t cluster) const { return isTaken_[cluster] != 0; }

  std::vector<uint32_t> grow(uint32_t first) {
    std::vector<uint32_t> group;
    std::vector<Neighbor> around;
    add(first, group, around);
    while (group.size() < kClustersOfGroup && !around.empty()) {
      const auto best = std::max_element(around.begin(), around.end(), [](const Neighbor& a, const Neighbor& b) {
        return a.shared != b.shared ? a.shared < b.shared : a.cluster > b.cluster;
      });
      const uint32_t next = best->cluster;
      add(next, group, around);
    }
    return group;
  }

 private:
  void add(uint32_t cluster, std::vector<uint32_t>& group, std::vector<Neighbor>& around) {
    group.push_back(cluster);
    isTaken_[cluster] = 1;
    std::erase_if(around, [&](const Neighbor& n) { return n.cluster == cluster; });
    for (const Neighbor& n : neighbors_[cluster]) {
      if (isTaken_[n.cluster] != 0) {
        continue;
      }
      const auto known =
          std::find_if(around.begin(), around.end(), [&](const Neighbor& other) { return other.cluster == n.cluster; });
      if (known != around.end()) {
        known->shared += n.shared;
      } else {
        around.push_back(n);
      }
    }
  }

  const std::vector<std::vector<Neighbor>>& neighbors_;
  std::vector<uint8_t> isTaken_;
};

/// Adds small groups to the neighbouring one with which they share the most vertices, and those without any to what
/// comes next to them in space.
class SmallGroups {
 public:
  SmallGroups(const std::vector<std::vector<Neighbor>>& neighbors, std::vector<std::vector<uint32_t>> groups)
      : neighbors_(neighbors), groups_(std::move(groups)), groupOf_(neighbors.size()) {
    for (uint32_t g = 0; g < groups_.size(); ++g) {
      for (const uint32_t cluster : groups_[g]) {
        groupOf_[cluster] = g;
      }
    }
  }

  std::vector<std::vector<uint32_t>> joined() {
    for (uint32_t g = 0; g < groups_.size(); ++g) {
      if (groups_[g].size() <= kSmall) {
        if (const std::optional<uint32_t> other = closestGroup(g)) {
          move(g, *other);
        }
      }
    }
    std::vector<std::vector<uint32_t>> all;
    std::vector<uint32_t> alone;
    const auto flush = [&] {
      if (!alone.empty()) {
        all.push_back(std::exchange(alone, {}));
      }
    };
    for (std::vector<uint32_t>& group : groups_) {
      if (group.size() > kSmall) {
        all.push_back(std::move(group));
      } else {
        if (alone.size() + group.size() > kClustersOfGroup) {
          flush();
        }
        alone.insert(alone.end(), group.begin(), group.end());
      }
    }
    flush();
    return all;
  }

 private:
  static constexpr size_t kSmall = kClustersOfGroup / 3;

  std::optional<uint32_t> closestGroup(uint32_t group) const {
    std::map<uint32_t, uint32_t> shared;
    for (const uint32_t cluster : groups_[group]) {
      for (const Neighbor& n : neighbors_[cluster]) {
        const uint32_t other = groupOf_[n.cluster];
        if (other != group && groups_[other].size() + groups_[group].size() <= kMaxClustersOfGroup) {
          shared[other] += n.shared;
        }
      }
    }
    std::optional<uint32_t> best;
    for (const auto& [other, count] : shared) {
      if (!best || count > shared[*best]) {
        best = other;
      }
    }
    return best;
  }

  void move(uint32_t from, uint32_t to) {
    for (const uint32_t cluster : groups_[from]) {
      groupOf_[cluster] = to;
    }
    groups_[to].insert(groups_[to].end(), groups_[from].begin(), groups_[from].end());
    groups_[from].clear();
  }

  const std::vector<std::vector<Neighbor>>& neighbors_;
  std::vector<std::vector<uint32_t>> groups_;
  std::vector<uint32_t> groupOf_;
};

}  // namespace

std::vector<uint32_t> spatialOrder(std::span<const Sphere> spheres) {
  Box box;
  for (const Sphere& sphere : spheres) {
    box.add(sphere.center);
  }
  const glm::dvec3 size = glm::max(glm::dvec3(box.size()), 1e-30);
  const double scale = ((1 << 21) - 1) / std::max({size.x, size.y, size.z});
  std::vector<uint64_t> codes(spheres.size());
  for (size_t i = 0; i < spheres.size(); ++i) {
    const glm::dvec3 p = (glm::dvec3(spheres[i].center) - glm::dvec3(box.lower)) * scale;
    codes[i] = spread(static_cast<uint64_t>(p.x)) | spread(static_cast<uint64_t>(p.y)) << 1U |
               spread(static_cast<uint64_t>(p.z)) << 2U;
  }
  std::vector<uint32_t> order(spheres.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(),
            [&](uint32_t a, uint32_t b) { return codes[a] != codes[b] ? codes[a] < codes[b] : a < b; });
  return order;
}

std::vector<std::vector<uint32_t>> groupsOf(std::span<const Cluster* const> clusters) {
  std::vector<Sphere> spheres;
  spheres.reserve(clusters.size());
  for (const Cluster* cluster : clusters) {
    spheres.push_back(cluster->bounds());
  }
  const std::vector<std::vector<Neighbor>> neighbors = neighborsOf(clusters);
  GroupGrower grower(neighbors);
  std::vector<std::vector<uint32_t>> groups;
  for (const uint32_t first : spatialOrder(spheres)) {
    if (!grower.isTaken(first)) {
      groups.push_back(grower.grow(first));
    }
  }
  return SmallGroups(neighbors, std::move(groups)).joined();
}

}  // namespace ocelli
