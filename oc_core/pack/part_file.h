// What has been made of a part of a scene, as a file in the folder of a packing job: a job that was ended goes on from
// these.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "oc_core/pack/fixed_places.h"
#include "oc_core/pack/hierarchy.h"

namespace ocelli {

/// A group as it goes into the packed file, but for the numbers of the groups that its clusters replace.
struct PackedGroup {
  Sphere sphere;
  float error = 0;
  uint32_t triangles = 0;
  uint32_t sceneClusters = 0;    ///< clusters that are of the scene itself
  std::vector<GroupName> finer;  ///< of its clusters
  std::vector<uint8_t> blob;
};

PackedGroup packedGroup(const ClusterGroup& group);

struct PackedPart {
  std::vector<PackedGroup> groups;
  /// Clusters that coarser parts go on with. What they replace has the spheres and errors of LevelCluster.
  std::vector<LevelCluster> rest;
  /// Of the places of `rest` those that other parts may have, too.
  std::vector<FixedPlace> fixed;
};

/// Appears complete or not at all. Throws WorkError.
void writePart(const std::filesystem::path& path, const PackedPart& part);

/// Nothing where the file is missing, not as it was written, or of another version of this code.
std::optional<PackedPart> readPart(const std::filesystem::path& path);

}  // namespace ocelli
