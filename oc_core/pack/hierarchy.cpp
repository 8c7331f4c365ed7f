#include "oc_core/pack/hierarchy.h"

#include <algorithm>
#include <iterator>
#include <limits>

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

Step stepOf(const std::vector<LevelCluster>& clusters, const std::vector<uint32_t>& group) {
  Step step;
  Welder welder(group.size() * Cluster::kMaxVertices);
  for (const uint32_t i : group) {
    welder.add(clusters[i].cluster);
    step.sphere = around(step.sphere, around(clusters[i].finerSphere, clusters[i].cluster.bounds()));
    step.error = {std::max(step.error.distance, clusters[i].error.distance),
                  std::max(step.error.color, clusters[i].error.color)};
  }
  const WeldedTriangles welded = welder.take();
  if (std::optional<SimplifiedTriangles> coarse = simplified(welded)) {
    step.coarser = clustersOf(coarse->triangles);
    step.error = {step.error.distance + coarse->error.distance, std::max(step.error.color, coarse->error.color)};
  }
  return step;
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

std::vector<LevelCluster> coarsened(std::vector<LevelCluster> clusters, size_t enough, const TakeGroup& take) {
  // What could not be simplified may be later, with other neighbours.
  constexpr float kGoesOn = 0.9f;
  bool helps = true;
  while (helps && clusters.size() > enough) {
    const size_t before = clusters.size();
    std::vector<const Cluster*> plain;
    plain.reserve(clusters.size());
    for (const LevelCluster& level : clusters) {
      plain.push_back(&level.cluster);
    }
    const std::vector<std::vector<uint32_t>> groups = groupsOf(plain);
    std::vector<Step> steps(groups.size());
    parallelFor(groups.size(), 1, [&](size_t begin, size_t end) {
      for (size_t g = begin; g < end; ++g) {
        steps[g] = stepOf(clusters, groups[g]);
      }
    });
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
    helps = static_cast<float>(clusters.size()) < kGoesOn * static_cast<float>(before);
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
