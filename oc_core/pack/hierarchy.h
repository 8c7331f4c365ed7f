// Levels of detail: groups of clusters are replaced by coarser clusters, again and again (B. Karis et al., Nanite,
// SIGGRAPH 2021 course; F. Ponchio, Multiresolution structures for interactive visualization, 2008).
//
// Each step joins neighbouring clusters to a group and simplifies it with its border to others as it is, so that what
// is drawn fine on one side of the border and coarse on the other still fits. The coarser clusters are grouped anew in
// the next step, so that borders do not stay. A group whose error would be far above those of the others waits for the
// next step: all that comes of it would have that error at least. A group knows a sphere around all that it stands for
// and the error of the coarser clusters that replace it; neither ever shrinks from a step to the next.
//
// Distances add up from step to step, so that the sum bounds how far a vertex of the scene lies from any level. Errors
// of colours do not: vertices that are left have the colours that they have in the scene.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "oc_core/pack/simplify_group.h"

namespace ocelli {

/// A group by the part of the scene that it was made in and its number there.
struct GroupName {
  static constexpr uint32_t kNone = 0xffffffffu;

  uint32_t part = kNone;
  uint32_t index = kNone;

  bool isNone() const { return index == kNone; }
};

/// A cluster of some level.
struct LevelCluster {
  Cluster cluster;
  GroupName finer;     ///< the group that it replaces, together with others; none: it is of the scene itself
  Sphere finerSphere;  ///< of that group; of a cluster of the scene itself its own bounds
  LevelError error;    ///< of that group
};

/// Clusters that are drawn together or not at all.
struct ClusterGroup {
  std::vector<LevelCluster> clusters;
  Sphere sphere;    ///< around them, and all that they replace
  float error = 0;  ///< of what replaces them, world units; infinite where nothing does
};

/// Takes groups, in an order that depends on nothing but the clusters; returns the name of each.
using TakeGroup = std::function<GroupName(ClusterGroup group)>;

/// Clusters of the scene itself.
std::vector<LevelCluster> levelClusters(std::vector<Cluster> clusters);

/// Replaces clusters by coarser ones until there are no more than `enough`, or that does not make them fewer; those
/// that are left come back. Vertices at `fixed` places stay: what is not among the clusters may have them, too. On all
/// threads.
std::vector<LevelCluster> coarsened(std::vector<LevelCluster> clusters, size_t enough, const PlaceSet& fixed,
                                    const TakeGroup& take);

/// Groups that nothing replaces, for clusters that stay.
std::vector<ClusterGroup> standingGroups(std::vector<LevelCluster> clusters);

}  // namespace ocelli
