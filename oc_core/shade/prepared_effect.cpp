#include "oc_core/shade/prepared_effect.h"

#include <fmt/format.h>

#include <algorithm>

#include "oc_core/base/error.h"

namespace ocelli {

std::map<std::string, std::string> givenEffectOptions(const std::map<std::string, std::string>& options,
                                                      const Effect& effect) {
  std::map<std::string, std::string> given;
  for (const auto& [name, value] : options) {
    if (value.empty()) {
      continue;
    }
    const auto row = std::find_if(effect.options.begin(), effect.options.end(),
                                  [&](const EffectOption& option) { return name == option.name; });
    if (row == effect.options.end()) {
      throw InputError(fmt::format("the effect \"{}\" has no such option", effect.name), "--" + name,
                       "leave it away, or choose another --effect");
    }
    row->check(value);
    given[name] = value;
  }
  return given;
}

PreparedEffect prepareEffect(const EffectRequest& request, const std::shared_ptr<const DepthRayCaster>& caster,
                             const Progress& progress) {
  const Effect& effect = shadeEffect(request.effect);
  for (const std::string& way : request.ways) {
    effect.checkWay(way);
  }
  StageInputs inputs{.scene = {},
                     .referenceSize = request.referenceSize.value_or(effect.referenceSize),
                     .cellSide = request.cellSide,
                     .environmentHeight = request.environmentHeight,
                     .progress = progress,
                     .options = givenEffectOptions(request.options, effect),
                     .caster = caster};
  SceneOptions sceneOptions = request.scene;
  sceneOptions.shading = effect.lightsScene ? Shading::kNone : sceneOptions.shading;
  const auto scene = std::make_shared<const ShadedScene>(loadShadedScene(
      request.source, rolesFor(request.source, request.roles, effect.needsRoles), sceneOptions, progress));
  effect.requireObjects(*scene);
  const PinholeCamera camera(request.view ? *request.view : effect.defaultView(*scene), request.size.x, request.size.y);
  inputs.scene = scene;
  inputs.picture = camera;
  std::unique_ptr<EffectStage> stage = effect.stage(inputs);
  stage->checkView(camera);
  return {effect, camera, std::move(stage)};
}

}  // namespace ocelli
