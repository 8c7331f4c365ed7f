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

/// Whether the box of the triangle reaches into that of the display.
bool touchesDisplay(const Mesh& mesh, const glm::uvec3& triangle, const DisplayProfile& profile) {
  Box box;
  for (int i = 0; i < 3; ++i) {
    box.add(mesh.positions[triangle[i]]);
  }
  const glm::vec3 half(1, static_cast<float>(profile.halfHeightRadii), 1);
  return glm::all(glm::lessThanEqual(box.lower, half)) && glm::all(glm::greaterThanEqual(box.upper, -half));
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
      objectCount_(layout.scene->objectCount()),
      objects_(layout),
      camera_(camera),
      frame_(camera, options),
      rest_(frame_.fromWorld(camera.eye())) {
  mesh_ = meshOf(layout);
  for (glm::vec3& position : mesh_.positions) {
    position = frame_.fromWorld(position);
  }
  const std::vector<uint32_t>& objects = layout.scene->objectOfTriangle();
  const std::vector<glm::uvec3> all = std::move(mesh_.triangles);
  mesh_.triangles.clear();
  for (size_t i = 0; i < all.size(); ++i) {
    if (touchesDisplay(mesh_, all[i], options.profile)) {
      mesh_.triangles.push_back(all[i]);
      objectOf_.push_back(objects[i]);
    }
  }
}

Mesh DisplayLight::representationMadeAt(const glm::vec3& eye) const {
  // It looks at the centre and just holds the display.
  View view;
  view.eye = eye;
  view.target = glm::vec3(0);
  const int side = std::min(camera_.width(), camera_.height());
  try {
    return buildRepresentation(*options_.camera, PinholeCamera(view, side, side), mesh_).mesh;
  } catch (const InputError&) {
    return {};  // where it cannot be made the display stays dark
  }
}

DisplayLight::Volumes DisplayLight::volumesMadeAt(const glm::vec3& eye) const {
  const Mesh mesh = options_.camera ? representationMadeAt(eye) : mesh_;
  std::vector<uint32_t> objects = objectOf_;
  if (options_.camera) {
    Mesh inWorld = mesh;
    for (glm::vec3& position : inWorld.positions) {
      position = frame_.toWorld(position);
    }
    objects = objects_.ofTriangles(inWorld);
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
  if (!volumes_ || (isForEach() && madeAt_ != pose)) {
    volumes_ = volumesMadeAt(isForEach() ? eyeAt(pose) : rest_);
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
  const glm::vec3 eye = eyeAt(pose);
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
  const Image<glm::vec3> light = lightOf(isForEach() ? volumesMadeAt(rest_).front() : volumesAt(0).front(), rest_);
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
