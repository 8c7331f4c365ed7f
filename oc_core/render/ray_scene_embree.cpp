// RayScene with Embree. ray_scene_tree.cpp is what stands in its place without.
#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>

#include "oc_core/base/parallel.h"
#include "oc_core/render/ray_segment.h"
#include "oc_core/render/raycast.h"
#include "oc_core/render/refit_quality.h"
#include "oc_core/render/triangle_point.h"

namespace ocelli {
namespace {

constexpr unsigned kLanes = 8;  ///< rays of a packet

RTCIntersectContext coherentContext() {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  return context;
}

struct NearSearch {
  const Mesh* mesh;
  glm::vec3 point;
  float reach;
  std::optional<RayScene::SurfacePoint> found = std::nullopt;
};

/// Calls `visit(query, search, triangle, closest)` for every triangle that may come within the radius of the query; it
/// returns whether it has changed that.
template <class Visit>
void searchNear(RTCScene scene, NearSearch& search, Visit) {
  RTCPointQuery query{};
  query.x = search.point.x;
  query.y = search.point.y;
  query.z = search.point.z;
  query.radius = search.reach;
  RTCPointQueryContext context;
  rtcInitPointQueryContext(&context);
  const auto callback = [](RTCPointQueryFunctionArguments* arguments) {
    NearSearch& state = *static_cast<NearSearch*>(arguments->userPtr);
    const glm::uvec3& t = state.mesh->triangles[arguments->primID];
    const std::vector<glm::vec3>& positions = state.mesh->positions;
    return Visit{}(*arguments->query, state, arguments->primID,
                   closestPoint(state.point, positions[t.x], positions[t.y], positions[t.z]));
  };
  rtcPointQuery(scene, &query, &context, callback, &search);
}

/// Calls `put(line, packet, lane)` with what each line meets.
template <class Put>
void meetInPackets(RTCScene scene, std::span<const SightLine> lines, const Put& put) {
  RTCIntersectContext context = coherentContext();
  for (size_t first = 0; first < lines.size(); first += kLanes) {
    const size_t count = std::min<size_t>(lines.size() - first, kLanes);
    RTC_ALIGN(32) int valid[kLanes];
    RTCRayHit8 packet{};
    for (size_t lane = 0; lane < kLanes; ++lane) {
      const SightLine& line = lines[first + std::min(lane, count - 1)];
      const glm::vec3 step = line.to - line.from;
      valid[lane] = lane < count && castable(line.from, step) ? -1 : 0;
      packet.ray.org_x[lane] = line.from.x;
      packet.ray.org_y[lane] = line.from.y;
      packet.ray.org_z[lane] = line.from.z;
      packet.ray.dir_x[lane] = step.x;
      packet.ray.dir_y[lane] = step.y;
      packet.ray.dir_z[lane] = step.z;
      packet.ray.tfar[lane] = 1;
      packet.ray.mask[lane] = 0xffffffffu;
      packet.hit.geomID[lane] = RTC_INVALID_GEOMETRY_ID;
    }
    rtcIntersect8(valid, scene, &context, &packet);
    for (size_t lane = 0; lane < count; ++lane) {
      put(first + lane, packet, lane);
    }
  }
}

}  // namespace

struct RayScene::Impl {
  Impl(const Mesh& ofMesh, Quality wanted, Motion ofScene)
      : mesh(&ofMesh), quality(wanted), motion(ofScene), device(rtcNewDevice(nullptr)) {
    OC_CHECK(device != nullptr, "Embree has no device");
    build();
  }
  ~Impl() {
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  void build() {
    if (scene != nullptr) {
      rtcReleaseScene(scene);
    }
    scene = rtcNewScene(device);
    rtcSetSceneFlags(scene,
                     motion == Motion::kMoves ? RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_DYNAMIC : RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(scene, quality == Quality::kLow ? RTC_BUILD_QUALITY_LOW : RTC_BUILD_QUALITY_MEDIUM);
    if (!mesh->triangles.empty()) {
      geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
      if (motion == Motion::kMoves) {
        rtcSetGeometryBuildQuality(geometry, RTC_BUILD_QUALITY_REFIT);  // its first commit builds
      }
      // Embree reads 16 bytes at the last vertex, so the positions are copied into its own padded buffer.
      positions = static_cast<glm::vec3*>(rtcSetNewGeometryBuffer(
          geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3), mesh->positions.size()));
      copyPositions();
      rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, mesh->triangles.data(), 0,
                                 sizeof(glm::uvec3), mesh->triangles.size());
      rtcCommitGeometry(geometry);
      rtcAttachGeometry(scene, geometry);
      rtcReleaseGeometry(geometry);
    }
    rtcCommitScene(scene);
    if (motion == Motion::kMoves) {
      refitQuality.emplace(*mesh);
    }
  }

