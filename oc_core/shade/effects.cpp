#include "oc_core/shade/effects.h"

#include "oc_core/base/error.h"
#include "oc_core/shade/ambient_effect.h"
#include "oc_core/shade/relief_effect.h"
#include "oc_core/shade/shadow_effect.h"
#include "oc_core/shade/specular_effect.h"

namespace ocelli {

const std::vector<Effect>& shadeEffects() {
  static const std::vector<Effect> effects{reflectionEffect(), refractionEffect(), reliefEffect(), ambientEffect(),
                                           shadowEffect()};
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

}  // namespace ocelli
