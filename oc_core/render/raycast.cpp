#include "oc_core/render/raycast.h"

#include <embree3/rtcore.h>

#include <glm/geometric.hpp>

#include "oc_core/base/parallel.h"

namespace ocelli {

struct RayScene::Impl {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
};

RayScene::RayScene(const Mesh& mesh) : impl_(std::make_unique<Impl>()) {
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