  void refit() {
    copyPositions();
    rtcUpdateGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0);
    rtcCommitGeometry(geometry);
    rtcCommitScene(scene);
  }

  void copyPositions() const {
    parallelFor(mesh->positions.size(), 1 << 15, [&](size_t begin, size_t end) {
      std::copy(mesh->positions.begin() + static_cast<ptrdiff_t>(begin),
                mesh->positions.begin() + static_cast<ptrdiff_t>(end), positions + begin);
    });
  }

  const Mesh* mesh;
  Quality quality;
  Motion motion;
  RTCDevice device;
  RTCScene scene = nullptr;
  RTCGeometry geometry = nullptr;            ///< the scene holds it; nullptr where there is no triangle
  glm::vec3* positions = nullptr;            ///< its vertices
  std::optional<RefitQuality> refitQuality;  ///< of a scene that moves
};

RayScene::RayScene(const Mesh& mesh, Quality quality, Motion motion)
    : impl_(std::make_unique<Impl>(mesh, quality, motion)) {}

RayScene::~RayScene() = default;

RayScene::Update RayScene::update() {
  OC_CHECK(impl_->refitQuality.has_value(), "only a scene that moves is updated");
  if (impl_->geometry == nullptr) {
    return Update::kRefitted;
  }
  if (impl_->refitQuality->ratio() < RefitQuality::kMaxRatio) {
    impl_->refit();
    return Update::kRefitted;
  }
  impl_->build();
  return Update::kRebuilt;
}

Fragment RayScene::intersect(const RayPath& path) const {
  for (size_t i = 1; i < path.size(); ++i) {
    const glm::vec3& origin = path[i - 1];
    const glm::vec3 step = path[i] - origin;
    if (!castable(origin, step)) {
      continue;
    }
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRayHit hit{};
    hit.ray.org_x = origin.x;
    hit.ray.org_y = origin.y;
    hit.ray.org_z = origin.z;
    hit.ray.dir_x = step.x;
    hit.ray.dir_y = step.y;
    hit.ray.dir_z = step.z;
    hit.ray.tnear = 0;
    hit.ray.tfar = reachOf(path, i);
    hit.ray.mask = 0xffffffffu;
    hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(impl_->scene, &context, &hit);
    if (hit.hit.geomID != RTC_INVALID_GEOMETRY_ID) {
      return {path.tAt({i - 1, std::min(hit.ray.tfar, 1.0f)}), hit.hit.primID, hit.hit.u, hit.hit.v};
    }
  }
  return {};
}

