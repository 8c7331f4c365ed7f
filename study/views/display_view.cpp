// What an eye before a swept-screen volumetric display sees, simulated: a part of the scene ahead of the task's eye
// stands in the display, whole or as a representation holds it, and nothing hides anything (display_sim/observing).
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <memory>
#include <optional>

#include "display_sim/observing/observer.h"
#include "display_sim/slicing/slicer.h"
#include "oc_core/base/error.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/ocri/representation.h"
#include "oc_core/render/identity_image.h"
#include "study/task/trial_image.h"
#include "study/views/camera_field.h"
#include "study/views/made_view.h"
#include "study/views/shown_objects.h"
#include "study/views/view_registry.h"

namespace ocelli {
namespace {

constexpr double kMaxDistanceMeters = 100;
constexpr double kMaxRadiusMeters = 60;
/// So far from the display's centre, in its radii, the eye is outside of it, wherever it stands.
constexpr double kMinDistanceRadii = 1.5;
/// Of the light of a pixel that an object must give to be seen there.
constexpr float kOwnLightShare = 0.5f;

struct DisplayViewOptions {
  DisplayProfile profile;
  double distanceMeters = 6;  ///< from the eye to the display's centre
  double radiusMeters = 3;    ///< of the scene that the display's radius stands for
  std::optional<CameraChoice> camera{};
};

/// The display's coordinates for one eye: y up, the eye on the side of +z.
class DisplayFrame {
 public:
  DisplayFrame(const PinholeCamera& camera, const DisplayViewOptions& options)
      : center_(camera.eye() + static_cast<float>(options.distanceMeters) * camera.forward()),
        radius_(static_cast<float>(options.radiusMeters)),
        right_(glm::normalize(glm::cross(camera.forward(), glm::vec3(0, 1, 0)))),
        back_(glm::cross(right_, glm::vec3(0, 1, 0))) {}

  glm::vec3 fromWorld(const glm::vec3& point) const {
    const glm::vec3 p = (point - center_) / radius_;
    return {glm::dot(p, right_), p.y, glm::dot(p, back_)};
  }

 private:
  glm::vec3 center_;
  float radius_;
  glm::vec3 right_;
  glm::vec3 back_;
};

/// The triangles whose object is `object`, or all where there is none.
Mesh partOf(const Mesh& mesh, const std::vector<uint32_t>& objects, uint32_t object) {
  Mesh part = mesh;
  part.triangles.clear();
  for (size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (objects[i] == object) {
      part.triangles.push_back(mesh.triangles[i]);
    }
  }
  return part;
}

class DisplayView final : public MadeView {
 public:
  explicit DisplayView(DisplayViewOptions options) : options_(std::move(options)) {}

 private:
  std::shared_ptr<const ShownContent> make(const TrialLayout& layout, const PinholeCamera& camera) const override {
    ShownImage shown;
    shown.objects = Image<uint32_t>(camera.width(), camera.height(), kNothing);
    shown.positions = Image<glm::vec3>(camera.width(), camera.height(), glm::vec3(0));
    Mesh mesh;
    try {
      mesh = options_.camera ? buildRepresentation(*options_.camera, camera, meshOf(layout)).mesh : meshOf(layout);
    } catch (const InputError&) {
      // Where the representation cannot be made, as the eye would lie within a wall, the display stays dark.
    }
    const std::vector<uint32_t> objects =
        options_.camera ? ShownObjects(layout).ofTriangles(mesh) : layout.scene->objectOfTriangle();
    const DisplayFrame frame(camera, options_);
    for (glm::vec3& position : mesh.positions) {
      position = frame.fromWorld(position);
    }
    ObserverOptions observer;
    observer.eye = frame.fromWorld(camera.eye());
    observer.width = camera.width();
    observer.height = camera.height();
    observer.fovVerticalDegrees = camera.view().resolvedFovVerticalDegrees();
    Image<glm::vec3> light = lightOf(mesh, observer);
    for (size_t i = 0; i < layout.scene->objectCount(); ++i) {
      const auto object = static_cast<uint32_t>(i + 1);
      const Image<glm::vec3> own = lightOf(partOf(mesh, objects, object), observer);
      const Box& box = layout.scene->boxOf(i);
      const glm::vec3 offset = i < layout.objectOffsets.size() ? layout.objectOffsets[i] : glm::vec3(0);
      for (size_t pixel = 0; pixel < own.size(); ++pixel) {
        const float all = light[pixel].x + light[pixel].y + light[pixel].z;
        if (all > 0 && own[pixel].x + own[pixel].y + own[pixel].z >= kOwnLightShare * all) {
          shown.objects[pixel] = object;
          shown.positions[pixel] = (box.lower + box.upper) / 2.0f + offset;
        }
      }
    }
    applyTone(light, {.gain = automaticGain(light)});
    shown.pixels = srgbFromLinear(light);
    return std::make_shared<const ShownContent>(std::move(shown));
  }

  Image<glm::vec3> lightOf(const Mesh& mesh, const ObserverOptions& observer) const {
    if (mesh.empty()) {
      return {observer.width, observer.height, glm::vec3(0)};
    }
    return collectLight(slice(mesh, options_.profile), observer);
  }

  DisplayViewOptions options_;
};

/// A database holds all that its trials show: no profile stands in a file beside it.
DisplayProfile readProfileField(JsonFields& fields) {
  const nlohmann::json& value = fields.value("profile");
  if (value.is_object()) {
    return profileFromJsonText(value.dump(), fmt::format("{}, \"profile\"", fields.where()));
  }
  const std::vector<std::string>& names = builtinProfileNames();
  if (!value.is_string() || std::find(names.begin(), names.end(), value.get<std::string>()) == names.end()) {
    fields.fail("profile", fmt::format("must be one of {}, or an object with a profile", fmt::join(names, ", ")));
  }
  return loadProfile(value.get<std::string>());
}

std::shared_ptr<const SceneView> readDisplayView(JsonFields& fields) {
  DisplayViewOptions options{.profile = loadProfile("perspecta")};
  if (fields.has("profile")) {
    options.profile = readProfileField(fields);
  }
  options.distanceMeters = fields.number("distance_meters", 0.1, kMaxDistanceMeters, options.distanceMeters);
  options.radiusMeters = fields.number("radius_meters", 0.01, kMaxRadiusMeters, options.radiusMeters);
  const double corner = std::max(kMinDistanceRadii, std::hypot(1.0, options.profile.halfHeightRadii) + 0.01);
  if (options.distanceMeters < corner * options.radiusMeters) {
    fields.fail("distance_meters", fmt::format("is {:g}, but must be {:.2f} times \"radius_meters\", which is {:g}, so "
                                               "that the eye is outside of the display",
                                               options.distanceMeters, corner, options.radiusMeters));
  }
  if (fields.has("camera")) {
    options.camera = readCameraField(fields);
  }
  return std::make_shared<DisplayView>(std::move(options));
}

}  // namespace

ViewKind displayViewKind() {
  return {"display", "what an eye before a volumetric display sees, simulated", readDisplayView};
}

}  // namespace ocelli
