// The image of any camera at the eye, as it is: of an occlusion camera the reference image itself, of a panorama all
// that is around.
#include <memory>

#include "oc_core/base/error.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/multiperspective/multiperspective_image.h"
#include "oc_core/ocri/camera_choice.h"
#include "oc_core/render/identity_image.h"
#include "study/task/trial_image.h"
#include "study/views/camera_field.h"
#include "study/views/made_view.h"
#include "study/views/shown_objects.h"
#include "study/views/view_registry.h"

namespace ocelli {
namespace {

class CameraView final : public MadeView {
 public:
  explicit CameraView(CameraChoice choice) : choice_(std::move(choice)) {}

 private:
  std::shared_ptr<const ShownContent> make(const TrialLayout& layout, const PinholeCamera& camera) const override {
    Image<glm::vec3> color(camera.width(), camera.height(), skyColor());
    ShownImage shown;
    shown.objects = Image<uint32_t>(camera.width(), camera.height(), kNothing);
    shown.positions = Image<glm::vec3>(camera.width(), camera.height(), glm::vec3(0));
    try {
      const ReferenceImage image = buildReferenceImages(choice_, camera, meshOf(layout)).front();
      sample(image, ShownObjects(layout), color, shown);
    } catch (const InputError&) {
      // Where the image cannot be made, as the eye would lie within a wall, there is nothing to see.
    }
    shown.pixels = srgbFromLinear(color);
    return std::make_shared<const ShownContent>(std::move(shown));
  }
  /// An image of another size fills the place; the nearest sample shows.
  static void sample(const ReferenceImage& image, const ShownObjects& objects, Image<glm::vec3>& color,
                     ShownImage& shown) {
    const PinholeCamera pinhole = image.reference();
    for (int y = 0; y < color.height(); ++y) {
      for (int x = 0; x < color.width(); ++x) {
        const int u = (2 * x + 1) * image.width() / (2 * color.width());
        const int v = (2 * y + 1) * image.height() / (2 * color.height());
        if (const std::optional<glm::vec3> point = image.pointOf(u, v, pinhole)) {
          color(x, y) = image.color(u, v);
          shown.objects(x, y) = objects.at(*point);
          shown.positions(x, y) = *point;
        }
      }
    }
  }

  CameraChoice choice_;
};

std::shared_ptr<const SceneView> readCameraView(JsonFields& fields) {
  const CameraChoice choice = readCameraField(fields);
  if (!choice.hasImages()) {
    fields.fail("camera", "is a mesh and has no image: show it by the view \"ocri\"");
  }
  return std::make_shared<CameraView>(choice);
}

}  // namespace

ViewKind cameraViewKind() {
  return {"camera", "the image of any camera at the eye, as it is", readCameraView};
}

}  // namespace ocelli
