// Which of the providers of OpenGL work on this machine.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "oc_core/gl/gl_context.h"

namespace ocelli {

struct GlProviderReport {
  GlProvider provider = GlProvider::kEgl;
  std::optional<GlInfo> info;  ///< of a context that could be opened
  std::string error;           ///< why none could, and what to do next
};

/// Tries to open a context of each, one after the other: EGL, OSMesa, and a window, which stays invisible.
std::vector<GlProviderReport> reportGlProviders();

/// The Debian packages that hold Mesa's drivers for a provider.
std::vector<std::string> packagesOf(GlProvider provider);

}  // namespace ocelli
