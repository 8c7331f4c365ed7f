#include "bench/osmesa_renderer.h"

#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>
#include <GL/osmesa.h>

#include <array>
#include <glm/gtc/type_ptr.hpp>
#include <vector>

#include "oc_core/base/error.h"
#include "oc_core/scene/scene.h"

namespace ocelli {
namespace {

template <class Function>
Function glFunction(const char* name) {
  const auto function = reinterpret_cast<Function>(OSMesaGetProcAddress(name));
  if (function == nullptr) {
    throw WorkError(std::string("OpenGL has no ") + name, "OSMesa", "install libosmesa6");
  }
  return function;
}

template <class Item>
void fillBuffer(GLenum target, GLuint buffer, const std::vector<Item>& items) {
  glFunction<PFNGLBINDBUFFERPROC>("glBindBuffer")(target, buffer);
  glFunction<PFNGLBUFFERDATAPROC>("glBufferData")(target, static_cast<GLsizeiptr>(items.size() * sizeof(Item)),
                                                  items.data(), GL_STATIC_DRAW);
}

/// Depths between near and far planes that just hold the mesh, as a 24-bit buffer needs them.
struct DepthRange {
  float zNear = 1e30f;
  float zFar = 0;
};

DepthRange depthRangeOf(const PinholeCamera& camera, const Mesh& mesh) {
  DepthRange range;
  for (const glm::vec3& position : mesh.positions) {
    const float z = camera.cameraFromWorld(position).z;
    range.zNear = std::min(range.zNear, z);
    range.zFar = std::max(range.zFar, z);
  }
  return {std::max(range.zNear * 0.99f, camera.view().zNear), std::min(range.zFar * 1.01f, camera.view().zFar)};
}

}  // namespace

struct OsMesaRenderer::Impl {
  OSMesaContext context = nullptr;
  int width = 0;
  int height = 0;
  GLsizei indices = 0;
  DepthRange range;
  std::vector<uint8_t> frame;   ///< what OSMesa draws into
  std::vector<uint8_t> colors;  ///< read back
  std::vector<float> windowZ;   ///< read back, bottom row first

  ~Impl() {
    if (context != nullptr) {
      OSMesaDestroyContext(context);
    }
  }
};

OsMesaRenderer::OsMesaRenderer(const PinholeCamera& camera, const Mesh& mesh) : impl_(std::make_unique<Impl>()) {
  impl_->width = camera.width();
  impl_->height = camera.height();
  const size_t pixels = static_cast<size_t>(camera.width()) * static_cast<size_t>(camera.height());
  impl_->frame.resize(4 * pixels);
  impl_->colors.resize(4 * pixels);
  impl_->windowZ.resize(pixels);
  impl_->context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 0, 0, nullptr);
  if (impl_->context == nullptr || OSMesaMakeCurrent(impl_->context, impl_->frame.data(), GL_UNSIGNED_BYTE,
                                                     camera.width(), camera.height()) == GL_FALSE) {
    throw WorkError("no OpenGL context can be made", "OSMesa", "install libosmesa6");
  }

  std::array<GLuint, 3> buffers{};
  glFunction<PFNGLGENBUFFERSPROC>("glGenBuffers")(3, buffers.data());
  fillBuffer(GL_ARRAY_BUFFER, buffers[0], mesh.positions);
  glVertexPointer(3, GL_FLOAT, 0, nullptr);
  glEnableClientState(GL_VERTEX_ARRAY);
  if (!mesh.colors.empty()) {
    fillBuffer(GL_ARRAY_BUFFER, buffers[1], mesh.colors);
    glColorPointer(3, GL_FLOAT, 0, nullptr);
    glEnableClientState(GL_COLOR_ARRAY);
  }
  fillBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[2], mesh.triangles);
  impl_->indices = static_cast<GLsizei>(mesh.triangles.size() * 3);

  impl_->range = depthRangeOf(camera, mesh);
  const glm::dvec2 center(camera.centerPixels());
  const auto nearPerPixel = static_cast<double>(impl_->range.zNear / camera.focalPixels());
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
  glFrustum(-center.x * nearPerPixel, (camera.width() - center.x) * nearPerPixel,
            (center.y - camera.height()) * nearPerPixel, center.y * nearPerPixel, impl_->range.zNear,
            impl_->range.zFar);
  // OpenGL's eye space is (right, up, backward).
  glm::mat4 eyeFromWorld(1);
  const glm::vec3 origin = camera.cameraFromWorld(glm::vec3(0));
  for (int axis = 0; axis < 3; ++axis) {
    glm::vec3 unit(0);
    unit[axis] = 1;
    const glm::vec3 column = camera.cameraFromWorld(unit) - origin;
    eyeFromWorld[axis] = glm::vec4(column.x, -column.y, -column.z, 0);
  }
  eyeFromWorld[3] = glm::vec4(origin.x, -origin.y, -origin.z, 1);
  glMatrixMode(GL_MODELVIEW);
  glLoadMatrixf(glm::value_ptr(eyeFromWorld));
  glEnable(GL_DEPTH_TEST);
  glViewport(0, 0, camera.width(), camera.height());
}

OsMesaRenderer::~OsMesaRenderer() = default;

std::string OsMesaRenderer::name() const {
  return reinterpret_cast<const char*>(glGetString(GL_RENDERER));
}

void OsMesaRenderer::drawFrame() {
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glDrawElements(GL_TRIANGLES, impl_->indices, GL_UNSIGNED_INT, nullptr);
  glReadPixels(0, 0, impl_->width, impl_->height, GL_RGBA, GL_UNSIGNED_BYTE, impl_->colors.data());
  glReadPixels(0, 0, impl_->width, impl_->height, GL_DEPTH_COMPONENT, GL_FLOAT, impl_->windowZ.data());
}

Image<float> OsMesaRenderer::depths() const {
  Image<float> depths(impl_->width, impl_->height, 0);
  const float zNear = impl_->range.zNear;
  const float zFar = impl_->range.zFar;
  for (int y = 0; y < impl_->height; ++y) {
    for (int x = 0; x < impl_->width; ++x) {
      const float windowZ = impl_->windowZ[depths.index(x, impl_->height - 1 - y)];
      if (windowZ < 1) {
        depths(x, y) = zNear * zFar / (zFar - windowZ * (zFar - zNear));
      }
    }
  }
  return depths;
}

}  // namespace ocelli
