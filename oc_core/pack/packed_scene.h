// A packed scene (`.opack`): clusters of triangles in levels of detail, read from disk as they are needed.
//
//   const PackedScene scene("city.opack");
//   const std::vector<ClusterChoice> cut = chooseClusters(scene, isVisible, isCloseEnough);
//   const Mesh mesh = meshOf(scene, cut);
//
// The file is mapped into memory (mapped_file.h, which says what happens where it becomes shorter meanwhile): what is
// not touched is not read, and the system gives pages back when it needs them. Everything is checked when it is first
// touched, against checksums and against files that were made to mislead: no way through the groups goes in circles, no
// byte stands for two groups, and so what can be asked for is bounded by the size of the file.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "oc_core/base/mapped_file.h"
#include "oc_core/base/progress.h"
#include "oc_core/pack/sphere.h"
#include "oc_core/scene/box.h"
#include "oc_core/scene/mesh.h"

namespace ocelli {

/// Clusters that are drawn together or not at all, and what stands below them.
struct PackedGroupInfo {
  Sphere sphere;            ///< around all that its clusters and those that they replace show
  float error = 0;          ///< world units: of the clusters that replace these; infinite where nothing does
  uint32_t clusters = 0;    ///< of this group
  uint32_t triangles = 0;   ///< of these
  uint32_t firstInner = 0;  ///< groups that stand below this one whatever its error
  uint32_t innerGroups = 0;
  uint64_t bytes = 0;  ///< of its clusters in the file
};

struct PackedClusterInfo {
  static constexpr uint32_t kNone = 0xffffffffu;

  Sphere bounds;
  uint32_t finer = kNone;  ///< the group that this cluster and others replace; none: it is of the scene itself
  uint32_t vertices = 0;
  uint32_t triangles = 0;
};

class PackedScene {
 public:
  /// Throws InputError where the file is missing, no packed scene, of another version, or damaged at its end.
  explicit PackedScene(const std::filesystem::path& path);

  const std::filesystem::path& path() const { return path_; }
  const Box& bounds() const { return bounds_; }
  uint64_t triangleCount() const { return triangles_; }          ///< of the scene
  uint64_t storedTriangles() const { return storedTriangles_; }  ///< of all levels
  uint64_t clusterCount() const { return clusters_; }
  uint32_t groupCount() const { return groups_; }
  uint64_t fileBytes() const { return bytes_.size(); }
  /// JSON: what was packed.
  const std::string& description() const { return description_; }
  /// All of the scene stands below this group.
  uint32_t root() const { return groups_ - 1; }

  /// These throw InputError, naming the file and the group, where it is damaged. Safe to call from many threads.
  PackedGroupInfo group(uint32_t group) const;
  PackedClusterInfo cluster(uint32_t group, uint32_t cluster) const;
  /// Writes its vertices and triangles; each span has the size that cluster() tells.
  void read(uint32_t group, uint32_t cluster, std::span<glm::vec3> positions, std::span<glm::vec3> colors,
            std::span<glm::uvec3> triangles, uint32_t firstVertex) const;

  /// Begins to read what a group holds, where that was not read before. Does not wait for it.
  void willNeed(uint32_t group) const;
  /// Gives the memory of what was read back to the system: for those who go through all of a large file.
  void release() const;

  /// Checks all of the file; throws as above. `progress` gets shares of the groups.
  void verify(const Progress& progress = {}) const;

 private:
  [[noreturn]] void refuse(const std::string& what) const;
  std::span<const uint8_t> blob(uint32_t group) const;

  struct Checked {
    explicit Checked(uint32_t groupCount) : groups(groupCount) {}

    std::vector<std::atomic<uint8_t>> groups;  ///< bit 0: the record is whole, bit 1: the clusters are
    std::atomic<uint64_t> blobBytes = 0;       ///< of all groups whose clusters are
  };

  std::filesystem::path path_;
  MappedFile file_;
  std::span<const uint8_t> bytes_;
  uint64_t tableOffset_ = 0;
  uint32_t groups_ = 0;
  uint64_t triangles_ = 0;
  uint64_t storedTriangles_ = 0;
  uint64_t clusters_ = 0;
  Box bounds_;
  std::string description_;
  std::unique_ptr<Checked> checked_;  ///< what is known to be whole
};

/// A cluster by its group and its number there.
struct ClusterChoice {
  uint32_t group = 0;
  uint32_t cluster = 0;

  bool operator==(const ClusterChoice&) const = default;
};

}  // namespace ocelli
