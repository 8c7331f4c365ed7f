#include "oc_core/pack/packed_scene.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

#include "oc_core/base/check.h"
#include "oc_core/base/error.h"
#include "oc_core/pack/pack_format.h"

namespace ocelli {
namespace {

constexpr uint8_t kRecordIsWhole = 1;
constexpr uint8_t kBlobIsWhole = 2;

std::span<const uint8_t> mapped(const std::filesystem::path& path) {
  const auto fail = [&](int reason) {
    throw InputError("this packed scene cannot be read: " + std::generic_category().message(reason), path.string(),
                     "give another file");
  };
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) {
    fail(errno);
  }
  struct stat info {};
  const bool isFile = ::fstat(file, &info) == 0 && S_ISREG(info.st_mode);
  const auto size = static_cast<size_t>(info.st_size);
  void* at = MAP_FAILED;
  if (isFile && size >= sizeof(opack::Mark) + sizeof(opack::Trailer)) {
    at = ::mmap(nullptr, size, PROT_READ, MAP_SHARED, file, 0);
  }
  const int reason = errno;
  ::close(file);
  if (!isFile) {
    fail(EINVAL);
  }
  if (size < sizeof(opack::Mark) + sizeof(opack::Trailer)) {
    throw InputError("this is no packed scene: it is too short", path.string(),
                     "make one with ocelli scene pack SCENE -o FILE.opack");
  }
  if (at == MAP_FAILED) {
    fail(reason);
  }
  ::madvise(at, size, MADV_RANDOM);
  return {static_cast<const uint8_t*>(at), size};
}

template <class Record>
Record recordAt(std::span<const uint8_t> bytes, uint64_t offset) {
  Record record;
  std::memcpy(&record, bytes.data() + offset, sizeof(record));
  return record;
}

}  // namespace

PackedScene::PackedScene(const std::filesystem::path& path) : path_(path), bytes_(mapped(path)) {
  try {
    const auto mark = recordAt<opack::Mark>(bytes_, 0);
    if (mark.magic != opack::kMagic) {
      throw InputError("this is no packed scene", path.string(), "make one with ocelli scene pack SCENE -o FILE.opack");
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
    description_.assign(text.begin(), text.end());
    tableOffset_ = trailer.tableOffset;
    groups_ = trailer.groups;
    triangles_ = trailer.triangles;
    storedTriangles_ = trailer.storedTriangles;
    clusters_ = trailer.clusters;
    bounds_ = {{trailer.lower[0], trailer.lower[1], trailer.lower[2]},
               {trailer.upper[0], trailer.upper[1], trailer.upper[2]}};
    checked_ = std::make_unique<std::atomic<uint8_t>[]>(groups_);
  } catch (...) {
    ::munmap(const_cast<uint8_t*>(bytes_.data()), bytes_.size());
    throw;
  }
}

PackedScene::PackedScene(PackedScene&& other) noexcept
    : path_(std::move(other.path_)),
      bytes_(std::exchange(other.bytes_, {})),
      tableOffset_(other.tableOffset_),
      groups_(other.groups_),
      triangles_(other.triangles_),
      storedTriangles_(other.storedTriangles_),
      clusters_(other.clusters_),
      bounds_(other.bounds_),
      description_(std::move(other.description_)),
      checked_(std::move(other.checked_)) {}

PackedScene::~PackedScene() {
  if (!bytes_.empty()) {
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-const-cast): it is not written to
    ::munmap(const_cast<uint8_t*>(bytes_.data()), bytes_.size());
  }
}

void PackedScene::refuse(const std::string& what) const {
  throw InputError("this packed scene is damaged: " + what, path_.string(), "pack the scene again");
}

