// BlockedRays with Embree. blocked_rays_tree.cpp is what stands in its place without.
#include <embree3/rtcore.h>

#include <algorithm>

#include "oc_core/base/check.h"
#include "oc_core/render/blocked_rays.h"
#include "oc_core/render/ray_segment.h"

namespace ocelli {
namespace {

constexpr size_t kLanesOfPacket = 8;

}  // namespace

struct BlockedRays::Impl {
  Impl(const Mesh& mesh, bool fast) : device(rtcNewDevice(nullptr)), scene(rtcNewScene(device)) {
    OC_CHECK(device != nullptr && scene != nullptr, "Embree has no device");
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(scene, fast ? RTC_BUILD_QUALITY_LOW : RTC_BUILD_QUALITY_MEDIUM);
    if (!mesh.triangles.empty()) {
      RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
      // Embree reads 16 bytes at the last vertex, so the positions are copied into its own padded buffer.
      auto* positions = static_cast<glm::vec3*>(rtcSetNewGeometryBuffer(
          geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3), mesh.positions.size()));
      std::copy(mesh.positions.begin(), mesh.positions.end(), positions);
      rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, mesh.triangles.data(), 0,
                                 sizeof(glm::uvec3), mesh.triangles.size());
      rtcCommitGeometry(geometry);
      rtcAttachGeometry(scene, geometry);
      rtcReleaseGeometry(geometry);
    }
    rtcCommitScene(scene);
  }
  ~Impl() {
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  RTCDevice device;
  RTCScene scene;
};

BlockedRays::BlockedRays(const Mesh& mesh, bool fast) : impl_(std::make_unique<Impl>(mesh, fast)) {}
BlockedRays::~BlockedRays() = default;

void BlockedRays::find(std::span<const SightLine> lines, std::span<uint8_t> blocked) const {
  OC_CHECK(lines.size() == blocked.size(), "one entry a line");
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  for (size_t first = 0; first < lines.size(); first += kLanesOfPacket) {
    const size_t count = std::min(lines.size() - first, kLanesOfPacket);
    RTC_ALIGN(32) int valid[kLanesOfPacket];
    RTCRay8 packet{};
    for (size_t lane = 0; lane < kLanesOfPacket; ++lane) {
      const SightLine& line = lines[first + std::min(lane, count - 1)];
      const glm::vec3 step = line.to - line.from;
      valid[lane] = lane < count && castable(line.from, step) ? -1 : 0;
      packet.org_x[lane] = line.from.x;
      packet.org_y[lane] = line.from.y;
      packet.org_z[lane] = line.from.z;
      packet.dir_x[lane] = step.x;
      packet.dir_y[lane] = step.y;
      packet.dir_z[lane] = step.z;
      packet.tfar[lane] = 1;
      packet.mask[lane] = 0xffffffffu;
    }
    rtcOccluded8(valid, impl_->scene, &context, &packet);
    for (size_t lane = 0; lane < count; ++lane) {
      blocked[first + lane] = valid[lane] != 0 && packet.tfar[lane] < 0 ? 1 : 0;
    }
  }
}

}  // namespace ocelli
