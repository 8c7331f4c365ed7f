// Which clusters are simplified together: neighbours, so that the borders that stay as they are run around as much
// surface as can be.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "oc_core/pack/cluster.h"

namespace ocelli {

inline constexpr size_t kClustersOfGroup = 12;
inline constexpr size_t kMaxClustersOfGroup = 18;

/// Each cluster is in one group, of about kClustersOfGroup and at most kMaxClustersOfGroup. Neighbours are clusters
/// that share vertices; those without any are joined with what lies near. Depends on nothing but the clusters.
std::vector<std::vector<uint32_t>> groupsOf(std::span<const Cluster* const> clusters);

/// The clusters in an order in which neighbours in space stand together (Morton's).
std::vector<uint32_t> spatialOrder(std::span<const Sphere> spheres);

}  // namespace ocelli
