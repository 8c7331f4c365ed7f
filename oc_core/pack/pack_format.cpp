#include "oc_core/pack/pack_format.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <cstring>

#include "oc_core/checksum/crc32c.h"

namespace ocelli::opack {
namespace {

/// The axis of the cone around the normals and the cosine that a view direction must exceed to see backs alone, in
/// steps of 1/127; 127 where no direction does.
std::array<int8_t, 4> coneOf(const Cluster& cluster) {
  std::vector<uint32_t> vertices(cluster.positions.size());
  for (uint32_t i = 0; i < vertices.size(); ++i) {
    vertices[i] = i;
  }
  const meshopt_Bounds bounds =
      meshopt_computeMeshletBounds(vertices.data(), &cluster.triangles[0].a, cluster.triangles.size(),
                                   &cluster.positions[0].x, cluster.positions.size(), sizeof(glm::vec3));
  return {static_cast<int8_t>(bounds.cone_axis_s8[0]), static_cast<int8_t>(bounds.cone_axis_s8[1]),
          static_cast<int8_t>(bounds.cone_axis_s8[2]), static_cast<int8_t>(bounds.cone_cutoff_s8)};
}

template <class T>
void append(std::vector<uint8_t>& bytes, const std::vector<T>& values) {
  static_assert(std::is_trivially_copyable_v<T>);
  const size_t at = bytes.size();
  bytes.resize(at + values.size() * sizeof(T));
  std::memcpy(bytes.data() + at, values.data(), values.size() * sizeof(T));
}

template <class T>
const uint8_t* take(const uint8_t* from, std::vector<T>& values, size_t count) {
  values.resize(count);
  // Of nothing there may be no address.
  if (count > 0) {
    std::memcpy(values.data(), from, count * sizeof(T));
  }
  return from + count * sizeof(T);
}

}  // namespace

uint32_t checksum(std::span<const uint8_t> bytes) {
  return crc32c(bytes);
}

std::vector<uint8_t> blobOf(const ClusterGroup& group) {
  std::vector<uint8_t> blob(group.clusters.size() * sizeof(ClusterRecord));
  for (size_t i = 0; i < group.clusters.size(); ++i) {
    const auto& [cluster, finer, finerSphere, error] = group.clusters[i];
    const Sphere bounds = cluster.bounds();
    ClusterRecord record{.center = {bounds.center.x, bounds.center.y, bounds.center.z},
                         .radius = bounds.radius,
                         .finer = finer.index,
                         .vertices = static_cast<uint16_t>(cluster.positions.size()),
                         .triangles = static_cast<uint16_t>(cluster.triangles.size()),
                         .offset = static_cast<uint32_t>(blob.size()),
                         .cone = coneOf(cluster)};
    std::memcpy(blob.data() + i * sizeof(ClusterRecord), &record, sizeof(record));
    append(blob, cluster.positions);
    append(blob, cluster.colors);
    append(blob, cluster.triangles);
    blob.resize((blob.size() + 3) / 4 * 4);
  }
  return blob;
}

Cluster clusterIn(std::span<const uint8_t> blob, const ClusterRecord& record) {
  Cluster cluster;
  const uint8_t* at = blob.data() + record.offset;
  at = take(at, cluster.positions, record.vertices);
  at = take(at, cluster.colors, record.vertices);
  take(at, cluster.triangles, record.triangles);
  return cluster;
}

}  // namespace ocelli::opack
