#include "study/views/display_light.h"

#include <algorithm>

#include "display_sim/observing/observer.h"
#include "display_sim/slicing/slicer.h"
#include "oc_core/base/error.h"
#include "oc_core/ocri/representation.h"
#include "oc_core/render/identity_image.h"
#include "study/task/trial_image.h"

namespace ocelli {
namespace {

/// Of the light of a pixel that an object must give to be seen there.
constexpr float kOwnLightShare = 0.5f;
/// Of linear light, as sRGB has it.
constexpr glm::dvec3 kLuminance{0.2126, 0.7152, 0.0722};

/// The triangles whose object is `object`.
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

float sumOf(const glm::vec3& light) {
  return light.x + light.y + light.z;
}

double meanLuminance(const Image<glm::vec3>& light, double gain) {
  double sum = 0;
  for (const glm::vec3& pixel : light) {
    sum += glm::dot(kLuminance, glm::min(gain * glm::dvec3(pixel), glm::dvec3(1)));
  }
  return sum / static_cast<double>(std::max<size_t>(light.size(), 1));
}

}  // namespace

DisplayLight::DisplayLight(const DisplayViewOptions& options, const TrialLayout& layout, const PinholeCamera& camera)
    : options_(options),
      mesh_(meshOf(layout)),
      objectOf_(layout.scene->objectOfTriangle()),
      objectCount_(layout.scene->objectCount()),
      objects_(layout),
      camera_(camera),
      frame_(camera, options) {}

PinholeCamera DisplayLight::cameraAt(size_t pose) const {
  View view = camera_.view();
  view.eye = frame_.toWorld(options_.head.eyeOf(pose, frame_.fromWorld(camera_.eye())));
  view.target = frame_.center();
  return {view, camera_.width(), camera_.height()};
}

DisplayLight::Volumes DisplayLight::volumesMadeAt(const PinholeCamera& camera) const {
  Mesh mesh;
  try {
    mesh = options_.camera ? buildRepresentation(*options_.camera, camera, mesh_).mesh : mesh_;
  } catch (const InputError&) {
    // Where the representation cannot be made, as the eye would lie within a wall, the display stays dark.
  }
  const std::vector<uint32_t> objects = options_.camera ? objects_.ofTriangles(mesh) : objectOf_;
  for (glm::vec3& position : mesh.positions) {
    position = frame_.fromWorld(position);
  }
  const auto sliced = [&](const Mesh& part) {
    return part.empty() ? std::nullopt : std::optional(slice(part, options_.profile));
  };
  Volumes volumes;
  volumes.push_back(sliced(mesh));
  for (size_t i = 0; i < objectCount_; ++i) {
    volumes.push_back(sliced(partOf(mesh, objects, static_cast<uint32_t>(i + 1))));
  }
  return volumes;
}

const DisplayLight::Volumes& DisplayLight::volumesAt(size_t pose) {
  const bool isForEach = options_.camera && options_.head.moves() && options_.madeAt == MadeAt::kEach;
  if (!volumes_ || (isForEach && madeAt_ != pose)) {
    volumes_ = volumesMadeAt(isForEach ? cameraAt(pose) : camera_);
    madeAt_ = pose;
  }
  return *volumes_;
}

Image<glm::vec3> DisplayLight::lightOf(const std::optional<Volume>& volume, const glm::vec3& eye) const {
  if (!volume) {
    return {camera_.width(), camera_.height(), glm::vec3(0)};
  }
  ObserverOptions observer;
  observer.eye = eye;
  observer.width = camera_.width();
  observer.height = camera_.height();
  observer.fovVerticalDegrees = camera_.view().resolvedFovVerticalDegrees();
  return collectLight(*volume, observer);
}

DisplayLight::Seen DisplayLight::at(size_t pose) {
  const Volumes& volumes = volumesAt(pose);
  const glm::vec3 eye = options_.head.eyeOf(pose, frame_.fromWorld(camera_.eye()));
  Seen seen{lightOf(volumes.front(), eye), Image<uint32_t>(camera_.width(), camera_.height(), kNothing)};
  for (size_t object = 1; object < volumes.size(); ++object) {
    const Image<glm::vec3> own = lightOf(volumes[object], eye);
    for (size_t pixel = 0; pixel < own.size(); ++pixel) {
      const float all = sumOf(seen.light[pixel]);
      if (all > 0 && sumOf(own[pixel]) >= kOwnLightShare * all) {
        seen.objects[pixel] = static_cast<uint32_t>(object);
      }
    }
  }
  return seen;
}

double DisplayLight::gain() {
  const glm::vec3 rest = frame_.fromWorld(camera_.eye());
  const bool isForEach = options_.camera && options_.head.moves() && options_.madeAt == MadeAt::kEach;
  const Image<glm::vec3> light =
      isForEach ? lightOf(volumesMadeAt(camera_).front(), rest) : lightOf(volumesAt(0).front(), rest);
  return options_.meanLuminance ? gainForMean(light, *options_.meanLuminance) : automaticGain(light);
}

double gainForMean(const Image<glm::vec3>& light, double mean) {
  size_t lit = 0;
  double lower = 0;
  double upper = 1;
  double reachable = 0;
  for (const glm::vec3& pixel : light) {
    lit += sumOf(pixel) > 0 ? 1 : 0;
    reachable += glm::dot(kLuminance, glm::dvec3(glm::greaterThan(pixel, glm::vec3(0))));
  }
  if (lit == 0) {
    return 1;
  }
  const double wanted = std::min(mean, 0.99 * reachable / static_cast<double>(light.size()));
  while (meanLuminance(light, upper) < wanted) {
    upper *= 2;
  }
  constexpr int kHalvings = 50;  // to the last bits of a double
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = (lower + upper) / 2;
    (meanLuminance(light, middle) < wanted ? lower : upper) = middle;
  }
  return upper;
}

}  // namespace ocelli
