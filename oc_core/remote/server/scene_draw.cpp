#include "oc_core/remote/server/scene_draw.h"

#include "oc_core/base/steady_time.h"
#include "oc_core/remote/remote_message.h"

namespace ocelli {

RemoteDraw sceneDraw(const RemoteScene& scene, const RemoteSettings& settings) {
  return [&scene, settings](const RemoteRequest& request, uint32_t id,
                            const std::function<bool()>& isWanted) -> std::optional<RemoteImage> {
    const RemotePlan plan = planRemoteImage(request, settings);
    const int64_t begin = steadyNanoseconds();
    const ReferenceImage image = scene.draw(plan, settings.samples);
    const double seconds = static_cast<double>(steadyNanoseconds() - begin) * 1e-9;
    if (!isWanted()) {
      return std::nullopt;
    }
    return encodeRemoteImage(image, settings, id, request.sequence, seconds);
  };
}

std::string helloText(const RemoteScene& scene, const RemoteSettings& settings, const RemoteLimits& limits) {
  RemoteHello hello;
  hello.scene = scene.name();
  hello.view = scene.defaultView();
  hello.box = scene.bounds();
  hello.settings = settings;
  hello.maxScreen = limits.screenPixels;
  return jsonText(hello);
}

}  // namespace ocelli
