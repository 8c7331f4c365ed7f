// An OpenGL 4.5 core context, from one of three providers: EGL without a window (it finds the GPU where there is one),
// OSMesa (a software renderer that needs neither a GPU nor a display; opened at run time, so that programs start
// without it), and a window (gl_window.h).
//
// A context belongs to one thread at a time. Whatever calls OpenGL holds a GlScope, which makes its context the current
// one and afterwards restores the one before: so several contexts, of different providers, can live on one thread.
//
// Nothing here draws to a context's own surface: everything goes to framebuffer objects, and is read back or shown from
// there.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "oc_core/gl/gl_error.h"

struct GladGLContext;  // the table of functions (gl_api.h)

namespace ocelli {

enum class GlProvider { kEgl, kOsMesa, kWindow };

/// "EGL", "OSMesa", "window".
const char* nameOf(GlProvider provider);

/// Whether a call that OpenGL refuses stops the program there and then, as tests want it. Otherwise check() finds it.
enum class GlDebug { kOff, kErrorsAreFatal };

/// The OpenGL that all of this is written for.
inline constexpr int kGlMajorVersion = 4;
inline constexpr int kGlMinorVersion = 5;

/// What a context says of itself.
struct GlInfo {
  GlProvider provider = GlProvider::kEgl;
  std::string vendor;
  std::string renderer;
  std::string version;
  std::string shadingLanguage;
  std::string device;  ///< how EGL was opened: "surfaceless", "device 0 (/dev/dri/card0)", ...
  bool isSoftware = false;
  int maxTextureSize = 0;
  int maxTextureLayers = 0;
  int64_t maxStorageBytes = 0;  ///< of a shader storage buffer
  int maxComputeInvocations = 0;
};

/// For a message: "OpenGL on llvmpipe, through EGL".
std::string describe(const GlInfo& info);

/// How a provider makes contexts: the little that differs between them.
class GlPlatform {
 public:
  using Function = void (*)();

  virtual ~GlPlatform() = default;
  virtual bool makeCurrent() = 0;
  virtual void release() = 0;
  virtual Function function(const char* name) const = 0;
  virtual std::string device() const { return {}; }
};

class GlContext {
 public:
  /// Loads the functions and checks the version. Throws GlError where it is below 4.5 or a function is missing.
  GlContext(GlProvider provider, std::unique_ptr<GlPlatform> platform, GlDebug debug = GlDebug::kOff);
  /// No GlObject of this context may be alive.
  ~GlContext();
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;

  const GlInfo& info() const { return info_; }
  /// The functions. They act on the current context: hold a GlScope.
  const GladGLContext& gl() const { return *gl_; }
  /// The same to change, for tests that let a function fail.
  GladGLContext& functions() { return *gl_; }

  /// Throws GlError where something failed since the last call: out of memory, a lost context, or a call that OpenGL
  /// refused. `doing` says what was done: "drawing the scene".
  void check(std::string_view doing) const;

  /// Objects that GlObject holds.
  int liveObjects() const { return liveObjects_; }
  void countObject(int change) { liveObjects_ += change; }

 private:
  friend class GlScope;

  std::unique_ptr<GlPlatform> platform_;
  std::unique_ptr<GladGLContext> gl_;
  GlInfo info_;
  int liveObjects_ = 0;
};

/// Makes a context the current one of this thread while it lives.
class GlScope {
 public:
  /// Throws GlError where the provider refuses.
  explicit GlScope(GlContext& context);
  ~GlScope();
  GlScope(const GlScope&) = delete;
  GlScope& operator=(const GlScope&) = delete;

 private:
  GlContext* context_;
  GlContext* before_;
};

/// One of the providers that need no display. Throws GlError, which says what to install.
std::unique_ptr<GlContext> openGlContext(GlProvider provider, GlDebug debug = GlDebug::kOff);

/// The first that works: EGL, then OSMesa. Throws GlError with what each of them said.
std::unique_ptr<GlContext> openOffscreenContext();

/// "auto", "egl" or "osmesa". Throws InputError, naming `where`, for anything else.
std::unique_ptr<GlContext> openGlContext(const std::string& name, const std::string& where);

}  // namespace ocelli
