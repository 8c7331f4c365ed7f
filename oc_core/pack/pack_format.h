// The bytes of packed scenes (`.opack`) as their writer and reader share them; docs/opack.md says all of it.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

#include "oc_core/pack/hierarchy.h"

namespace ocelli::opack {

static_assert(std::endian::native == std::endian::little, "records are read as they lie in the file");

inline constexpr std::array<uint8_t, 8> kMagic = {0x89, 'O', 'P', 'A', 'C', 'K', '\n', 0x1a};
inline constexpr uint32_t kVersion = 1;
inline constexpr size_t kMaxDescriptionBytes = size_t{1} << 16;
inline constexpr size_t kAlignment = 64;  ///< of blobs and the table in the file
inline constexpr size_t kTree = 8;        ///< inner groups of a group, where it has any

/// The file begins with it.
struct Mark {
  std::array<uint8_t, 8> magic = kMagic;
  uint32_t version = kVersion;
  uint32_t reserved = 0;

  bool operator==(const Mark&) const = default;
};
static_assert(sizeof(Mark) == 16 && std::is_trivially_copyable_v<Mark>);

/// The file ends with it: what is in the file is known when all of it is there.
struct Trailer {
  uint64_t fileBytes = 0;
  uint64_t tableOffset = 0;  ///< of the groups' records
  uint64_t descriptionOffset = 0;
  uint64_t triangles = 0;         ///< of the scene
  uint64_t storedTriangles = 0;   ///< of all levels
  uint64_t clusters = 0;          ///< of all levels
  uint32_t groups = 0;            ///< the last of them is the root
  uint32_t descriptionBytes = 0;  ///< of the JSON text
  std::array<float, 3> lower{};   ///< of the box around the scene
  std::array<float, 3> upper{};
  uint32_t descriptionCheck = 0;
  uint32_t check = 0;  ///< CRC-32C of all before it
};
static_assert(sizeof(Trailer) == 88 && std::is_trivially_copyable_v<Trailer>);

struct GroupRecord {
  std::array<float, 3> center{};
  float radius = 0;
  float error = 0;
  uint32_t clusters = 0;
  uint64_t offset = 0;  ///< of its blob in the file
  uint32_t blobBytes = 0;
  uint32_t triangles = 0;
  uint32_t firstInner = 0;  ///< groups that stand below this one whatever its error
  uint32_t innerGroups = 0;
  uint32_t sceneClusters = 0;  ///< of `clusters`: those of the scene itself
  uint32_t reserved = 0;
  uint32_t blobCheck = 0;
  uint32_t check = 0;  ///< CRC-32C of all before it
};
static_assert(sizeof(GroupRecord) == 64 && std::is_trivially_copyable_v<GroupRecord>);

/// A blob begins with one of these for each cluster of its group.
struct ClusterRecord {
  std::array<float, 3> center{};
  float radius = 0;
  uint32_t finer = GroupName::kNone;  ///< the group that it replaces
  uint16_t vertices = 0;
  uint16_t triangles = 0;
  uint32_t offset = 0;  ///< in the blob: positions, colours, corners
  std::array<int8_t, 4> cone{};
};
static_assert(sizeof(ClusterRecord) == 32 && std::is_trivially_copyable_v<ClusterRecord>);

/// Bytes of the arrays of a cluster.
constexpr size_t clusterBytes(size_t vertices, size_t triangles) {
  return (vertices * (sizeof(glm::vec3) + sizeof(PackedColor)) + triangles * sizeof(Cluster::Corners) + 3) / 4 * 4;
}

/// CRC-32C.
uint32_t checksum(std::span<const uint8_t> bytes);

template <class Record>
std::span<const uint8_t> bytesOf(const Record& record) {
  return {reinterpret_cast<const uint8_t*>(&record), sizeof(Record)};
}
/// Of a record whose last field is its check.
template <class Record>
uint32_t checkOf(const Record& record) {
  return checksum(bytesOf(record).first(sizeof(Record) - sizeof(uint32_t)));
}

/// The blob of a group. `finer` of each record is the index alone.
std::vector<uint8_t> blobOf(const ClusterGroup& group);
/// A cluster of a blob that holds all of it.
Cluster clusterIn(std::span<const uint8_t> blob, const ClusterRecord& record);

}  // namespace ocelli::opack
