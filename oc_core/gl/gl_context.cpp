#include "oc_core/gl/gl_context.h"

#include <algorithm>
#include <array>

#include "oc_core/base/check.h"
#include "oc_core/gl/egl_platform.h"
#include "oc_core/gl/gl_api.h"
#include "oc_core/gl/osmesa_platform.h"

namespace ocelli {
namespace {

/// OpenGL has one current context a thread; this remembers which of ours it is.
thread_local GlContext* currentContext = nullptr;

std::string text(const GladGLContext& gl, GLenum name) {
  const auto* value = reinterpret_cast<const char*>(gl.GetString(name));
  return value != nullptr ? value : "";
}

const char* nameOfError(GLenum error) {
  switch (error) {
    case GL_INVALID_ENUM:
      return "GL_INVALID_ENUM";
    case GL_INVALID_VALUE:
      return "GL_INVALID_VALUE";
    case GL_INVALID_OPERATION:
      return "GL_INVALID_OPERATION";
    case GL_INVALID_FRAMEBUFFER_OPERATION:
      return "GL_INVALID_FRAMEBUFFER_OPERATION";
    case GL_OUT_OF_MEMORY:
      return "GL_OUT_OF_MEMORY";
    case GL_CONTEXT_LOST:
      return "GL_CONTEXT_LOST";
    default:  // not an enumeration of ours
      return "an unknown error";
  }
}

/// A renderer that runs on the CPU.
bool isSoftware(const std::string& renderer) {
  constexpr std::array kNames{"llvmpipe", "softpipe", "swrast", "SWR", "Software Rasterizer"};
  return std::any_of(kNames.begin(), kNames.end(),
                     [&](const char* name) { return renderer.find(name) != std::string::npos; });
}

void GLAPIENTRY stopAtError(GLenum /*source*/, GLenum type, GLuint /*id*/, GLenum /*severity*/, GLsizei /*length*/,
                            const GLchar* message, const void* /*user*/) {
  OC_CHECK(type != GL_DEBUG_TYPE_ERROR, message);
}

/// A GPU where there is one, else what draws on the CPU.
std::unique_ptr<GlContext> openEgl(GlDebug debug) {
  std::unique_ptr<GlContext> onCpu;
  std::string said;
  for (const EglOpener& open : eglOpeners(debug)) {
    try {
      auto context = std::make_unique<GlContext>(GlProvider::kEgl, open(), debug);
      if (!context->info().isSoftware) {
        return context;
      }
      onCpu = onCpu ? std::move(onCpu) : std::move(context);
    } catch (const GlError& error) {
      said += error.reason() + "\n";
    }
  }
  if (!onCpu) {
    throw GlError(said.empty() ? "it has no driver that draws without a window" : "it has no OpenGL 4.5:", "EGL",
                  "install libgl1-mesa-dri or your GPU's driver, or update it", said);
  }
  return onCpu;
}

}  // namespace

const char* nameOf(GlProvider provider) {
  switch (provider) {
    case GlProvider::kEgl:
      return "EGL";
    case GlProvider::kOsMesa:
      return "OSMesa";
    case GlProvider::kWindow:
      return "window";
  }
  OC_CHECK(false, "every provider has a name");
}

std::string describe(const GlInfo& info) {
  return "OpenGL on " + info.renderer + ", through " + nameOf(info.provider);
}

GlContext::GlContext(GlProvider provider, std::unique_ptr<GlPlatform> platform, GlDebug debug)
    : platform_(std::move(platform)), gl_(std::make_unique<GladGLContext>()) {
  const GlScope scope(*this);
  info_.provider = provider;
  info_.device = platform_->device();
  const auto load = [](void* from, const char* name) {
    return reinterpret_cast<GLADapiproc>(static_cast<GlPlatform*>(from)->function(name));
  };
  const int loaded = gladLoadGLContextUserPtr(gl_.get(), load, platform_.get());
  if (gl_->GetString != nullptr) {
    info_.vendor = text(*gl_, GL_VENDOR);
    info_.renderer = text(*gl_, GL_RENDERER);
    info_.version = text(*gl_, GL_VERSION);
    info_.isSoftware = isSoftware(info_.renderer);
  }
  if (gl_->GetString == nullptr || loaded < GLAD_MAKE_VERSION(kGlMajorVersion, kGlMinorVersion)) {
    throw GlError("OpenGL 4.5 is needed, and this driver has " +
                      (info_.version.empty() ? "none that could be loaded" : "\"" + info_.version + "\""),
                  nameOf(provider), "update the graphics driver, or use OSMesa");
  }
  info_.shadingLanguage = text(*gl_, GL_SHADING_LANGUAGE_VERSION);
  gl_->GetIntegerv(GL_MAX_TEXTURE_SIZE, &info_.maxTextureSize);
  gl_->GetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &info_.maxTextureLayers);
  gl_->GetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &info_.maxStorageBytes);
  gl_->GetIntegerv(GL_MAX_COMPUTE_WORK_GROUP_INVOCATIONS, &info_.maxComputeInvocations);
  if (debug == GlDebug::kErrorsAreFatal) {
    gl_->Enable(GL_DEBUG_OUTPUT);
    gl_->Enable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    gl_->DebugMessageCallback(stopAtError, nullptr);
  }
  check("opening the context");
}

