#include "oc_core/pack/cluster.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/common.hpp>

namespace ocelli {
namespace {

constexpr uint32_t kEmptySlot = 0xffffffffu;

uint64_t mixed(uint64_t h) {
  h ^= h >> 32U;
  h *= 0xd6e8feb86659fd93U;
  h ^= h >> 32U;
  return h;
}

/// Positions that compare equal must have equal bits: no negative zero.
glm::vec3 withPositiveZeros(const glm::vec3& p) {
  return p + 0.0f;
}

uint64_t hashOf(const glm::vec3& p, const PackedColor& c) {
  const uint64_t xy = uint64_t{std::bit_cast<uint32_t>(p.x)} << 32U | std::bit_cast<uint32_t>(p.y);
  const uint64_t color = uint64_t{c.red} << 32U | uint64_t{c.green} << 16U | c.blue;
  return mixed(mixed(mixed(xy) ^ std::bit_cast<uint32_t>(p.z)) ^ color);
}

}  // namespace

PackedColor packedColor(const glm::vec3& linear) {
  const glm::vec3 steps = glm::clamp(linear, 0.0f, 1.0f) * 65535.0f + 0.5f;
  return {static_cast<uint16_t>(steps.r), static_cast<uint16_t>(steps.g), static_cast<uint16_t>(steps.b)};
}

Welder::Welder(size_t vertices) : table_(std::bit_ceil(std::max<size_t>(2 * vertices, 64)), kEmptySlot) {}

uint32_t Welder::vertex(const glm::vec3& position, const PackedColor& color) {
  if (2 * (welded_.positions.size() + 1) > table_.size()) {
    grow();
  }
  const glm::vec3 p = withPositiveZeros(position);
  size_t slot = hashOf(p, color) & (table_.size() - 1);
  while (table_[slot] != kEmptySlot) {
    const uint32_t known = table_[slot];
    if (welded_.positions[known] == p && welded_.colors[known] == color) {
      return known;
    }
    slot = (slot + 1) & (table_.size() - 1);
  }
  table_[slot] = static_cast<uint32_t>(welded_.positions.size());
  welded_.positions.push_back(p);
  welded_.colors.push_back(color);
  return table_[slot];
}

void Welder::grow() {
  std::vector<uint32_t> larger(2 * table_.size(), kEmptySlot);
  for (const uint32_t known : table_) {
    if (known != kEmptySlot) {
      size_t slot = hashOf(welded_.positions[known], welded_.colors[known]) & (larger.size() - 1);
      while (larger[slot] != kEmptySlot) {
        slot = (slot + 1) & (larger.size() - 1);
      }
      larger[slot] = known;
    }
  }
  table_ = std::move(larger);
}

void Welder::add(uint32_t a, uint32_t b, uint32_t c) {
  if (a != b && b != c && c != a) {
    welded_.indices.insert(welded_.indices.end(), {a, b, c});
  }
}

void Welder::add(const Cluster& cluster) {
  std::vector<uint32_t> vertices(cluster.positions.size());
  for (size_t i = 0; i < vertices.size(); ++i) {
    vertices[i] = vertex(cluster.positions[i], cluster.colors[i]);
  }
  for (const Cluster::Corners& t : cluster.triangles) {
    add(vertices[t.a], vertices[t.b], vertices[t.c]);
  }
}

std::vector<Cluster> clustersOf(const WeldedTriangles& welded) {
  if (welded.indices.empty()) {
    return {};
  }
  const size_t most = meshopt_buildMeshletsBound(welded.indices.size(), Cluster::kMaxVertices, Cluster::kMaxTriangles);
  std::vector<meshopt_Meshlet> meshlets(most);
  std::vector<uint32_t> vertices(most * Cluster::kMaxVertices);
  std::vector<uint8_t> corners(most * Cluster::kMaxTriangles * 3);
  meshlets.resize(meshopt_buildMeshlets(meshlets.data(), vertices.data(), corners.data(), welded.indices.data(),
                                        welded.indices.size(), &welded.positions[0].x, welded.positions.size(),
                                        sizeof(glm::vec3), Cluster::kMaxVertices, Cluster::kMaxTriangles, 0));
  std::vector<Cluster> clusters;
  clusters.reserve(meshlets.size());
  for (const meshopt_Meshlet& meshlet : meshlets) {
    Cluster cluster;
    for (size_t i = 0; i < meshlet.vertex_count; ++i) {
      const uint32_t vertex = vertices[meshlet.vertex_offset + i];
      cluster.positions.push_back(welded.positions[vertex]);
      cluster.colors.push_back(welded.colors[vertex]);
    }
    const uint8_t* corner = &corners[meshlet.triangle_offset];
    for (size_t i = 0; i < meshlet.triangle_count; ++i, corner += 3) {
      cluster.triangles.push_back({corner[0], corner[1], corner[2]});
    }
    clusters.push_back(std::move(cluster));
  }
  return clusters;
}

}  // namespace ocelli