PackedGroupInfo PackedScene::group(uint32_t group) const {
  OC_CHECK(group < groups_, "a group is one of the scene");
  const auto record = recordAt<opack::GroupRecord>(bytes_, tableOffset_ + uint64_t{group} * sizeof(opack::GroupRecord));
  if ((checked_[group].load(std::memory_order_relaxed) & kRecordIsWhole) == 0) {
    // Inner groups stand before those above them, so that no way goes around in circles.
    const bool isWhole = record.check == opack::checkOf(record) && record.offset <= tableOffset_ &&
                         record.blobBytes <= tableOffset_ - record.offset && record.firstInner <= group &&
                         record.innerGroups <= group - record.firstInner && record.innerGroups <= opack::kTree &&
                         uint64_t{record.clusters} * sizeof(opack::ClusterRecord) <= record.blobBytes;
    if (!isWhole) {
      refuse(fmt::format("the record of group {}", group));
    }
    checked_[group].fetch_or(kRecordIsWhole, std::memory_order_relaxed);
  }
  return {{{record.center[0], record.center[1], record.center[2]}, record.radius},
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
  if ((checked_[group].load(std::memory_order_relaxed) & kBlobIsWhole) == 0) {
    bool isWhole = opack::checksum(blob) == record.blobCheck;
    uint64_t triangles = 0;
    for (uint32_t i = 0; isWhole && i < info.clusters; ++i) {
      const auto cluster = recordAt<opack::ClusterRecord>(blob, i * sizeof(opack::ClusterRecord));
      triangles += cluster.triangles;
      isWhole = cluster.offset <= blob.size() &&
                opack::clusterBytes(cluster.vertices, cluster.triangles) <= blob.size() - cluster.offset &&
                cluster.vertices <= Cluster::kMaxVertices && cluster.triangles <= Cluster::kMaxTriangles &&
                (cluster.finer == PackedClusterInfo::kNone || cluster.finer < group);
      if (isWhole) {
        for (const auto& [a, b, c] : opack::clusterIn(blob, cluster).triangles) {
          isWhole = isWhole && a < cluster.vertices && b < cluster.vertices && c < cluster.vertices;
        }
      }
    }
    if (!isWhole || triangles != info.triangles) {
      refuse(fmt::format("the clusters of group {}", group));
    }
    checked_[group].fetch_or(kBlobIsWhole, std::memory_order_relaxed);
  }
  return blob;
}

PackedClusterInfo PackedScene::cluster(uint32_t group, uint32_t cluster) const {
  const std::span<const uint8_t> bytes = blob(group);
  OC_CHECK((cluster + 1) * sizeof(opack::ClusterRecord) <= bytes.size(), "a cluster is one of its group");
  const auto record = recordAt<opack::ClusterRecord>(bytes, cluster * sizeof(opack::ClusterRecord));
  return {{{record.center[0], record.center[1], record.center[2]}, record.radius},
          record.finer,
          record.vertices,
          record.triangles};
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
  const auto record = recordAt<opack::GroupRecord>(bytes_, tableOffset_ + uint64_t{group} * sizeof(opack::GroupRecord));
  const auto page = static_cast<uint64_t>(::sysconf(_SC_PAGESIZE));
  const uint64_t begin = record.offset / page * page;
  if (record.offset <= tableOffset_ && record.blobBytes <= tableOffset_ - record.offset) {
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-const-cast): advice
    ::madvise(const_cast<uint8_t*>(bytes_.data()) + begin, record.offset + record.blobBytes - begin, MADV_WILLNEED);
  }
}

void PackedScene::release() const {
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-const-cast): advice
  ::madvise(const_cast<uint8_t*>(bytes_.data()), bytes_.size(), MADV_DONTNEED);
}

void PackedScene::verify(const Progress& progress) const {
  constexpr uint32_t kBetween = 1024;
  for (uint32_t i = 0; i < groups_; ++i) {
    blob(i);
    if (i % kBetween == 0) {
      report(progress, "checking", static_cast<double>(i) / groups_);
      release();
    }
  }
}

}  // namespace ocelli
