#include "oc_core/gl/osmesa_platform.h"

#include <GL/osmesa.h>

#include <array>

#include "oc_core/gl/shared_library.h"

namespace ocelli {
namespace {

struct OsMesa {
  SharedLibrary library{"libOSMesa.so.8", "libosmesa6"};
  decltype(OSMesaCreateContextAttribs)* createContext =
      library.get<decltype(OSMesaCreateContextAttribs)>("OSMesaCreateContextAttribs");
  decltype(OSMesaDestroyContext)* destroyContext = library.get<decltype(OSMesaDestroyContext)>("OSMesaDestroyContext");
  decltype(OSMesaMakeCurrent)* makeCurrent = library.get<decltype(OSMesaMakeCurrent)>("OSMesaMakeCurrent");
  decltype(OSMesaGetProcAddress)* function = library.get<decltype(OSMesaGetProcAddress)>("OSMesaGetProcAddress");
};

class OsMesaPlatform final : public GlPlatform {
 public:
  OsMesaPlatform() {
    const std::array<int, 9> attributes{OSMESA_FORMAT,
                                        OSMESA_RGBA,
                                        OSMESA_PROFILE,
                                        OSMESA_CORE_PROFILE,
                                        OSMESA_CONTEXT_MAJOR_VERSION,
                                        kGlMajorVersion,
                                        OSMESA_CONTEXT_MINOR_VERSION,
                                        kGlMinorVersion,
                                        0};
    context_ = osMesa_.createContext(attributes.data(), nullptr);
    if (context_ == nullptr) {
      throw GlError("it has no OpenGL 4.5", "OSMesa", "update libosmesa6, or use EGL");
    }
  }
  ~OsMesaPlatform() override { osMesa_.destroyContext(context_); }
  OsMesaPlatform(const OsMesaPlatform&) = delete;
  OsMesaPlatform& operator=(const OsMesaPlatform&) = delete;

  bool makeCurrent() override {
    return osMesa_.makeCurrent(context_, pixel_.data(), GL_UNSIGNED_BYTE, 1, 1) == GL_TRUE;
  }
  void release() override { osMesa_.makeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0); }
  Function function(const char* name) const override { return reinterpret_cast<Function>(osMesa_.function(name)); }

 private:
  OsMesa osMesa_;
  OSMesaContext context_ = nullptr;
  std::array<uint8_t, 4> pixel_{};  ///< a surface of its own that nothing is drawn to
};

}  // namespace

std::unique_ptr<GlPlatform> openOsMesaPlatform() {
  return std::make_unique<OsMesaPlatform>();
}

}  // namespace ocelli
