#include "oc_core/sea/proxy_bytes.h"

#include <fmt/format.h>
#include <meshoptimizer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "oc_core/base/error.h"

namespace ocelli {
namespace {

struct ProxyHead {
  std::array<float, 3> lower{};
  float step = 0;  ///< of the grid, world units
  uint32_t vertices = 0;
  uint32_t triangles = 0;
  uint32_t vertexBytes = 0;
  uint32_t indexBytes = 0;
};
static_assert(sizeof(ProxyHead) == 32);

using GridPlace = std::array<uint16_t, 4>;  ///< the last one is 0: meshoptimizer takes vertices of 4 bytes at a time

constexpr float kGridSteps = 65535;

[[noreturn]] void refuse(const std::string& where) {
  throw InputError("the proxy of this sea is damaged", where, "build it anew, or take another copy");
}

}  // namespace

std::vector<uint8_t> proxyBytes(const Mesh& mesh, const std::string& where) {
  if (mesh.triangles.empty()) {
    const ProxyHead none;
    std::vector<uint8_t> bytes(sizeof(none));
    std::memcpy(bytes.data(), &none, sizeof(none));
    return bytes;
  }
  validate(mesh, where);
  if (mesh.positions.size() > kMaxProxyVertices || mesh.triangles.size() > kMaxProxyTriangles) {
    throw InputError(fmt::format("a proxy has at most {} triangles and {} vertices, this one {} and {}",
                                 kMaxProxyTriangles, kMaxProxyVertices, mesh.triangles.size(), mesh.positions.size()),
                     where, "simplify it: a dozen polygons do, some thousand are better");
  }
  const Box box = boundsOf(mesh);
  const glm::vec3 extent = box.upper - box.lower;
  ProxyHead head;
  head.lower = {box.lower.x, box.lower.y, box.lower.z};
  head.step = std::max({extent.x, extent.y, extent.z, 1e-30f}) / kGridSteps;
  head.vertices = static_cast<uint32_t>(mesh.positions.size());
  head.triangles = static_cast<uint32_t>(mesh.triangles.size());
  std::vector<GridPlace> places;
  places.reserve(mesh.positions.size());
  for (const glm::vec3& position : mesh.positions) {
    const glm::vec3 place = (position - box.lower) / head.step;
    const auto whole = [](float x) { return static_cast<uint16_t>(std::clamp(std::round(x), 0.0f, kGridSteps)); };
    places.push_back({whole(place.x), whole(place.y), whole(place.z), 0});
  }
  std::vector<uint8_t> vertices(meshopt_encodeVertexBufferBound(places.size(), sizeof(GridPlace)));
  vertices.resize(
      meshopt_encodeVertexBuffer(vertices.data(), vertices.size(), places.data(), places.size(), sizeof(GridPlace)));
  const auto* corners = reinterpret_cast<const unsigned int*>(mesh.triangles.data());
  std::vector<uint8_t> indices(meshopt_encodeIndexBufferBound(3 * mesh.triangles.size(), places.size()));
  indices.resize(meshopt_encodeIndexBuffer(indices.data(), indices.size(), corners, 3 * mesh.triangles.size()));
  head.vertexBytes = static_cast<uint32_t>(vertices.size());
  head.indexBytes = static_cast<uint32_t>(indices.size());
  std::vector<uint8_t> bytes(sizeof(head));
  std::memcpy(bytes.data(), &head, sizeof(head));
  bytes.insert(bytes.end(), vertices.begin(), vertices.end());
  bytes.insert(bytes.end(), indices.begin(), indices.end());
  return bytes;
}

Mesh proxyFromBytes(std::span<const uint8_t> bytes, const std::string& where) {
  ProxyHead head;
  if (bytes.size() < sizeof(head)) {
    refuse(where);
  }
  std::memcpy(&head, bytes.data(), sizeof(head));
  bytes = bytes.subspan(sizeof(head));
  if (head.vertices > kMaxProxyVertices || head.triangles > kMaxProxyTriangles ||
      uint64_t{head.vertexBytes} + head.indexBytes != bytes.size() || (head.vertices == 0) != (head.triangles == 0) ||
      !std::isfinite(head.step) || std::abs(head.step) > 1e12f ||
      !std::all_of(head.lower.begin(), head.lower.end(), [](float x) { return std::abs(x) < 1e17f; })) {
    refuse(where);
  }
  Mesh mesh;
  if (head.vertices == 0) {
    return mesh;
  }
  std::vector<GridPlace> places(head.vertices);
  mesh.triangles.resize(head.triangles);
  const auto vertexBytes = bytes.first(head.vertexBytes);
  const auto indexBytes = bytes.last(head.indexBytes);
  if (meshopt_decodeVertexBuffer(places.data(), places.size(), sizeof(GridPlace), vertexBytes.data(),
                                 vertexBytes.size()) != 0 ||
      meshopt_decodeIndexBuffer(mesh.triangles.data(), 3 * mesh.triangles.size(), sizeof(uint32_t), indexBytes.data(),
                                indexBytes.size()) != 0) {
    refuse(where);
  }
  const glm::vec3 lower{head.lower[0], head.lower[1], head.lower[2]};
  mesh.positions.reserve(places.size());
  for (const GridPlace& place : places) {
    mesh.positions.push_back(lower + glm::vec3(place[0], place[1], place[2]) * head.step);
  }
  for (const glm::uvec3& triangle : mesh.triangles) {
    if (std::max({triangle.x, triangle.y, triangle.z}) >= head.vertices) {
      refuse(where);
    }
  }
  return mesh;
}

}  // namespace ocelli
