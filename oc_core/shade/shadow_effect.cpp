#include "oc_core/shade/shadow_effect.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "oc_core/base/error.h"
#include "oc_core/camera/view.h"
#include "oc_core/page/html.h"
#include "oc_core/shade/shadow_figures.h"
#include "oc_core/shade/shadow_picture.h"
#include "oc_core/shade/shadow_ways.h"
#include "oc_core/soft_shadows/light_shadow_map.h"

namespace ocelli {
namespace {

/// Of visibility, at which maps have their full colour.
constexpr double kFullError = 0.2;

struct ShadowScene {
  explicit ShadowScene(std::shared_ptr<const ShadedScene> from) : scene(std::move(from)), surfaces(*scene) {}
  std::shared_ptr<const ShadedScene> scene;
  ShadowSurfaces surfaces;
};

class ShadowWay final : public EffectWay {
 public:
  ShadowWay(std::shared_ptr<const ShadowScene> scene, BuiltShadow built)
      : scene_(std::move(scene)), built_(std::move(built)) {}

  Image<glm::vec3> draw(const PinholeCamera& camera) const override {
    const ShadowPixels pixels = scene_->surfaces.seenBy(camera);
    return litPicture(pixels, built_.visibility->of(pixels.receivers).share);
  }

 private:
  std::shared_ptr<const ShadowScene> scene_;
  BuiltShadow built_;
};

constexpr const char* kLightSamples = "light-samples";

/// Rows of the samples of the light, which has their square.
int lightSideFrom(const std::string& text) {
  for (const int side : {8, 16, 24, 32}) {
    if (text == std::to_string(side * side)) {
      return side;
    }
  }
  throw InputError("\"" + text + "\" is no number of samples", "--light-samples", "give 64, 256, 576 or 1024");
}

const std::vector<EffectOption>& shadowOptions() {
  static const std::vector<EffectOption> options{{kLightSamples, "64|256|576|1024", "1024",
                                                  "Samples of the light that decide how much of it is seen",
                                                  [](const std::string& value) { lightSideFrom(value); }}};
  return options;
}

class ShadowStage final : public EffectStage {
 public:
  explicit ShadowStage(const StageInputs& inputs)
      : inputs_(inputs),
        lightSide_(lightSideFrom(optionValue(inputs, shadowOptions(), kLightSamples))),
        scene_(std::make_shared<ShadowScene>(inputs.scene)),
        reference_(lightView(light(), inputs.scene->cast, inputs.referenceSize.x, inputs.referenceSize.y,
                             inputs.scene->source),
                   inputs.referenceSize.x, inputs.referenceSize.y) {
    cell_.shape = ViewCell::Shape::kSphere;
    cell_.sideRadii = inputs.cellSide.value_or(std::max(diameter(), kMinCellSide));
  }

  std::unique_ptr<EffectWay> build(const std::string& way) const override {
    return std::make_unique<ShadowWay>(scene_, built(way));
  }

  void checkView(const PinholeCamera& camera) const override {
    const ShadowPixels pixels = scene_->surfaces.seenBy(camera);
    if (std::none_of(pixels.pixels.begin(), pixels.pixels.end(), [](const ShadowPixel& p) { return p.isMeasured; })) {
      throw InputError("the picture shows nothing that receives light", "--view",
                       "move the eye, leave --view out, or give more objects the role \"receive\"");
    }
  }

  ShadedWay measure(const std::string& way, const PinholeCamera& camera, int runs) override {
    prepareTruth(camera, way == kTraced ? runs : 1);
    if (way == kTraced) {
      return wayOf(truth_->built, truth_->found, truth_->milliseconds);
    }
    const BuiltShadow ready = built(way);
    const auto [found, milliseconds] = timed(ready, runs);
    return wayOf(ready, found, milliseconds);
  }

  std::vector<ShadeFact> facts(const PinholeCamera& camera) override {
    prepareTruth(camera, 1);
    const ShadowFigures figures = shadowFigures(truth_->pixels, truth_->found.share, truth_->found);
    const glm::ivec2 size = inputs_.referenceSize;
    const int samples = lightSide_ * lightSide_;
    return {{"reference_view", jsonText(reference_.view())},
            {"light_size", fmt::format("[{}, {}]", light().width, light().height),
             fmt::format("The light is a {} of {:.3g} x {:.3g} units.", light().isDisc ? "disc" : "rectangle",
                         static_cast<double>(light().width), static_cast<double>(light().height))},
            {"light_samples", std::to_string(samples),
             fmt::format("{} samples of it decide how much is seen.", groupedDigits(static_cast<size_t>(samples)))},
            {"receivers", std::to_string(figures.receivers),
             fmt::format("{} pixels receive its light.", groupedDigits(figures.receivers))},
            {"in_penumbra", std::to_string(figures.inPenumbra),
             fmt::format("{} of them see it in part.", groupedDigits(figures.inPenumbra))},
            {"reference_size", fmt::format("[{}, {}]", size.x, size.y),
             fmt::format("Shadow maps and reference images are of {} x {} pixels.", size.x, size.y)},
            {"cell_side", fmt::format("{}", cell_.sideRadii),
             fmt::format("Reference images are for a cell of {:.3g} units around the light.",
                         static_cast<double>(cell_.sideRadii))}};
  }

