#include "oc_core/shade/perspective_images.h"

#include "oc_core/base/error.h"
#include "oc_core/constructor/camera_constructors.h"
#include "oc_core/multiperspective/multiperspective_image.h"
#include "oc_core/ocri/placed_image.h"

namespace ocelli {

ReferenceImage PerspectiveImage::samples(const Mesh& mesh, const std::string& name) const {
  return std::visit(
      [&](const auto& some) { return placedImage(some, fragments, mesh, referenceOf(some).view(), name); }, camera);
}

PerspectiveImage perspectiveImage(const std::string& nameOrFile, const GuidedScene& scene, const Mesh& mesh,
                                  const PinholeCamera& reference) {
  const glm::ivec2 size = sizeInFile(nameOrFile).value_or(glm::ivec2(reference.width(), reference.height()));
  PerspectiveImage image{constructCamera(nameOrFile, scene, {reference.view(), size.x, size.y}), {}};
  image.fragments = rasterize(image.camera, mesh);
  return image;
}

const GraphCamera& graphCameraOf(const PerspectiveImage& image, const std::string& nameOrFile) {
  const GraphCamera* camera = std::get_if<GraphCamera>(&image.camera);
  if (camera == nullptr) {
    throw InputError("this is a curved ray camera, which has no frusta to walk through", nameOrFile,
                     "give its name alone: rays then hit its samples");
  }
  return *camera;
}

}  // namespace ocelli
