#include "oc_core/gl/egl_platform.h"

#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <sstream>
#include <vector>

#include "oc_core/gl/shared_library.h"

namespace ocelli {
namespace {

#define OCELLI_EGL(name) decltype(egl##name)* name = library.get<decltype(egl##name)>("egl" #name)

struct Egl {
  SharedLibrary library{"libEGL.so.1", "libegl1 and libgl1-mesa-dri, or your GPU's driver"};
  OCELLI_EGL(GetProcAddress);
  OCELLI_EGL(QueryString);
  OCELLI_EGL(Initialize);
  OCELLI_EGL(BindAPI);
  OCELLI_EGL(ChooseConfig);
  OCELLI_EGL(CreateContext);
  OCELLI_EGL(DestroyContext);
  OCELLI_EGL(MakeCurrent);
  OCELLI_EGL(GetError);

  template <class Signature>
  Signature extension(const char* name) const {
    return reinterpret_cast<Signature>(GetProcAddress(name));
  }
};

#undef OCELLI_EGL

/// A display that may have contexts.
struct Candidate {
  EGLDisplay display = EGL_NO_DISPLAY;
  std::string name;
};

bool hasExtension(const char* extensions, const std::string& name) {
  std::istringstream words(extensions != nullptr ? extensions : "");
  return std::find(std::istream_iterator<std::string>(words), {}, name) != std::istream_iterator<std::string>();
}

void addDevices(const Egl& egl, std::vector<Candidate>& candidates) {
  const auto queryDevices = egl.extension<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
  const auto queryString = egl.extension<PFNEGLQUERYDEVICESTRINGEXTPROC>("eglQueryDeviceStringEXT");
  const auto platformDisplay = egl.extension<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
  std::array<EGLDeviceEXT, 32> devices{};
  EGLint count = 0;
  if (queryDevices == nullptr || queryString == nullptr || platformDisplay == nullptr ||
      queryDevices(static_cast<EGLint>(devices.size()), devices.data(), &count) == EGL_FALSE) {
    return;
  }
  for (EGLint i = 0; i < count; ++i) {
    const EGLDeviceEXT device = devices[static_cast<size_t>(i)];
    const char* extensions = queryString(device, EGL_EXTENSIONS);
    if (hasExtension(extensions, "EGL_MESA_device_software")) {
      continue;  // what the surfaceless platform is as well
    }
    std::string name = "device " + std::to_string(i);
    if (hasExtension(extensions, "EGL_EXT_device_drm")) {
      const char* file = queryString(device, EGL_DRM_DEVICE_FILE_EXT);
      name += file != nullptr ? std::string(" (") + file + ")" : "";
    }
    candidates.push_back({platformDisplay(EGL_PLATFORM_DEVICE_EXT, device, nullptr), name});
  }
}

std::vector<Candidate> findCandidates(const Egl& egl) {
  const char* extensions = egl.QueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  std::vector<Candidate> candidates;
  if (hasExtension(extensions, "EGL_MESA_platform_surfaceless")) {
    const auto platformDisplay = egl.extension<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
    if (platformDisplay != nullptr) {
      candidates.push_back({platformDisplay(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr), "surfaceless"});
    }
  }
  if (hasExtension(extensions, "EGL_EXT_platform_device")) {
    addDevices(egl, candidates);
  }
  return candidates;
}

class EglPlatform final : public GlPlatform {
 public:
  EglPlatform(const Egl& egl, const Candidate& candidate, GlDebug debug) : egl_(egl), candidate_(candidate) {
    // A display stays initialised until the program ends: contexts of one display share it, and ending it ends all.
    EGLint major = 0;
    EGLint minor = 0;
    if (candidate.display == EGL_NO_DISPLAY || egl.Initialize(candidate.display, &major, &minor) == EGL_FALSE) {
      fail("it cannot be initialised");
    }
    if (egl.BindAPI(EGL_OPENGL_API) == EGL_FALSE) {
      fail("it has no OpenGL, only OpenGL ES");
    }
    // No surface is ever made, but a driver may want a configuration that could have one.
    const std::array<EGLint, 5> wanted{EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, 0, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (egl.ChooseConfig(candidate.display, wanted.data(), &config, 1, &count) == EGL_FALSE || count == 0) {
      fail("it has no configuration for OpenGL");
    }
    createContext(config, debug);
  }
  ~EglPlatform() override { egl_.DestroyContext(candidate_.display, context_); }
  EglPlatform(const EglPlatform&) = delete;
  EglPlatform& operator=(const EglPlatform&) = delete;

  bool makeCurrent() override {
    // The bound API is that of a thread, and a context may move to another one.
    return egl_.BindAPI(EGL_OPENGL_API) == EGL_TRUE &&
           egl_.MakeCurrent(candidate_.display, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_TRUE;
  }
  void release() override {
    egl_.BindAPI(EGL_OPENGL_API);
    egl_.MakeCurrent(candidate_.display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  }
  Function function(const char* name) const override { return reinterpret_cast<Function>(egl_.GetProcAddress(name)); }
  std::string device() const override { return candidate_.name; }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw GlError(what, "EGL, " + candidate_.name, "update the graphics driver, or use OSMesa");
  }

  void createContext(EGLConfig config, GlDebug debug) {
    // A lost context shall say so. Drivers that cannot notice it refuse the attribute.
    for (const bool notices : {true, false}) {
      std::vector<EGLint> attributes{EGL_CONTEXT_MAJOR_VERSION,       kGlMajorVersion,
                                     EGL_CONTEXT_MINOR_VERSION,       kGlMinorVersion,
                                     EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT};
      if (notices) {
        attributes.insert(attributes.end(),
                          {EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY, EGL_LOSE_CONTEXT_ON_RESET});
      }
      if (debug == GlDebug::kErrorsAreFatal) {
        attributes.insert(attributes.end(), {EGL_CONTEXT_OPENGL_DEBUG, EGL_TRUE});
      }
      attributes.push_back(EGL_NONE);
      context_ = egl_.CreateContext(candidate_.display, config, EGL_NO_CONTEXT, attributes.data());
      if (context_ != EGL_NO_CONTEXT) {
        return;
      }
    }
    fail("it has no OpenGL 4.5");
  }

  Egl egl_;
  Candidate candidate_;
  EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace

std::vector<EglOpener> eglOpeners(GlDebug debug) {
  const Egl egl;
  std::vector<EglOpener> openers;
  for (const Candidate& candidate : findCandidates(egl)) {
    openers.push_back([egl, candidate, debug] { return std::make_unique<EglPlatform>(egl, candidate, debug); });
  }
  return openers;
}

}  // namespace ocelli
