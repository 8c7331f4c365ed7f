#include "oc_core/window/gl_report.h"

#include "oc_core/base/check.h"
#include "oc_core/window/gl_window.h"

namespace ocelli {
namespace {

GlInfo infoOf(GlProvider provider) {
  return provider == GlProvider::kWindow ? GlWindow({.visible = false}).context().info()
                                         : openGlContext(provider)->info();
}

}  // namespace

std::vector<GlProviderReport> reportGlProviders() {
  std::vector<GlProviderReport> reports;
  for (const GlProvider provider : {GlProvider::kEgl, GlProvider::kOsMesa, GlProvider::kWindow}) {
    GlProviderReport report{provider, std::nullopt, {}};
    try {
      report.info = infoOf(provider);
    } catch (const GlError& error) {
      report.error = error.what();
    }
    reports.push_back(report);
  }
  return reports;
}

std::vector<std::string> packagesOf(GlProvider provider) {
  switch (provider) {
    case GlProvider::kEgl:
      return {"libegl1", "libgl1-mesa-dri"};
    case GlProvider::kOsMesa:
      return {"libosmesa6"};
    case GlProvider::kWindow:
      return {"libgl1", "libgl1-mesa-dri"};
  }
  OC_CHECK(false, "every provider has its packages");
}

}  // namespace ocelli
