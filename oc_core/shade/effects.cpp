#include "oc_core/shade/effects.h"

#include "oc_core/base/error.h"

namespace ocelli {

const std::vector<Effect>& shadeEffects() {
  static const std::vector<Effect> effects{
      {"reflection", "what objects with the role \"mirror\" reflect, at first order",
       [](const ShadedScene& scene) -> const std::vector<SpecularObject>& { return scene.mirrors; }, reflectedRays},
      {"refraction", "what is seen through objects with the role \"refract\"",
       [](const ShadedScene& scene) -> const std::vector<SpecularObject>& { return scene.lenses; }, refractedRays},
  };
  return effects;
}

const Effect& shadeEffect(const std::string& name) {
  std::string known;
  for (const Effect& effect : shadeEffects()) {
    if (effect.name == name) {
      return effect;
    }
    known += (known.empty() ? "" : ", ") + std::string(effect.name);
  }
  throw InputError("there is no effect \"" + name + "\"", "--effect", "one of " + known);
}

void requireSenders(const Effect& effect, const ShadedScene& scene) {
  if (effect.senders(scene).empty()) {
    throw InputError("no object of this scene has the role that this effect needs",
                     "--effect " + std::string(effect.name),
                     "give one that role with --roles FILE.json, or choose another effect");
  }
}

SecondaryRays raysOf(const Effect& effect, const ShadedScene& scene, const PinholeCamera& camera) {
  requireSenders(effect, scene);
  SecondaryRays rays = effect.rays(scene, camera);
  if (rays.rays.empty()) {
    throw InputError("the picture shows nothing of what mirrors or refracts", "--view",
                     "move the eye, or leave --view out");
  }
  return rays;
}

}  // namespace ocelli
