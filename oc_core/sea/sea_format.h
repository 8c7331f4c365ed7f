// The bytes of a sea of images (`.sea`) as its writer and reader share them; docs/sea_format.md says all of it.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include "oc_core/checksum/crc32c.h"
#include "oc_core/sea/sea_projection.h"

namespace ocelli::sea {

static_assert(std::endian::native == std::endian::little, "records are read as they lie in the file");

inline constexpr std::array<uint8_t, 8> kMagic = {0x89, 'O', 'S', 'E', 'A', '\r', '\n', 0x1a};
inline constexpr uint32_t kVersion = 1;
inline constexpr uint32_t kNoReference = 0xffffffffu;
inline constexpr size_t kAlignment = 8;  ///< of records
inline constexpr uint32_t kMaxImages = 1u << 24;
inline constexpr uint64_t kMaxPayload = uint64_t{1} << 31;

/// The file begins with it.
struct Header {
  std::array<uint8_t, 8> magic = kMagic;
  uint32_t version = kVersion;
  uint32_t isComplete = 0;  ///< 0 while it is being built: then the rest is 0 as well
  uint64_t fileBytes = 0;
  uint64_t posesOffset = 0;  ///< of the record's payload, as the others
  uint64_t indexOffset = 0;
  uint32_t images = 0;
  std::array<uint32_t, 4> reserved{};
  uint32_t check = 0;  ///< CRC-32C of all before it
};
static_assert(sizeof(Header) == 64 && std::is_trivially_copyable_v<Header>);

enum class RecordKind : uint32_t {
  kSettings = 1,  ///< JSON
  kNames = 2,     ///< of the images: UTF-8, each followed by a line feed
  kPoses = 3,     ///< a PoseEntry for each image
  kProxy = 4,
  kImage = 5,   ///< an ImagePrefix, then the bytes of a codec
  kIndex = 6,   ///< an IndexEntry for each image; the last record
  kHidden = 7,  ///< hidden samples of the I-node whose record comes next: a HiddenPrefix, then its layers
};

/// Before every record; zeros fill it up to a multiple of kAlignment.
struct RecordHeader {
  std::array<uint8_t, 4> mark = {'S', 'R', 'E', 'C'};
  RecordKind kind{};
  uint32_t number = 0;  ///< of an image, else 0
  uint32_t payloadCheck = 0;
  uint64_t payloadBytes = 0;
  uint32_t reserved = 0;
  uint32_t check = 0;
};
static_assert(sizeof(RecordHeader) == 32 && std::is_trivially_copyable_v<RecordHeader>);

struct PoseEntry {
  std::array<double, 3> position{};
  std::array<double, 4> worldFromCamera{};  ///< a unit quaternion: w, x, y, z
  uint32_t reserved = 0;
  uint32_t check = 0;
};
static_assert(sizeof(PoseEntry) == 64 && std::is_trivially_copyable_v<PoseEntry>);

struct ImagePrefix {
  std::array<float, 3> translation{};  ///< that refines the pose of a P-node, in the axes of its camera
  std::array<float, 3> rotation{};     ///< axis times angle
  uint32_t reference = kNoReference;
  float quality = 0;  ///< that its codec was given
};
static_assert(sizeof(ImagePrefix) == 32 && std::is_trivially_copyable_v<ImagePrefix>);

struct IndexEntry {
  uint64_t offset = 0;  ///< of the payload of its record
  uint32_t payloadBytes = 0;
  uint32_t payloadCheck = 0;
  uint32_t reference = kNoReference;
  uint32_t additions = 0;    ///< one more than that of its reference; 0 of an I-node
  uint32_t hiddenBytes = 0;  ///< of an I-node: the payload of the record before its own; 0: it has no hidden samples
  uint32_t check = 0;
};
static_assert(sizeof(IndexEntry) == 32 && std::is_trivially_copyable_v<IndexEntry>);

/// Then for each layer a bit for each block of the image, the colours of those that have samples, and their levels.
struct HiddenPrefix {
  uint32_t layers = 0;
  float nearest = 0;  ///< the distance from the I-node's eye that level 1 stands for
  uint32_t colorBytes = 0;
  uint32_t levelBytes = 0;
};
static_assert(sizeof(HiddenPrefix) == 16 && std::is_trivially_copyable_v<HiddenPrefix>);

template <class Record>
std::span<const uint8_t> bytesOf(const Record& record) {
  return {reinterpret_cast<const uint8_t*>(&record), sizeof(Record)};
}
/// Of a record whose last field is its check.
template <class Record>
uint32_t checkOf(const Record& record) {
  return crc32c(bytesOf(record).first(sizeof(Record) - sizeof(uint32_t)));
}
template <class Record>
Record sealed(Record record) {
  record.check = checkOf(record);
  return record;
}

constexpr uint64_t paddedBytes(uint64_t bytes) {
  return (bytes + kAlignment - 1) / kAlignment * kAlignment;
}

/// Of the payload of the record that an image's hidden samples stand in.
constexpr uint64_t hiddenOffset(uint64_t imagePayload, uint32_t hiddenBytes) {
  return imagePayload - sizeof(RecordHeader) - paddedBytes(hiddenBytes);
}

PoseEntry entryOf(const SeaPose& pose);
SeaPose poseOf(const PoseEntry& entry);

}  // namespace ocelli::sea
