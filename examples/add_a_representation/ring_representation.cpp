#include "ring_representation.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "oc_core/ocri/camera_option.h"
#include "oc_core/ocri/set_difference.h"

using namespace ocelli;

namespace {

/// An option of its own, for forms, and for camera files: {"camera": "ring-8", "ring_elevation_degrees": 30}.
const CameraOption kElevation{
    .name = "ring_elevation_degrees",
    .label = "elevation",
    .unit = "degrees",
    .meaning = "How far the eyes of the ring stand above that of the reference view",
    .place = [](CameraChoice& choice) -> float& { return choice.ownOptions["ring_elevation_degrees"]; },
    .min = -60,
    .max = 60,
    .formMin = -60,
    .formMax = 60};

/// The reference view, turned about the vertical through its target, and raised.
View eyeOfRing(const View& reference, double turnRadians, double elevationRadians) {
  const glm::vec3 up = glm::normalize(reference.up);
  const glm::vec3 fromTarget = reference.eye - reference.target;
  const glm::vec3 right = glm::cross(up, fromTarget);
  const glm::mat4 raised = glm::rotate(glm::mat4(1), float(-elevationRadians), right);
  const glm::mat4 turnedAndRaised = glm::rotate(glm::mat4(1), float(turnRadians), up) * raised;
  View view = reference;
  view.eye = reference.target + glm::vec3(turnedAndRaised * glm::vec4(fromTarget, 0));
  return view;
}

ReferenceImages ringImages(const RepresentationInputs& in) {
  const double elevation = radiansFromDegrees(numberOf(kElevation, in.choice));
  ReferenceImages images;
  for (int i = 0; i < in.choice.count; ++i) {
    const double turn = 2 * kPi * i / in.choice.count;
    const View view = i == 0 ? in.reference.view() : eyeOfRing(in.reference.view(), turn, elevation);
    const PinholeCamera camera(view, in.reference.width(), in.reference.height());
    ReferenceImage image = buildDepthImage(camera, in.mesh, in.renderer);
    for (const ReferenceImage& before : images) {
      subtract(image, before, [other = before.reference()](const glm::vec3& point) { return other.project(point); });
    }
    images.push_back(std::move(image));
  }
  return images;
}

}  // namespace

RepresentationKind ringRepresentation() {
  return {.name = "ring-6",
          .description = "depth images from six eyes all round the scene (any number from ring-1 to ring-16)",
          .options = {&kElevation},
          .prepare = [](CameraChoice& choice) { choice.count = 6; },
          .maxCount = 16,
          .images = ringImages};
}
