// What `ocelli shade` draws: an effect is a row of a table, which says where its rays come from.
#pragma once

#include <string>
#include <vector>

#include "oc_core/shade/secondary_rays.h"

namespace ocelli {

struct Effect {
  const char* name;
  const char* description;
  /// The objects that send rays on: the reference image is made for the middle of them.
  const std::vector<SpecularObject>& (*senders)(const ShadedScene& scene);
  SecondaryRays (*rays)(const ShadedScene& scene, const PinholeCamera& camera);
};

/// In the order of lists.
const std::vector<Effect>& shadeEffects();

/// Throws InputError that lists them for another name.
const Effect& shadeEffect(const std::string& name);

/// Throws InputError where no object of the scene has the role that the effect needs.
void requireSenders(const Effect& effect, const ShadedScene& scene);

/// Its rays. Throws as requireSenders() does, and where the picture shows none of those objects.
SecondaryRays raysOf(const Effect& effect, const ShadedScene& scene, const PinholeCamera& camera);

}  // namespace ocelli
