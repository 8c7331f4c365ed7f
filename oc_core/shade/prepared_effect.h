// An effect in a scene, ready to be drawn: from what a user asks for to its stage.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "oc_core/shade/effects.h"

namespace ocelli {

struct EffectRequest {
  std::string source;             ///< of the scene (scene_source.h)
  std::string effect;             ///< a name of shadeEffects()
  std::vector<std::string> ways;  ///< what stands for the scene where rays go on
  std::string roles{};            ///< a file; empty: rolesFor()
  std::optional<View> view{};     ///< of the picture; nothing: Effect::defaultView()
  glm::ivec2 size{720, 480};      ///< of the picture, pixels
  std::optional<glm::ivec2> referenceSize{};
  std::optional<float> cellSide{};
  int environmentHeight = StageInputs{}.environmentHeight;
  std::map<std::string, std::string> options{};  ///< of the effect, by name; an empty value counts as not given
  SceneOptions scene{};
};

struct PreparedEffect {
  const Effect& effect;
  PinholeCamera camera;  ///< of the picture
  std::unique_ptr<EffectStage> stage;
};

/// The options that are given. Throws InputError for those that the effect does not have, and for values that they do
/// not take.
std::map<std::string, std::string> givenEffectOptions(const std::map<std::string, std::string>& options,
                                                      const Effect& effect);

/// Throws InputError for names and options that the effect does not have, for scenes that lack the objects it needs,
/// and where the picture would show nothing of it. `caster` is StageInputs::caster.
PreparedEffect prepareEffect(const EffectRequest& request, const std::shared_ptr<const DepthRayCaster>& caster = {},
                             const Progress& progress = {});

}  // namespace ocelli
