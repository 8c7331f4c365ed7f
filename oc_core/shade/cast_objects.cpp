#include "oc_core/shade/cast_objects.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "oc_core/base/error.h"

namespace ocelli {

CastObjects castObjects(const ShadedScene& scene, const SpecularObject* sender) {
  const auto isAmongThem = [&](const SpecularObject& mirror) { return mirror.isCast && &mirror != sender; };
  if (std::none_of(scene.mirrors.begin(), scene.mirrors.end(), isAmongThem)) {
    return {.mesh = {std::shared_ptr<void>(), &scene.cast}};
  }
  if (scene.mirrors.size() > kMaxCastMirrors) {
    throw InputError("more than " + std::to_string(kMaxCastMirrors) + " objects mirror, and some of them are cast",
                     scene.source, "take away the role \"mirror\" or \"cast\" of some");
  }
  auto mesh = std::make_shared<Mesh>(scene.cast);
  CastObjects cast;
  for (size_t i = 0; i < scene.mirrors.size(); ++i) {
    const SpecularObject& mirror = scene.mirrors[i];
    if (!isAmongThem(mirror)) {
      continue;
    }
    cast.mirrorNormals.resize(mesh->positions.size(), glm::vec3(0));
    for (const glm::vec3& normal : mirror.normals) {
      cast.mirrorNormals.push_back(normal * std::exp2(static_cast<float>(i)));
    }
    append(*mesh, mirror.mesh);
  }
  cast.mesh = std::move(mesh);
  return cast;
}

std::optional<MetMirror> metMirror(const glm::vec3& mirrorNormal) {
  const float length = glm::length(mirrorNormal);
  const float half = std::sqrt(0.5f);  // of a factor of 2
  if (!(length > half)) {
    return std::nullopt;
  }
  return MetMirror{static_cast<uint32_t>(std::max(std::lround(std::log2(length)), 0l)), mirrorNormal / length};
}

glm::vec3 reflectedAt(const MetMirror& met, const glm::vec3& direction) {
  return glm::normalize(glm::reflect(direction, met.normal));
}

}  // namespace ocelli
