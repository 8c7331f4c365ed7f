#include "oc_core/pack/hierarchy.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

#include "oc_core/base/parallel.h"
#include "oc_core/pack/cluster_groups.h"
#include "oc_core/pack/simplify_group.h"

namespace ocelli {
namespace {

/// What simplifying a group gave.
struct Step {
  std::vector<Cluster> coarser;  ///< none where the group stays
  Sphere sphere;
  LevelError error;
};

Step stepOf(const std::vector<LevelCluster>& clusters, const std::vector<uint32_t>& group, const PlaceSet& shared) {
  Step step;
  Welder welder(group.size() * Cluster::kMaxVertices);
  for (const uint32_t i : group) {
    welder.add(clusters[i].cluster);
    step.sphere = around(step.sphere, around(clusters[i].finerSphere, clusters[i].cluster.bounds()));
    step.error = largest(step.error, clusters[i].error);
  }
  const WeldedTriangles welded = welder.take();
  if (std::optional<SimplifiedTriangles> coarse = simplified(welded, shared)) {
    step.coarser = clustersOf(coarse->triangles);
    step.error = {step.error.distance + coarse->error.distance, std::max(step.error.color, coarse->error.color)};
  }
  return step;
}

/// The places that more than one group has, and those of `fixed`.
PlaceSet sharedPlaces(const std::vector<LevelCluster>& clusters, const std::vector<std::vector<uint32_t>>& groups,
                      const PlaceSet& fixed) {
  std::vector<std::pair<PlaceBits, uint32_t>> places;
  for (uint32_t g = 0; g < groups.size(); ++g) {
    for (const uint32_t i : groups[g]) {
      for (const glm::vec3& p : clusters[i].cluster.positions) {
        places.emplace_back(placeBits(p), g);
      }
    }
  }
  std::sort(places.begin(), places.end());
  std::vector<PlaceBits> shared(fixed.places().begin(), fixed.places().end());
  for (size_t i = 0; i + 1 < places.size(); ++i) {
    if (places[i].first == places[i + 1].first && places[i].second != places[i + 1].second) {
      shared.push_back(places[i].first);
    }
  }
  return PlaceSet(std::move(shared));
}

/// Leaves groups as they are whose error is far above those of others: in the next step, with other neighbours, they
/// may do better. Returns how many.
size_t leaveForLater(std::vector<Step>& steps) {
  constexpr float kFarAbove = 1.5f;  // of the median: about two groups of three go on
  std::vector<float> errors;
  for (const Step& step : steps) {
    if (!step.coarser.empty()) {
      errors.push_back(step.error.larger());
    }
  }
  if (errors.empty()) {
    return 0;
  }
  const auto median = errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2);
  std::nth_element(errors.begin(), median, errors.end());
  size_t left = 0;
  for (Step& step : steps) {
    if (!step.coarser.empty() && step.error.larger() > kFarAbove * *median) {
      step.coarser.clear();
      ++left;
    }
  }
  return left;
}

}  // namespace

std::vector<LevelCluster> levelClusters(std::vector<Cluster> clusters) {
  std::vector<LevelCluster> levels;
  levels.reserve(clusters.size());
  for (Cluster& cluster : clusters) {
    const Sphere bounds = cluster.bounds();
    levels.push_back({std::move(cluster), {}, bounds, {}});
  }
  return levels;
}

std::vector<LevelCluster> coarsened(std::vector<LevelCluster> clusters, size_t enough, const PlaceSet& fixed,
                                    const TakeGroup& take) {
  // What could not be simplified may be later, with other neighbours.
  constexpr float kGoesOn = 0.9f;
  bool mayWait = true;
  while (clusters.size() > enough) {
    const size_t before = clusters.size();
    std::vector<const Cluster*> plain;
    plain.reserve(clusters.size());
    for (const LevelCluster& level : clusters) {
      plain.push_back(&level.cluster);
    }
    const std::vector<std::vector<uint32_t>> groups = groupsOf(plain);
    const PlaceSet shared = sharedPlaces(clusters, groups, fixed);
    std::vector<Step> steps(groups.size());
    parallelFor(groups.size(), 1, [&](size_t begin, size_t end) {
      for (size_t g = begin; g < end; ++g) {
        steps[g] = stepOf(clusters, groups[g], shared);
      }
    });
    const size_t waiting = mayWait ? leaveForLater(steps) : 0;
    std::vector<LevelCluster> next;
    for (size_t g = 0; g < groups.size(); ++g) {
      std::vector<LevelCluster> members;
      members.reserve(groups[g].size());
      for (const uint32_t i : groups[g]) {
        members.push_back(std::move(clusters[i]));
      }
      if (steps[g].coarser.empty()) {
        std::move(members.begin(), members.end(), std::back_inserter(next));
        continue;
      }
      const GroupName name = take({std::move(members), steps[g].sphere, steps[g].error.larger()});
      for (Cluster& cluster : steps[g].coarser) {
        next.push_back({std::move(cluster), name, steps[g].sphere, steps[g].error});
      }
    }
    clusters = std::move(next);
    const bool helps = static_cast<float>(clusters.size()) < kGoesOn * static_cast<float>(before);
    if (!helps && waiting == 0) {
      break;
    }
    // Where too few went on, nothing waits in the next step.
    mayWait = helps;
  }
  return clusters;
}

std::vector<ClusterGroup> standingGroups(std::vector<LevelCluster> clusters) {
  std::vector<Sphere> spheres;
  spheres.reserve(clusters.size());
  for (const LevelCluster& level : clusters) {
    spheres.push_back(around(level.finerSphere, level.cluster.bounds()));
  }
  std::vector<ClusterGroup> groups;
  for (const uint32_t i : spatialOrder(spheres)) {
    if (groups.empty() || groups.back().clusters.size() == kClustersOfGroup) {
      groups.push_back({{}, {}, std::numeric_limits<float>::infinity()});
    }
    groups.back().clusters.push_back(std::move(clusters[i]));
    groups.back().sphere = around(groups.back().sphere, spheres[i]);
  }
  return groups;
}

}  // namespace ocelli
