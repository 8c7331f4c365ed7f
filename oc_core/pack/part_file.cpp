#include "oc_core/pack/part_file.h"

#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>

#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/pack/pack_format.h"

namespace ocelli {
namespace {

/// Another one with each change of what follows it.
constexpr uint64_t kMark = 0x32747261'706c6c65U;  // "ellpart2"

template <class T>
void put(std::string& bytes, const T& value) {
  static_assert(std::is_trivially_copyable_v<T>);
  bytes.append(reinterpret_cast<const char*>(&value), sizeof(T));
}
template <class T>
void putAll(std::string& bytes, const std::vector<T>& values) {
  static_assert(std::is_trivially_copyable_v<T>);
  put(bytes, static_cast<uint64_t>(values.size()));
  if (!values.empty()) {
    bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
  }
}

/// Of bytes whose checksum was right, so what they say is what was written.
class PartBytes {
 public:
  explicit PartBytes(std::string_view bytes) : bytes_(bytes) {}

  template <class T>
  T take() {
    T value;
    std::memcpy(&value, bytes_.data() + at_, sizeof(T));
    at_ += sizeof(T);
    return value;
  }
  template <class T>
  std::vector<T> takeAll() {
    std::vector<T> values(take<uint64_t>());
    if (!values.empty()) {
      std::memcpy(values.data(), bytes_.data() + at_, values.size() * sizeof(T));
    }
    at_ += values.size() * sizeof(T);
    return values;
  }

 private:
  std::string_view bytes_;
  size_t at_ = 0;
};

uint32_t checkOfText(std::string_view text) {
  return opack::checksum({reinterpret_cast<const uint8_t*>(text.data()), text.size()});
}

}  // namespace

PackedGroup packedGroup(const ClusterGroup& group) {
  PackedGroup packed{group.sphere, group.error, 0, 0, {}, opack::blobOf(group)};
  for (const LevelCluster& level : group.clusters) {
    packed.triangles += static_cast<uint32_t>(level.cluster.triangles.size());
    packed.sceneClusters += level.finer.isNone() ? 1 : 0;
    packed.finer.push_back(level.finer);
  }
  return packed;
}

void writePart(const std::filesystem::path& path, const PackedPart& part) {
  std::string bytes;
  put(bytes, kMark);
  put(bytes, static_cast<uint64_t>(part.groups.size()));
  for (const PackedGroup& group : part.groups) {
    put(bytes, group.sphere);
    put(bytes, group.error);
    put(bytes, group.triangles);
    put(bytes, group.sceneClusters);
    putAll(bytes, group.finer);
    putAll(bytes, group.blob);
  }
  put(bytes, static_cast<uint64_t>(part.rest.size()));
  for (const LevelCluster& level : part.rest) {
    put(bytes, level.finer);
    put(bytes, level.finerSphere);
    put(bytes, level.error);
    putAll(bytes, level.cluster.positions);
    putAll(bytes, level.cluster.colors);
    putAll(bytes, level.cluster.triangles);
  }
  putAll(bytes, part.fixed);
  put(bytes, checkOfText(bytes));
  writeFile(path, bytes);
}

std::optional<PackedPart> readPart(const std::filesystem::path& path) {
  std::string bytes;
  try {
    bytes = readFile(path);
  } catch (const InputError&) {
    return std::nullopt;
  }
  if (bytes.size() < sizeof(uint32_t)) {
    return std::nullopt;
  }
  uint32_t check = 0;
  std::memcpy(&check, bytes.data() + bytes.size() - sizeof(check), sizeof(check));
  bytes.resize(bytes.size() - sizeof(check));
  if (check != checkOfText(bytes)) {
    return std::nullopt;
  }
  PartBytes from(bytes);
  if (bytes.size() < sizeof(kMark) || from.take<uint64_t>() != kMark) {
    return std::nullopt;
  }
  PackedPart part;
  part.groups.resize(from.take<uint64_t>());
  for (PackedGroup& group : part.groups) {
    group.sphere = from.take<Sphere>();
    group.error = from.take<float>();
    group.triangles = from.take<uint32_t>();
    group.sceneClusters = from.take<uint32_t>();
    group.finer = from.takeAll<GroupName>();
    group.blob = from.takeAll<uint8_t>();
  }
  part.rest.resize(from.take<uint64_t>());
  for (LevelCluster& level : part.rest) {
    level.finer = from.take<GroupName>();
    level.finerSphere = from.take<Sphere>();
    level.error = from.take<LevelError>();
    level.cluster.positions = from.takeAll<glm::vec3>();
    level.cluster.colors = from.takeAll<PackedColor>();
    level.cluster.triangles = from.takeAll<Cluster::Corners>();
  }
  part.fixed = from.takeAll<FixedPlace>();
  return part;
}

}  // namespace ocelli
