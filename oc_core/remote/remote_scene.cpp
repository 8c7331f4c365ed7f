#include "oc_core/remote/remote_scene.h"

#include <utility>

#include "oc_core/base/check.h"
#include "oc_core/base/parallel.h"
#include "oc_core/base/steady_time.h"
#include "oc_core/camera/gpc_camera.h"

namespace ocelli {
namespace {

/// What a pixel's rays at `samples` x `samples` places of it see, on average.
Image<glm::vec3> averagedColors(const RemotePlan& plan, const Mesh& mesh, const RayScene& rays, int samples) {
  const PinholeCamera& reference = plan.reference;
  const GpcCamera camera(reference, plan.layout);
  Image<glm::vec3> sum(reference.width(), reference.height(), glm::vec3(0));
  for (int j = 0; j < samples; ++j) {
    for (int i = 0; i < samples; ++i) {
      const glm::vec2 offset = (glm::vec2(i, j) + 0.5f) / static_cast<float>(samples) - 0.5f;
      const FragmentImage seen = castRays(reference.width(), reference.height(), rays,
                                          [&](const glm::vec2& pixel) { return camera.rayPath(pixel + offset); });
      parallelFor(seen.size(), 1 << 12, [&](size_t begin, size_t end) {
        for (size_t k = begin; k < end; ++k) {
          if (seen[k].covered()) {
            sum[k] += colorOf(seen[k], mesh);
          }
        }
      });
    }
  }
  for (glm::vec3& color : sum) {
    color /= static_cast<float>(samples * samples);
  }
  return sum;
}

}  // namespace

RemoteScene::RemoteScene(Mesh mesh, std::string name, const View& view)
    : name_(std::move(name)), view_(view), mesh_(std::move(mesh)), rays_(mesh_) {}

ReferenceImage RemoteScene::draw(const RemotePlan& plan, int samples) const {
  OC_CHECK(samples >= 1, "a pixel has a ray");
  const GpcCamera camera(plan.reference, plan.layout);
  ReferenceImage image = referenceImage(raycast(camera, mesh_, rays_), mesh_, plan.reference, "gpc");
  image.layout = plan.layout;
  if (samples > 1) {
    image.color = averagedColors(plan, mesh_, rays_, samples);
  }
  return image;
}

RemoteImage RemoteScene::answer(const RemoteRequest& request, const RemoteSettings& settings, uint32_t id) const {
  const RemotePlan plan = planRemoteImage(request, settings);
  const int64_t start = steadyNanoseconds();
  const ReferenceImage image = draw(plan, settings.samples);
  const double seconds = static_cast<double>(steadyNanoseconds() - start) * 1e-9;
  return encodeRemoteImage(image, settings, id, request.sequence, seconds);
}

}  // namespace ocelli
