#include "oc_core/sea_input/hidden_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <memory>
#include <numbers>

#include "oc_core/base/error.h"
#include "oc_core/ocri/camera_choice.h"
#include "oc_core/ocri/representation_kind.h"
#include "oc_core/render/raycast.h"

namespace ocelli {
namespace {

struct Face {
  glm::vec3 direction;
  glm::vec3 up;
};
constexpr std::array<Face, 6> kFaces{{{{0, 0, -1}, {0, 1, 0}},
                                      {{1, 0, 0}, {0, 1, 0}},
                                      {{0, 0, 1}, {0, 1, 0}},
                                      {{-1, 0, 0}, {0, 1, 0}},
                                      {{0, 1, 0}, {0, 0, 1}},
                                      {{0, -1, 0}, {0, 0, -1}}}};
constexpr double kFaceDegrees = 90;

View viewOf(const Face& face, const SeaPose& pose) {
  const glm::quat worldFromCamera(pose.worldFromCamera);
  View view;
  view.eye = glm::vec3(pose.position);
  view.target = view.eye + worldFromCamera * face.direction;
  view.up = worldFromCamera * face.up;
  view.fovVerticalDegrees = kFaceDegrees;
  return view;
}

/// Some kinds of image throw where a face sees nothing: those have no points.
bool seesAnything(const PinholeCamera& camera, const Mesh& mesh) {
  const ReferenceImage image = buildDepthImage(camera, mesh);
  return image.sampleCount() > 0;
}

void addPoints(const ReferenceImage& image, std::vector<glm::vec3>& points) {
  const PinholeCamera pinhole = image.reference();
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      if (const auto point = image.pointOf(x, y, pinhole)) {
        points.push_back(*point);
      }
    }
  }
}

}  // namespace

int faceSideFor(const SeaProjection& projection) {
  // At the middle of a face of 90 degrees pixels are 2 / side apart.
  constexpr int kMinSide = 8;
  constexpr int kMaxSide = 2048;
  const double angle = projection.wraps()
                           ? std::min(2 * std::numbers::pi / projection.width, std::numbers::pi / projection.height)
                           : projection.pixelAngle();
  return std::clamp(static_cast<int>(std::ceil(2 / angle)), kMinSide, kMaxSide);
}

HiddenPoints hiddenPointsOf(const std::string& kind, int side) {
  const auto row = findRepresentation(kind);
  if (!row || !row->kind->images) {
    throw InputError("no kind of reference image is called \"" + kind + "\"", "--hidden",
                     "give none, ddoc, cell, ldi-2, or another one that `ocelli camera list` has");
  }
  return [kind, side](const Mesh& proxy, const SeaPose& pose, double reach) {
    std::vector<glm::vec3> points;
    if (proxy.empty()) {
      return points;
    }
    // A proxy ends anywhere, and says nothing of what is inside of objects.
    Mesh part = proxy;
    part.isPart = true;
    const CameraChoice choice = cameraChoice(kind, {.sideRadii = static_cast<float>(2 * reach)});
    for (const Face& face : kFaces) {
      const PinholeCamera camera(viewOf(face, pose), side, side);
      if (!seesAnything(camera, part)) {
        continue;
      }
      for (const ReferenceImage& image : buildReferenceImages(choice, camera, part)) {
        addPoints(image, points);
      }
    }
    return points;
  };
}

HiddenPoints hiddenPointsOf(const SeaSettings& settings) {
  return settings.hasHidden() ? hiddenPointsOf(settings.hidden, faceSideFor(settings.projection)) : HiddenPoints{};
}

}  // namespace ocelli
