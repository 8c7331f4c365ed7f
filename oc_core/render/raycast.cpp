#include "oc_core/render/raycast.h"

#include <embree3/rtcore.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "oc_core/base/parallel.h"

namespace ocelli {
namespace {

/// The point of triangle (a, b, c) that is closest to `p`: of its plane where that lies inside, else of an edge.
glm::vec3 closestPoint(const glm::vec3& p, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
  const glm::vec3 normal = glm::cross(b - a, c - a);
  const auto leftOf = [&](const glm::vec3& from, const glm::vec3& to) {
    return glm::dot(glm::cross(to - from, p - from), normal) >= 0;
  };
  const float normal2 = glm::dot(normal, normal);
  if (normal2 > 0 && leftOf(a, b) && leftOf(b, c) && leftOf(c, a)) {
    return p - normal * (glm::dot(p - a, normal) / normal2);
  }
  const auto onEdge = [&](const glm::vec3& from, const glm::vec3& to) {
    const glm::vec3 along = to - from;
    const float length2 = glm::dot(along, along);
    return from + along * (length2 > 0 ? glm::clamp(glm::dot(p - from, along) / length2, 0.0f, 1.0f) : 0.0f);
  };
  const auto nearer = [&](const glm::vec3& q, const glm::vec3& r) {
    return glm::dot(q - p, q - p) <= glm::dot(r - p, r - p) ? q : r;
  };
  return nearer(nearer(onEdge(a, b), onEdge(b, c)), onEdge(c, a));
}

struct NearSearch {
  const Mesh* mesh;
  glm::vec3 point;
  float reach;
  bool found = false;
};

}  // namespace

struct RayScene::Impl {
  const Mesh* mesh = nullptr;
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
};

RayScene::RayScene(const Mesh& mesh) : impl_(std::make_unique<Impl>()) {
  impl_->mesh = &mesh;
  impl_->device = rtcNewDevice(nullptr);
  OC_CHECK(impl_->device != nullptr, "Embree has no device");
  impl_->scene = rtcNewScene(impl_->device);
  rtcSetSceneFlags(impl_->scene, RTC_SCENE_FLAG_ROBUST);
  RTCGeometry geometry = rtcNewGeometry(impl_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
  // Embree reads 16 bytes at the last vertex, so the positions are copied into its own padded buffer.
  auto* positions = static_cast<glm::vec3*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3), mesh.positions.size()));
  std::copy(mesh.positions.begin(), mesh.positions.end(), positions);
  auto* triangles = static_cast<glm::uvec3*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(glm::uvec3), mesh.triangles.size()));
  std::copy(mesh.triangles.begin(), mesh.triangles.end(), triangles);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(impl_->scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(impl_->scene);
}

RayScene::~RayScene() {
  rtcReleaseScene(impl_->scene);
  rtcReleaseDevice(impl_->device);
}

Fragment RayScene::intersect(const RayPath& path) const {
  for (size_t i = 1; i < path.size(); ++i) {
    const glm::vec3& origin = path[i - 1];
    const glm::vec3 step = path[i] - origin;
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
    hit.ray.tfar = 1;
    hit.ray.mask = 0xffffffffu;
    hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(impl_->scene, &context, &hit);
    if (hit.hit.geomID != RTC_INVALID_GEOMETRY_ID) {
      return {0, hit.hit.primID, hit.hit.u, hit.hit.v};
    }
  }
  return {};
}

bool RayScene::hasSurfaceNear(const glm::vec3& point, float reach) const {
  NearSearch search{impl_->mesh, point, reach};
  RTCPointQuery query{};
  query.x = point.x;
  query.y = point.y;
  query.z = point.z;
  query.radius = reach;
  RTCPointQueryContext context;
  rtcInitPointQueryContext(&context);
  const auto visit = [](RTCPointQueryFunctionArguments* arguments) {
    NearSearch& state = *static_cast<NearSearch*>(arguments->userPtr);
    const glm::uvec3& t = state.mesh->triangles[arguments->primID];
    const glm::vec3 closest =
        closestPoint(state.point, state.mesh->positions[t.x], state.mesh->positions[t.y], state.mesh->positions[t.z]);
    if (state.found || glm::distance(closest, state.point) > state.reach) {
      return false;
    }
    state.found = true;
    arguments->query->radius = 0;  // there is nothing left to look for
    return true;
  };
  rtcPointQuery(impl_->scene, &query, &context, visit, &search);
  return search.found;
}

FragmentImage castPixels(int width, int height, const std::function<Fragment(int, int)>& fragmentAt) {
  FragmentImage fragments(width, height);
  parallelFor(static_cast<size_t>(height), 1, [&](size_t begin, size_t end) {
    for (size_t y = begin; y < end; ++y) {
      for (int x = 0; x < width; ++x) {
        fragments(x, static_cast<int>(y)) = fragmentAt(x, static_cast<int>(y));
      }
    }
  });
  return fragments;
}

}  // namespace ocelli
