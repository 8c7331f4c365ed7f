// A representation of the scene, such as the mesh of an occlusion camera's reference image, seen from an eye that has
// moved away from where it was made (section 3.5.5): what a display shows that holds nothing but that mesh.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "oc_core/base/json_fields.h"
#include "oc_core/ocri/representation.h"
#include "study/task/trial_image.h"
#include "study/views/camera_field.h"
#include "study/views/made_view.h"
#include "study/views/shown_objects.h"
#include "study/views/view_registry.h"

namespace ocelli {
namespace {

constexpr double kMaxEyeOffset = 10;  // metres
constexpr float kMinCellSide = 0.2f;  // metres, where the eye hardly moves
constexpr double kMaxImageScale = 4;

/// Made anew wherever the eye goes, and whenever an object moves.
class OcriView final : public MadeView {
 public:
  OcriView(CameraChoice choice, const glm::vec3& eyeOffset, double imageScale)
      : choice_(std::move(choice)), eyeOffset_(eyeOffset), imageScale_(imageScale) {}

 private:
  /// What the representation is built from.
  PinholeCamera referenceOf(const PinholeCamera& camera) const {
    const auto scaled = [&](int pixels) { return std::max(1, static_cast<int>(std::lround(imageScale_ * pixels))); };
    return {camera.view(), scaled(camera.width()), scaled(camera.height())};
  }
  /// It goes on looking into the same direction.
  PinholeCamera eyeOf(const PinholeCamera& camera) const override {
    View view = camera.view();
    const glm::vec3 by = eyeOffset_.x * camera.right() - eyeOffset_.y * camera.down() - eyeOffset_.z * camera.forward();
    view.eye += by;
    view.target += by;
    return {view, camera.width(), camera.height()};
  }
  /// Where the representation cannot be made, as its eye would lie within a wall, there is nothing to see.
  std::shared_ptr<const ShownContent> make(const TrialLayout& layout, const PinholeCamera& pinhole) const override {
    ShownMesh shown;
    try {
      shown.mesh = buildRepresentation(choice_, referenceOf(pinhole), meshOf(layout)).mesh;
    } catch (const InputError&) {
      shown.mesh = {};
    }
    shown.objectOfTriangle = ShownObjects(layout).ofTriangles(shown.mesh);
    return std::make_shared<const ShownContent>(std::move(shown));
  }

  CameraChoice choice_;
  glm::vec3 eyeOffset_;  ///< right, up and backward in the view, metres
  double imageScale_;
};

std::shared_ptr<const SceneView> readOcriView(JsonFields& fields) {
  const std::vector<double> offset = fields.numbers("eye_offset_meters", 3, -kMaxEyeOffset, kMaxEyeOffset);
  const glm::vec3 eyeOffset(offset[0], offset[1], offset[2]);
  // A cell that just holds the moved eye; a representation's own option says otherwise.
  ViewCell cell;
  cell.sideRadii = std::max(kMinCellSide, 2 * glm::length(eyeOffset));
  const double imageScale = fields.number("image_scale", 0.25, kMaxImageScale, 1);
  return std::make_shared<OcriView>(readCameraField(fields, cell), eyeOffset, imageScale);
}

}  // namespace

ViewKind ocriViewKind() {
  return {"ocri", "the mesh of a representation, such as an OCRI's, seen from an eye that has moved", readOcriView};
}

}  // namespace ocelli