GlContext::~GlContext() {
  OC_CHECK(liveObjects_ == 0, "OpenGL objects must go before their context");
  if (currentContext == this) {
    platform_->release();
    currentContext = nullptr;
  }
}

void GlContext::check(std::string_view doing) const {
  OC_CHECK(currentContext == this, "hold a GlScope while calling OpenGL");
  const std::string where = std::string(nameOf(info_.provider)) + " (" + info_.renderer + "), " + std::string(doing);
  if (gl_->GetGraphicsResetStatus() != GL_NO_ERROR) {
    throw GlError("the GPU was reset and the OpenGL context is lost", where,
                  "try again; if it happens again, update the graphics driver");
  }
  const GLenum error = gl_->GetError();
  if (error == GL_NO_ERROR) {
    return;
  }
  // Several may be waiting; a lost context may answer for ever.
  for (int waiting = 0; waiting < 16 && gl_->GetError() != GL_NO_ERROR; ++waiting) {
  }
  if (error == GL_OUT_OF_MEMORY) {
    throw GlError("the GPU has not enough memory", where, "use a smaller scene or image, or close other programs");
  }
  throw GlError(std::string("OpenGL refused a call: ") + nameOfError(error), where,
                "update the graphics driver; if that does not help, report this");
}

GlScope::GlScope(GlContext& context) : context_(&context), before_(currentContext) {
  if (before_ == context_) {
    return;
  }
  if (before_ != nullptr) {
    before_->platform_->release();
    currentContext = nullptr;
  }
  if (!context_->platform_->makeCurrent()) {
    if (before_ != nullptr && before_->platform_->makeCurrent()) {
      currentContext = before_;
    }
    throw GlError("the OpenGL context cannot be made current", nameOf(context_->info_.provider),
                  "use it on one thread only; otherwise the context is lost: try again");
  }
  currentContext = context_;
}

GlScope::~GlScope() {
  if (before_ == context_ || currentContext != context_) {
    return;
  }
  context_->platform_->release();
  currentContext = before_ != nullptr && before_->platform_->makeCurrent() ? before_ : nullptr;
}

std::unique_ptr<GlContext> openGlContext(GlProvider provider, GlDebug debug) {
  OC_CHECK(provider != GlProvider::kWindow, "a window is opened by GlWindow");
  return provider == GlProvider::kEgl ? openEgl(debug)
                                      : std::make_unique<GlContext>(provider, openOsMesaPlatform(), debug);
}

std::unique_ptr<GlContext> openOffscreenContext() {
  std::string said;
  for (const GlProvider provider : {GlProvider::kEgl, GlProvider::kOsMesa}) {
    try {
      return openGlContext(provider);
    } catch (const GlError& error) {
      said += error.reason() + "\n";
    }
  }
  throw GlError("neither EGL nor OSMesa can open a context:", "OpenGL",
                "install libegl1, libgl1-mesa-dri or libosmesa6; `ocelli doctor` shows what works", said);
}

std::unique_ptr<GlContext> openGlContext(const std::string& name, const std::string& where) {
  if (name == "auto") {
    return openOffscreenContext();
  }
  if (name == "egl") {
    return openGlContext(GlProvider::kEgl);
  }
  if (name == "osmesa") {
    return openGlContext(GlProvider::kOsMesa);
  }
  throw InputError("there is no OpenGL provider \"" + name + "\"", where, "use auto, egl or osmesa");
}

}  // namespace ocelli
