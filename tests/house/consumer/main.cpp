// Puts a point into an image and back with the installed library.
#include <cstdio>
#include <glm/geometric.hpp>

#include "oc_core/base/png_file.h"
#include "oc_core/camera/pinhole_camera.h"
#include "oc_core/scene/mesh.h"

int main() {
  const ocelli::PinholeCamera camera(ocelli::View{}, 720, 480);
  const glm::vec3 point(0.25f, -0.5f, 0.125f);
  const auto image = camera.project(point);
  const auto back = image ? camera.unproject(*image) : std::nullopt;
  // The origin is the centre of the default view.
  const auto center = camera.project({0, 0, 0});
  const bool good = back && glm::distance(*back, point) < 1e-4f && center && center->u == 360 && center->v == 240;
  ocelli::writePng("consumer.png", ocelli::Image<ocelli::Rgb8>(2, 2));
  ocelli::Box box;
  box.add(point);
  std::printf("the installed package %s\n", good && !box.empty() ? "works" : "does not work");
  return good ? 0 : 1;
}
