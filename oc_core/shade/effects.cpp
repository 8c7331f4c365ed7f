#include "oc_core/shade/effects.h"

#include "oc_core/base/error.h"
#include "oc_core/ocri/camera_choice.h"
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

std::vector<std::string> offeredWays(const Effect& effect) {
  std::vector<std::string> ways;
  if (effect.waysToOffer != nullptr) {
    ways = effect.waysToOffer();
  } else {
    for (const CameraName& camera : cameraNames()) {
      try {
        effect.checkWay(camera.name);
        ways.emplace_back(camera.name);
      } catch (const InputError&) {  // none of its ways
      }
    }
  }
  ways.emplace_back(kTraced);
  return ways;
}

}  // namespace ocelli
