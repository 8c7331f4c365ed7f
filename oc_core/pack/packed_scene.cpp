#include "oc_core/pack/packed_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "oc_core/base/check.h"
#include "oc_core/base/error.h"
#include "oc_core/base/finite.h"
#include "oc_core/pack/pack_format.h"

namespace ocelli {
namespace {

constexpr uint8_t kRecordIsWhole = 1;
constexpr uint8_t kBlobIsWhole = 2;
constexpr const char* kMakeOne = "make one with ocelli scene pack SCENE -o FILE.opack";

template <class Record>
Record recordAt(std::span<const uint8_t> bytes, uint64_t offset) {
  Record record;
  std::memcpy(&record, bytes.data() + offset, sizeof(record));
  return record;
}

Sphere sphereOf(const std::array<float, 3>& center, float radius) {
  return {{center[0], center[1], center[2]}, radius};
}

bool isSphere(const Sphere& sphere) {
  return isFinite(sphere.center) && std::isfinite(sphere.radius) && sphere.radius >= 0;
}

/// Whether a cluster of `group` is all in its blob, and nothing but numbers.
bool isCluster(std::span<const uint8_t> blob, const opack::ClusterRecord& record, uint32_t group) {
  if (record.offset > blob.size() ||
      opack::clusterBytes(record.vertices, record.triangles) > blob.size() - record.offset || record.vertices == 0 ||
      record.vertices > Cluster::kMaxVertices || record.triangles == 0 || record.triangles > Cluster::kMaxTriangles ||
      (record.finer != PackedClusterInfo::kNone && record.finer >= group) ||
      !isSphere(sphereOf(record.center, record.radius))) {
    return false;
  }
  const Cluster cluster = opack::clusterIn(blob, record);
  return std::ranges::all_of(cluster.positions, [](const glm::vec3& p) { return isFinite(p); }) &&
         std::ranges::all_of(cluster.triangles, [&](const Cluster::Corners& t) {
           return std::max({t.a, t.b, t.c}) < record.vertices;
         });
}

}  // namespace

PackedScene::PackedScene(const std::filesystem::path& path) : path_(path), file_(path), bytes_(file_.bytes()) {
  if (bytes_.size() < sizeof(opack::Mark) + sizeof(opack::Trailer)) {
    throw InputError("this is no packed scene: it is too short", path.string(), kMakeOne);
  }
  const auto mark = recordAt<opack::Mark>(bytes_, 0);
  if (mark.magic != opack::kMagic) {
    throw InputError("this is no packed scene", path.string(), kMakeOne);
  }
  if (mark.version != opack::kVersion) {
    throw InputError(fmt::format("this packed scene has version {}, not {}", mark.version, opack::kVersion),
                     path.string(), "pack the scene again");
  }
  const auto trailer = recordAt<opack::Trailer>(bytes_, bytes_.size() - sizeof(opack::Trailer));
  if (trailer.check != opack::checkOf(trailer) || trailer.fileBytes != bytes_.size()) {
    refuse("it was cut off, or its end is damaged");
  }
  const uint64_t end = bytes_.size() - sizeof(opack::Trailer);
  if (trailer.groups == 0 || trailer.tableOffset > end ||
      trailer.groups > (end - trailer.tableOffset) / sizeof(opack::GroupRecord) ||
      trailer.descriptionBytes > opack::kMaxDescriptionBytes || trailer.descriptionOffset > end ||
      trailer.descriptionBytes > end - trailer.descriptionOffset) {
    refuse("its parts do not fit into it");
  }
  const std::span<const uint8_t> text = bytes_.subspan(trailer.descriptionOffset, trailer.descriptionBytes);
  if (opack::checksum(text) != trailer.descriptionCheck) {
    refuse("its description is damaged");
  }
  bounds_ = {{trailer.lower[0], trailer.lower[1], trailer.lower[2]},
             {trailer.upper[0], trailer.upper[1], trailer.upper[2]}};
  if (!isFinite(bounds_.lower) || !isFinite(bounds_.upper)) {
    refuse("its box is not made of finite numbers");
  }
  description_.assign(text.begin(), text.end());
  tableOffset_ = trailer.tableOffset;
  groups_ = trailer.groups;
  triangles_ = trailer.triangles;
  storedTriangles_ = trailer.storedTriangles;
  clusters_ = trailer.clusters;
  checked_ = std::make_unique<Checked>(groups_);
}

void PackedScene::refuse(const std::string& what) const {
  throw InputError("this packed scene is damaged: " + what, path_.string(), "pack the scene again");
}

PackedGroupInfo PackedScene::group(uint32_t group) const {
  OC_CHECK(group < groups_, "a group is one of the scene");
  const auto record = recordAt<opack::GroupRecord>(bytes_, tableOffset_ + uint64_t{group} * sizeof(opack::GroupRecord));
  if ((checked_->groups[group].load(std::memory_order_relaxed) & kRecordIsWhole) == 0) {
    // Inner groups stand before those above them, so that no way goes around in circles.
    const bool isWhole = record.check == opack::checkOf(record) && record.offset <= tableOffset_ &&
                         record.blobBytes <= tableOffset_ - record.offset && record.firstInner <= group &&
                         record.innerGroups <= group - record.firstInner && record.innerGroups <= opack::kTree &&
                         uint64_t{record.clusters} * sizeof(opack::ClusterRecord) <= record.blobBytes &&
                         isSphere(sphereOf(record.center, record.radius)) && record.error >= 0;
    if (!isWhole) {
      refuse(fmt::format("the record of group {}", group));
    }
    checked_->groups[group].fetch_or(kRecordIsWhole, std::memory_order_relaxed);
  }
  return {sphereOf(record.center, record.radius),
          record.error,
          record.clusters,
          record.triangles,
          record.firstInner,
          record.innerGroups,
          record.blobBytes};
}

std::span<const uint8_t> PackedScene::blob(uint32_t group) const {
  const PackedGroupInfo info = this->group(group);
  const auto record = recordAt<opack::GroupRecord>(bytes_, tableOffset_ + uint64_t{group} * sizeof(opack::GroupRecord));
  const std::span<const uint8_t> blob = bytes_.subspan(record.offset, record.blobBytes);
  if ((checked_->groups[group].load(std::memory_order_relaxed) & kBlobIsWhole) == 0) {
    bool isWhole = opack::checksum(blob) == record.blobCheck;
    uint64_t triangles = 0;
    uint64_t bytes = uint64_t{info.clusters} * sizeof(opack::ClusterRecord);
    for (uint32_t i = 0; isWhole && i < info.clusters; ++i) {
      const auto cluster = recordAt<opack::ClusterRecord>(blob, i * sizeof(opack::ClusterRecord));
      triangles += cluster.triangles;
      bytes += opack::clusterBytes(cluster.vertices, cluster.triangles);
      isWhole = isCluster(blob, cluster, group);
    }
    if (!isWhole || triangles != info.triangles || bytes > blob.size()) {
      refuse(fmt::format("the clusters of group {}", group));
    }
    const bool isFirst =
        (checked_->groups[group].fetch_or(kBlobIsWhole, std::memory_order_relaxed) & kBlobIsWhole) == 0;
    if (isFirst && checked_->blobBytes.fetch_add(blob.size(), std::memory_order_relaxed) + blob.size() > tableOffset_) {
      checked_->blobBytes.fetch_sub(blob.size(), std::memory_order_relaxed);
      checked_->groups[group].fetch_and(static_cast<uint8_t>(~kBlobIsWhole), std::memory_order_relaxed);
      refuse(fmt::format("group {} shares its bytes with others", group));
    }
  }
  return blob;
}

PackedClusterInfo PackedScene::cluster(uint32_t group, uint32_t cluster) const {
  const std::span<const uint8_t> bytes = blob(group);
  OC_CHECK((cluster + 1) * sizeof(opack::ClusterRecord) <= bytes.size(), "a cluster is one of its group");
  const auto record = recordAt<opack::ClusterRecord>(bytes, cluster * sizeof(opack::ClusterRecord));
  return {sphereOf(record.center, record.radius), record.finer, record.vertices, record.triangles};
}

void PackedScene::read(uint32_t group, uint32_t cluster, std::span<glm::vec3> positions, std::span<glm::vec3> colors,
                       std::span<glm::uvec3> triangles, uint32_t firstVertex) const {
  const std::span<const uint8_t> bytes = blob(group);
  const auto record = recordAt<opack::ClusterRecord>(bytes, cluster * sizeof(opack::ClusterRecord));
  const uint8_t* at = bytes.data() + record.offset;
  std::memcpy(positions.data(), at, record.vertices * sizeof(glm::vec3));
  at += record.vertices * sizeof(glm::vec3);
  for (size_t i = 0; i < record.vertices; ++i, at += sizeof(PackedColor)) {
    PackedColor color;
    std::memcpy(&color, at, sizeof(color));
    colors[i] = linearColor(color);
  }
  for (size_t i = 0; i < record.triangles; ++i, at += 3) {
    triangles[i] = glm::uvec3(at[0], at[1], at[2]) + firstVertex;
  }
}

void PackedScene::willNeed(uint32_t group) const {
  if ((checked_->groups[group].load(std::memory_order_relaxed) & kBlobIsWhole) != 0) {
    return;
  }
  const auto record = recordAt<opack::GroupRecord>(bytes_, tableOffset_ + uint64_t{group} * sizeof(opack::GroupRecord));
  if (record.offset <= tableOffset_ && record.blobBytes <= tableOffset_ - record.offset) {
    file_.willNeed(record.offset, record.offset + record.blobBytes);
  }
}

void PackedScene::release() const {
  file_.release();
}

void PackedScene::verify(const Progress& progress) const {
  constexpr uint32_t kBetween = 1024;
  constexpr uint32_t kAhead = 64;
  for (uint32_t i = 0; i < groups_; ++i) {
    if (i + kAhead < groups_) {
      willNeed(i + kAhead);
    }
    blob(i);
    if (i % kBetween == 0) {
      report(progress, "checking", static_cast<double>(i) / groups_);
      release();
    }
  }
}

}  // namespace ocelli
