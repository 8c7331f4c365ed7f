#include "oc_core/pack/pack_scene.h"

#include <algorithm>
#include <atomic>
#include <iterator>
#include <mutex>

#include "oc_core/base/check.h"
#include "oc_core/base/error.h"
#include "oc_core/base/parallel.h"
#include "oc_core/pack/pack_file_writer.h"
#include "oc_core/pack/part_file.h"
#include "oc_core/pack/scene_parts.h"
#include "oc_core/pack/sorted_triangles.h"
#include "oc_core/pack/work_folder.h"

namespace ocelli {
namespace {

/// Clusters at which a part leaves the rest to the one above. The border of a part stays as fine as the scene itself:
/// to go on within it would bend what is inside around a border that is finer by far.
constexpr size_t kEnough = 1000;

/// Clusters that a part leaves to those above, at most, where they were never simplified.
constexpr size_t kMaxRest = 2000;

class PackJob {
 public:
  PackJob(const TriangleSource& source, const std::filesystem::path& output, const PackOptions& options,
          const Progress& progress)
      : output_(output),
        options_(options),
        progress_(progress),
        folder_(output, options.sourceKey),
        plan_(planOf(source, output.string())) {
    report_.triangles = plan_.triangles;
    report_.parts = plan_.parts.size();
    if (!std::filesystem::exists(folder_.triangles()) || !std::filesystem::exists(folder_.places())) {
      report(progress, "sorting triangles", 0);
      sortTriangles(source, plan_, sortedPaths(), [&](double share) { report(progress_, "sorting triangles", share); });
    }
  }

  PackReport run() {
    makeParts();
    PackFileWriter file(output_);
    for (uint32_t i = 0; i < plan_.parts.size(); ++i) {
      PackedPart part = partOf(i);
      if (i + 1 == plan_.parts.size()) {
        settle(part, part.rest);
      }
      file.add(part);
      report(progress_, "writing", static_cast<double>(i) / static_cast<double>(plan_.parts.size()));
    }
    report_.bytes = file.finish(plan_, options_.description, report_);
    folder_.remove();
    report_.partsAtHand = atHand_;
    return report_;
  }

 private:
  /// Those without children side by side, as many as there are threads; the others one after the other.
  void makeParts() {
    std::vector<uint32_t> leaves;
    for (uint32_t i = 0; i < plan_.parts.size(); ++i) {
      if (plan_.parts[i].children.empty()) {
        leaves.push_back(i);
      }
    }
    parallelFor(leaves.size(), 1, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) {
        makeLeaf(leaves[i]);
      }
    });
    for (uint32_t i = 0; i < plan_.parts.size(); ++i) {
      if (!plan_.parts[i].children.empty()) {
        makeInner(i);
      }
    }
  }

  bool isAtHand(uint32_t index) const {
    return !options_.sourceKey.empty() && readPart(folder_.part(index)).has_value();
  }

  void makeLeaf(uint32_t index) {
    if (isAtHand(index)) {
      ++atHand_;
    } else {
      PartTriangles part = readPartTriangles(sortedPaths(), plan_, index);
      make(index, levelClusters(clustersOf(part.triangles)), std::move(part.fixed));
    }
    tell(plan_.parts[index].triangles);
  }

  void makeInner(uint32_t index) {
    if (isAtHand(index)) {
      ++atHand_;
      return;
    }
    std::vector<LevelCluster> clusters;
    std::vector<FixedPlace> fixed;
    for (const uint32_t child : plan_.parts[index].children) {
      PackedPart part = partOf(child);
      std::move(part.rest.begin(), part.rest.end(), std::back_inserter(clusters));
      fixed.insert(fixed.end(), part.fixed.begin(), part.fixed.end());
    }
    make(index, std::move(clusters), fixedAbove(plan_, index, std::move(fixed)));
  }

  SortedPaths sortedPaths() const { return {folder_.triangles(), folder_.places()}; }

  void make(uint32_t index, std::vector<LevelCluster> clusters, std::vector<FixedPlace> fixed) {
    PackedPart part;
    part.fixed = std::move(fixed);
    const auto take = [&](const ClusterGroup& group) {
      part.groups.push_back(packedGroup(group));
      return GroupName{index, static_cast<uint32_t>(part.groups.size() - 1)};
    };
    const bool isWhole = index + 1 == plan_.parts.size();
    part.rest = coarsened(std::move(clusters), isWhole ? 1 : kEnough, placesOf(part.fixed), take);
    // What is in pieces that nothing simplifies would fill the memory of the parts above.
    if (part.rest.size() > kMaxRest) {
      const auto stays = std::stable_partition(part.rest.begin(), part.rest.end(),
                                               [](const LevelCluster& level) { return !level.finer.isNone(); });
      std::vector<LevelCluster> staying(std::make_move_iterator(stays), std::make_move_iterator(part.rest.end()));
      part.rest.erase(stays, part.rest.end());
      fixForEver(part, staying);
      settle(part, staying);
    }
    writePart(folder_.part(index), part);
  }

  /// What clusters that stay have in common with others stays as well.
  static void fixForEver(PackedPart& part, const std::vector<LevelCluster>& staying) {
    std::vector<PlaceBits> others;
    for (const LevelCluster& level : part.rest) {
      std::ranges::transform(level.cluster.positions, std::back_inserter(others), placeBits);
    }
    std::ranges::transform(part.fixed, std::back_inserter(others), [](const FixedPlace& each) { return each.place; });
    const PlaceSet shared(std::move(others));
    for (const LevelCluster& level : staying) {
      for (const glm::vec3& p : level.cluster.positions) {
        if (shared.contains(placeBits(p))) {
          part.fixed.push_back({placeBits(p), FixedPlace::kForEver});
        }
      }
    }
    sortPlaces(part.fixed);
  }

  static void settle(PackedPart& part, std::vector<LevelCluster>& clusters) {
    for (const ClusterGroup& group : standingGroups(std::move(clusters))) {
      part.groups.push_back(packedGroup(group));
    }
    clusters.clear();
  }

  PackedPart partOf(uint32_t index) const {
    std::optional<PackedPart> part = readPart(folder_.part(index));
    if (!part) {
      throw WorkError("what was made of a part of the scene is damaged", folder_.part(index).string(),
                      "remove it, and pack the scene again");
    }
    return std::move(*part);
  }

  void tell(uint64_t triangles) {
    const std::scoped_lock lock(telling_);
    told_ += triangles;
    report(progress_, "making levels of detail", static_cast<double>(told_) / static_cast<double>(plan_.triangles));
  }

  std::filesystem::path output_;
  const PackOptions& options_;
  const Progress& progress_;
  WorkFolder folder_;
  ScenePlan plan_;
  PackReport report_;
  std::atomic<size_t> atHand_{0};
  std::mutex telling_;
  uint64_t told_ = 0;
};

}  // namespace

PackReport packScene(const TriangleSource& source, const std::filesystem::path& path, const PackOptions& options,
                     const Progress& progress) {
  report(progress, "counting triangles", 0);
  return PackJob(source, path, options, progress).run();
}

}  // namespace ocelli
