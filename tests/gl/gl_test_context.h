// Contexts for tests: every call that OpenGL refuses ends the test.
#pragma once

#include <gtest/gtest.h>

#include "oc_core/gl/gl_context.h"

namespace ocelli {

/// The parameter of suites that run over the providers which need no display.
inline const auto kOffscreenProviders = testing::Values(GlProvider::kEgl, GlProvider::kOsMesa);

inline std::unique_ptr<GlContext> openTestContext(GlProvider provider) {
  return openGlContext(provider, GlDebug::kErrorsAreFatal);
}

inline std::string providerName(const testing::TestParamInfo<GlProvider>& info) {
  return nameOf(info.param);
}

}  // namespace ocelli
