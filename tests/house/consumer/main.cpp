// Puts a point into an image and back, and reads a scene, with the installed library. The argument is where to write
// the scene.
#include <cstdio>
#include <fstream>
#include <glm/geometric.hpp>

#include "oc_core/camera/pinhole_camera.h"
#include "oc_core/image/png_file.h"
#include "oc_core/scene/mesh.h"
#include "oc_core/worlds/scene_source.h"
#ifdef WITH_OPENGL
#include "oc_core/window/gl_report.h"
#include "oc_core/window/gui_layer.h"
#endif

namespace {

#ifdef WITH_OPENGL
/// Links all that OpenGL needs, and draws panels where a context can be opened.
bool openGlIsThere() {
  const auto reports = ocelli::reportGlProviders();
  if (reports[0].info) {
    const auto context = ocelli::openGlContext(reports[0].provider);
    return !ocelli::GuiLayer(*context, 1).fontName().empty();
  }
  return reports.size() == 3;
}
#else
bool openGlIsThere() {
  return true;
}
#endif

}  // namespace

int main(int, char** arguments) {
  const ocelli::PinholeCamera camera(ocelli::View{}, 720, 480);
  const glm::vec3 point(0.25f, -0.5f, 0.125f);
  const auto image = camera.project(point);
  const auto back = image ? camera.unproject(*image) : std::nullopt;
  // The origin is the centre of the default view.
  const auto center = camera.project({0, 0, 0});
  bool good = back && glm::distance(*back, point) < 1e-4f && center && center->u == 360 && center->v == 240;
  ocelli::writePng("consumer.png", ocelli::Image<ocelli::Rgb8>(2, 2));
  ocelli::Box box;
  box.add(point);
  std::ofstream(arguments[1]) << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  good = good && !box.empty() && openGlIsThere() && ocelli::loadScene(arguments[1]).triangles.size() == 1;
  std::printf("the installed package %s\n", good ? "works" : "does not work");
  return good ? 0 : 1;
}
