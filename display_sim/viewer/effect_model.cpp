#include "display_sim/viewer/effect_model.h"

#include <filesystem>
#include <system_error>

#include "oc_core/base/error.h"
#include "oc_core/shade/effects.h"
#include "oc_core/worlds/builtin_scenes.h"

namespace ocelli {
namespace {

const Effect& firstEffectOf(const ShadedScene& scene) {
  std::exception_ptr first;
  for (const Effect& effect : shadeEffects()) {
    try {
      effect.requireObjects(scene);
      return effect;
    } catch (const InputError&) {
      first = first ? first : std::current_exception();
    }
  }
  OC_CHECK(first, "there are effects");
  std::rethrow_exception(first);
}

/// Throws InputError where nothing says roles, and the effect needs them.
void requireRoles(const EffectWanted& wanted) {
  const bool needed = wanted.effect.empty() || shadeEffect(wanted.effect).needsRoles;
  if (!needed || !wanted.rolesFile.empty() || sceneHasRoles(wanted.source)) {
    return;
  }
  std::string known;
  for (const BuiltinScene& scene : listBuiltinScenes()) {
    if (!scene.roles.empty()) {
      known += (known.empty() ? "builtin:" : ", builtin:") + scene.name;
    }
  }
  std::string others;
  for (const Effect& effect : shadeEffects()) {
    if (!effect.needsRoles) {
      others += (others.empty() ? "; or choose another effect: " : ", ") + std::string(effect.name);
    }
  }
  throw InputError("nothing says what the objects of this scene are to an effect: which mirror, refract or cast",
                   wanted.source,
                   "drop a file of roles onto the window (docs/depth_images.md), or give it with --roles FILE.json; "
                   "these scenes have roles: " +
                       known + others);
}

}  // namespace

struct EffectModel::Made {
  EffectWanted sceneOf;  ///< what each of the following was made for
  EffectWanted stageOf;
  EffectWanted wayOf;
  std::shared_ptr<const ShadedScene> scene;
  bool lightsScene = false;  ///< as its effect does (Effect::lightsScene)
  std::unique_ptr<EffectStage> stage;
  std::unique_ptr<EffectWay> way;  ///< null for the traced one
  std::unique_ptr<EffectWay> traced;
  /// The stage keeps a function that calls this one.
  std::shared_ptr<Progress> progress = std::make_shared<Progress>();

  void clearStage() {
    way.reset();
    traced.reset();
    stage.reset();
  }
};

EffectModel::EffectModel() : made_(std::make_unique<Made>()) {}
EffectModel::~EffectModel() = default;

void EffectModel::clear() {
  made_ = std::make_unique<Made>();
  effect_.clear();
}

void EffectModel::build(const EffectWanted& wanted, const Progress& progress) {
  *made_->progress = progress;
  requireRoles(wanted);
  const bool lightsScene = !wanted.effect.empty() && shadeEffect(wanted.effect).lightsScene;
  if (!made_->scene || !made_->sceneOf.hasSameScene(wanted) || made_->lightsScene != lightsScene) {
    made_->clearStage();
    made_->scene.reset();
    SceneOptions options = wanted.sceneOptions;
    options.shading = lightsScene ? Shading::kNone : options.shading;
    options.warn = {};  // whoever loads the scene for the other panes tells it
    made_->scene = std::make_shared<const ShadedScene>(
        loadShadedScene(wanted.source, rolesFor(wanted.source, wanted.rolesFile, false), options, progress));
    made_->sceneOf = wanted;
    made_->lightsScene = lightsScene;
  }
  const Effect& effect = wanted.effect.empty() ? firstEffectOf(*made_->scene) : shadeEffect(wanted.effect);
  if (!wanted.effect.empty()) {
    effect.checkWay(wanted.way);
    effect.requireObjects(*made_->scene);
  }
  effect_ = effect.name;
  home_ = effect.defaultView(*made_->scene);
  if (wanted.effect.empty()) {
    return;
  }
  if (!made_->stage || !made_->stageOf.hasSameStage(wanted)) {
    made_->clearStage();
    report(progress, "preparing " + effect_, 0);
    StageInputs inputs{.scene = made_->scene, .referenceSize = wanted.referenceSize};
    if (wanted.referenceSize == glm::ivec2(0)) {
      inputs.referenceSize = effect.referenceSize;
    }
    inputs.environmentHeight = wanted.environmentHeight;
    inputs.progress = [current = made_->progress](std::string_view stage, double fraction) {
      report(*current, stage, fraction);
    };
    made_->stage = effect.stage(inputs);
    made_->stageOf = wanted;
  }
  if (wanted.way == kTraced) {
    made_->way.reset();
    buildTraced(progress);
  } else if (!made_->way || !made_->wayOf.hasSameWay(wanted)) {
    made_->way.reset();
    report(progress, "building", 0);
    made_->way = made_->stage->build(wanted.way);
    made_->wayOf = wanted;
  }
}

void EffectModel::buildTraced(const Progress& progress) {
  if (!made_->traced) {
    *made_->progress = progress;
    report(progress, "building", 0);
    made_->traced = made_->stage->build(kTraced);
  }
}

Image<Rgb8> EffectModel::drawByWay(const PinholeCamera& camera) const {
  return made_->way ? srgbFromLinear(made_->way->draw(camera)) : drawTraced(camera);
}

Image<Rgb8> EffectModel::drawTraced(const PinholeCamera& camera) const {
  OC_CHECK(made_->traced, "what is drawn has been built");
  return srgbFromLinear(made_->traced->draw(camera));
}

bool sceneHasRoles(const std::string& source) {
  if (isBuiltinScene(source)) {
    try {
      return !builtinRoles(source).empty();
    } catch (const InputError&) {  // told where it is loaded
      return false;
    }
  }
  std::error_code ignored;
  return std::filesystem::exists(rolesFileBeside(source), ignored);
}

}  // namespace ocelli
