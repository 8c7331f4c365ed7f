#include "oc_core/multiperspective/multiperspective_image.h"

#include "oc_core/base/file_bytes.h"
#include "oc_core/constructor/curved_bends.h"
#include "oc_core/constructor/graph_operations.h"
#include "oc_core/image/color.h"
#include "oc_core/image/exr_writer.h"
#include "oc_core/render/identity_image.h"
#include "oc_core/render/rasterize_curved.h"
#include "oc_core/render/rasterize_graph.h"
#include "oc_core/render/raycast.h"

namespace ocelli {

glm::vec3 skyColor() {
  return linearFromSrgb(glm::vec3(0.80f, 0.88f, 0.95f));
}

FragmentImage rasterize(const MultiperspectiveCamera& camera, const Mesh& mesh) {
  return std::visit([&](const auto& each) { return rasterize(each, mesh); }, camera);
}

FragmentImage raycast(const MultiperspectiveCamera& camera, const Mesh& mesh) {
  return std::visit([&](const auto& each) { return raycast(each, mesh, RayScene(mesh)); }, camera);
}

FragmentImage draw(const MultiperspectiveCamera& camera, const SceneRenderer& renderer) {
  return std::visit([&](const auto& each) { return renderer.draw(each); }, camera);
}

void writeMultiperspectiveImage(const std::filesystem::path& path, const FragmentImage& fragments,
                                const GuidedScene& scene, const MultiperspectiveCamera& camera) {
  const Image<glm::vec3> color = colorImage(fragments, scene.mesh, glm::vec3(0));
  const Image<uint32_t> objects = identityImage(fragments, scene.objectOfTriangle);
  Image<glm::vec3> points(fragments.width(), fragments.height());
  for (size_t i = 0; i < fragments.size(); ++i) {
    if (fragments[i].covered()) {
      points[i] = positionOf(fragments[i], scene.mesh);
    }
  }
  const glm::vec3* c = color.data();
  const glm::vec3* p = points.data();
  const ExrPart part{"image",
                     fragments.width(),
                     fragments.height(),
                     {{"R", &c->x, sizeof(*c)},
                      {"G", &c->y, sizeof(*c)},
                      {"B", &c->z, sizeof(*c)},
                      {"Z", &fragments.data()->t, sizeof(Fragment)},
                      {"P.X", &p->x, sizeof(*p)},
                      {"P.Y", &p->y, sizeof(*p)},
                      {"P.Z", &p->z, sizeof(*p)},
                      {"object", objects.data(), sizeof(uint32_t), true}},
                     std::visit([](const auto& each) { return jsonText(each); }, camera)};
  writeFile(path, exrBytes({part}));
}

}  // namespace ocelli
