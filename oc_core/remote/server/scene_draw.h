// A scene as the server's clients see it.
#pragma once

#include <string>

#include "oc_core/remote/remote_scene.h"
#include "oc_core/remote/remote_settings.h"
#include "oc_core/remote/server/draw_service.h"
#include "oc_core/remote/server/remote_limits.h"

namespace ocelli {

/// Draws and encodes with these settings; stops between the two where nobody wants the image any more. `scene` must
/// outlive it.
RemoteDraw sceneDraw(const RemoteScene& scene, const RemoteSettings& settings);

/// The first message to each client.
std::string helloText(const RemoteScene& scene, const RemoteSettings& settings, const RemoteLimits& limits);

}  // namespace ocelli
