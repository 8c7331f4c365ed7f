#include "oc_core/ocri/corner_depth_images.h"

#include "oc_core/base/error.h"

namespace ocelli {

ReferenceImages buildCornerDepthImages(const PinholeCamera& reference, const Mesh& mesh, const ViewCell& cell,
                                       int corners, const SceneRenderer* renderer) {
  if (corners != 4 && corners != 8) {
    throw InputError("a cube has no choice of " + std::to_string(corners) + " corners to look from", "corners",
                     "choose 4 (those towards the scene) or 8");
  }
  if (cell.shape != ViewCell::Shape::kCube) {
    throw InputError("a view cell that is a " + cellShapeName(cell.shape) + " has no corners to look from", "--cell",
                     "choose a cube");
  }
  const float half = cell.halfSide();
  ReferenceImages images{buildDepthImage(reference, mesh, renderer)};
  for (const float backward : {-half, half}) {
    for (const float up : {-half, half}) {
      for (const float right : {-half, half}) {
        if (static_cast<int>(images.size()) <= corners) {
          const View view = movedEye(reference.view(), {right, up, backward});
          images.push_back(buildDepthImage(PinholeCamera(view, reference.width(), reference.height()), mesh, renderer));
        }
      }
    }
  }
  return images;
}

}  // namespace ocelli