 private:
  /// Builders need some cell, also for a light that is a point.
  static constexpr float kMinCellSide = 1e-3f;

  struct Truth {
    View view;
    glm::ivec2 size;
    int runs;
    BuiltShadow built;
    ShadowPixels pixels;
    LightVisibility found;
    double milliseconds;
  };

  const AreaLight& light() const { return inputs_.scene->lights.front(); }
  float diameter() const {
    return light().isDisc ? std::max(light().width, light().height) : std::hypot(light().width, light().height);
  }

  BuiltShadow built(const std::string& way) const {
    return buildShadow(way, {*inputs_.scene, reference_, cell_, lightSide_, inputs_.progress});
  }

  std::pair<LightVisibility, double> timed(const BuiltShadow& way, int runs) const {
    LightVisibility found;
    double least = 0;
    for (int run = 0; run < runs; ++run) {
      const auto start = std::chrono::steady_clock::now();
      found = way.visibility->of(truth_->pixels.receivers);
      const double took = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
      least = run == 0 ? took : std::min(least, took);
    }
    return {std::move(found), least};
  }

  void prepareTruth(const PinholeCamera& camera, int runs) {
    const glm::ivec2 size(camera.width(), camera.height());
    if (truth_ && truth_->view == camera.view() && truth_->size == size && truth_->runs >= runs) {
      return;
    }
    truth_ = Truth{camera.view(), size, runs, built(kTraced), scene_->surfaces.seenBy(camera), {}, 0};
    std::tie(truth_->found, truth_->milliseconds) = timed(truth_->built, runs);
  }

  ShadedWay wayOf(const BuiltShadow& way, const LightVisibility& found, double milliseconds) const {
    ShadowFigures figures = shadowFigures(truth_->pixels, truth_->found.share, found);
    figures.milliseconds = milliseconds;
    ShadedWay result{.name = way.name, .picture = litPicture(truth_->pixels, found.share)};
    if (&way != &truth_->built) {
      result.maps.push_back({"errors", "where visibility is wrong",
                             shadowErrorImage(truth_->pixels, truth_->found.share, found.share, kFullError)});
    }
    result.figures = shadowFigureRow(way, figures);
    return result;
  }

  StageInputs inputs_;
  int lightSide_;
  std::shared_ptr<const ShadowScene> scene_;
  PinholeCamera reference_;
  ViewCell cell_;
  std::optional<Truth> truth_;
};

void requireLight(const ShadedScene& scene) {
  if (scene.lights.size() != 1) {
    throw InputError(scene.lights.empty() ? "this scene has no light" : "this scene has more than one light",
                     scene.source,
                     "give one object the role \"light\" with --roles FILE.json, or take builtin:lamp or "
                     "builtin:pergola");
  }
  requireCast(scene);
  if (std::none_of(scene.receives.begin(), scene.receives.end(), [](uint8_t receives) { return receives != 0; })) {
    throw InputError("no object of this scene has the role \"receive\": nothing shows shadows", scene.source,
                     "give one that role with --roles FILE.json");
  }
}

/// Of what receives light, from in front and above, as wide as the box around it.
View shadowView(const ShadedScene& scene) {
  Box box;
  size_t triangle = 0;
  for (const Mesh* part : {&scene.cast, &scene.billboards, &scene.surroundings}) {
    for (const glm::uvec3& t : part->triangles) {
      if (scene.receives[triangle++] != 0) {
        for (int corner = 0; corner < 3; ++corner) {
          box.add(part->positions[t[corner]]);
        }
      }
    }
  }
  constexpr double kElevationDegrees = 25;
  View view;
  view.target = box.center();
  const auto elevation = static_cast<float>(radiansFromDegrees(kElevationDegrees));
  view.eye =
      view.target + glm::vec3(0, std::sin(elevation), std::cos(elevation)) * static_cast<float>(kDefaultEyeDistance);
  return viewAround(view, box, static_cast<double>(kDefaultWidth) / kDefaultHeight);
}

}  // namespace

Effect shadowEffect() {
  Effect effect{};
  effect.name = "shadow";
  effect.title = "Soft shadows";
  effect.description = "the soft shadows that objects with the role \"cast\" throw under a light";
  effect.ways =
      "traced (1,024 rays), traced-N, outlines (of the geometry), pcss, backprojection (of a plain shadow map), or the "
      "outlines of the reference images of a camera: a name or a JSON file";
  effect.columns = shadowColumns();
  effect.legend = {{kTooDarkColor, "too dark: less of the light is seen than should be, by 0.2 or more"},
                   {kTooLightColor, "too light: light leaks, by 0.2 or more"}};
  effect.mapNote = "Paler colours are smaller errors; white is right; grey receives no light, or is not measured.";
  effect.terms = {{"Visibility", "The share of the light's area that no surface hides from a point."},
                  {"Outline", "An edge with a surface on one side only, as seen from the point."}};
  effect.checkWay = checkShadowName;
  effect.requireObjects = requireLight;
  effect.defaultView = shadowView;
  effect.stage = [](const StageInputs& inputs) -> std::unique_ptr<EffectStage> {
    return std::make_unique<ShadowStage>(inputs);
  };
  effect.lightsScene = true;
  effect.options = shadowOptions();
  effect.waysToOffer = shadowNames;
  return effect;
}

}  // namespace ocelli
