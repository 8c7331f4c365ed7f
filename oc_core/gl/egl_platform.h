// Contexts of EGL without a window: Mesa's surfaceless platform, or a device.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "oc_core/gl/gl_context.h"

namespace ocelli {

/// What may open a platform: the surfaceless one first, then every GPU. Each throws GlError where it cannot.
using EglOpener = std::function<std::unique_ptr<GlPlatform>()>;

/// Throws GlError where EGL is not installed. Empty where it knows neither of the two.
std::vector<EglOpener> eglOpeners(GlDebug debug);

}  // namespace ocelli