void RayScene::intersect(std::span<const RayPath> paths, std::span<Fragment> fragments) const {
  OC_CHECK(paths.size() == fragments.size(), "one fragment a path");
  RTCIntersectContext context = coherentContext();
  std::fill(fragments.begin(), fragments.end(), Fragment{});
  // All paths advance segment by segment; those that met something or ended drop out.
  std::vector<size_t> active;
  active.reserve(paths.size());
  for (size_t i = 0; i < paths.size(); ++i) {
    if (paths[i].size() > 1) {
      active.push_back(i);
    }
  }
  for (size_t segment = 1; !active.empty(); ++segment) {
    size_t kept = 0;
    for (size_t first = 0; first < active.size(); first += kLanes) {
      const size_t count = std::min<size_t>(active.size() - first, kLanes);
      RTC_ALIGN(32) int valid[kLanes];
      RTCRayHit8 packet{};
      for (size_t lane = 0; lane < kLanes; ++lane) {
        const RayPath& path = paths[active[first + std::min(lane, count - 1)]];
        const glm::vec3& origin = path[segment - 1];
        const glm::vec3 step = path[segment] - origin;
        valid[lane] = lane < count && castable(origin, step) ? -1 : 0;
        packet.ray.org_x[lane] = origin.x;
        packet.ray.org_y[lane] = origin.y;
        packet.ray.org_z[lane] = origin.z;
        packet.ray.dir_x[lane] = step.x;
        packet.ray.dir_y[lane] = step.y;
        packet.ray.dir_z[lane] = step.z;
        packet.ray.tnear[lane] = 0;
        packet.ray.tfar[lane] = reachOf(path, segment);
        packet.ray.mask[lane] = 0xffffffffu;
        packet.hit.geomID[lane] = RTC_INVALID_GEOMETRY_ID;
      }
      rtcIntersect8(valid, impl_->scene, &context, &packet);
      for (size_t lane = 0; lane < count; ++lane) {
        const size_t i = active[first + lane];
        if (packet.hit.geomID[lane] != RTC_INVALID_GEOMETRY_ID) {
          const float share = std::min(packet.ray.tfar[lane], 1.0f);
          fragments[i] = {paths[i].tAt({segment - 1, share}), packet.hit.primID[lane], packet.hit.u[lane],
                          packet.hit.v[lane]};
        } else if (segment + 1 < paths[i].size()) {
          active[kept++] = i;
        }
      }
    }
    active.resize(kept);
  }
}

void RayScene::meet(std::span<const SightLine> lines, std::span<float> shares) const {
  OC_CHECK(lines.size() == shares.size(), "one share a line");
  meetInPackets(impl_->scene, lines, [&](size_t line, const RTCRayHit8& packet, size_t lane) {
    const bool isMet = packet.hit.geomID[lane] != RTC_INVALID_GEOMETRY_ID;
    shares[line] = isMet ? std::min(packet.ray.tfar[lane], 1.0f) : std::numeric_limits<float>::infinity();
  });
}

void RayScene::meet(std::span<const SightLine> lines, std::span<Fragment> fragments) const {
  OC_CHECK(lines.size() == fragments.size(), "one fragment a line");
  meetInPackets(impl_->scene, lines, [&](size_t line, const RTCRayHit8& packet, size_t lane) {
    fragments[line] = packet.hit.geomID[lane] == RTC_INVALID_GEOMETRY_ID
                          ? Fragment{}
                          : Fragment{std::min(packet.ray.tfar[lane], 1.0f), packet.hit.primID[lane], packet.hit.u[lane],
                                     packet.hit.v[lane]};
  });
}

const Mesh& RayScene::mesh() const {
  return *impl_->mesh;
}

Box RayScene::bounds() const {
  if (impl_->mesh->triangles.empty()) {
    return {};
  }
  RTCBounds bounds;
  rtcGetSceneBounds(impl_->scene, &bounds);
  return {{bounds.lower_x, bounds.lower_y, bounds.lower_z}, {bounds.upper_x, bounds.upper_y, bounds.upper_z}};
}

bool RayScene::hasSurfaceNear(const glm::vec3& point, float reach) const {
  NearSearch search{impl_->mesh, point, reach};
  searchNear(impl_->scene, search,
             [](RTCPointQuery& query, NearSearch& state, uint32_t triangle, const glm::vec3& closest) {
               if (state.found || glm::distance(closest, state.point) > state.reach) {
                 return false;
               }
               state.found = {closest, triangle};
               query.radius = 0;  // there is nothing left to look for
               return true;
             });
  return search.found.has_value();
}

std::optional<RayScene::SurfacePoint> RayScene::closestSurface(const glm::vec3& point, float reach) const {
  NearSearch search{impl_->mesh, point, reach};
  searchNear(
      impl_->scene, search, [](RTCPointQuery& query, NearSearch& state, uint32_t triangle, const glm::vec3& closest) {
        // Triangles at the same distance must still be visited, or the order of the visits would decide.
        constexpr float kRounding = 1 + 1e-5f;
        const float distance = glm::distance(closest, state.point);
        if (distance > state.reach || (state.found && distance == state.reach && triangle > state.found->triangle)) {
          return false;
        }
        state.found = {closest, triangle};
        state.reach = distance;
        query.radius = std::min(query.radius, distance * kRounding);
        return true;
      });
  return search.found;
}

}  // namespace ocelli
