#include "oc_core/shade/ambient_effect.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "oc_core/ambient/ambient_error.h"
#include "oc_core/ambient/ray_ambient.h"
#include "oc_core/ambient/unseen_target.h"
#include "oc_core/base/error.h"
#include "oc_core/base/number_text.h"
#include "oc_core/image/color.h"
#include "oc_core/page/html.h"
#include "oc_core/shade/ambient_ways.h"
#include "oc_core/shade/secondary_rays.h"

namespace ocelli {
namespace {

/// Light that is taken by what the view does not show, from which on a point counts as such.
constexpr float kUnseenLight = 0.1f;
/// Rays a point that tell it.
constexpr int kUnseenRays = 64;

/// sRGB, of Okabe and Ito: told apart by every kind of colour vision.
constexpr Rgb8 kTooLight{213, 94, 0};
constexpr Rgb8 kTooDark{0, 114, 178};
constexpr Rgb8 kRightLight{235, 235, 235};
constexpr Rgb8 kNoLight{90, 90, 90};
/// The error from which on the colours are full.
constexpr float kFullLightError = 0.3f;

struct AmbientRow {
  AmbientError all;
  AmbientError unseen;
  double meanLight = 0;
  const AmbientLight* way;
};

using AmbientValue = std::optional<double>;

struct AmbientFigure {
  FigureColumn column;
  AmbientValue (*value)(const AmbientRow&);
};

const std::vector<AmbientFigure>& ambientFigures() {
  static const std::vector<AmbientFigure> figures{
      {{"points", nullptr, "one a pixel that shows a surface on which light is measured", 0, 1},
       [](const AmbientRow& r) -> AmbientValue { return static_cast<double>(r.all.points); }},
      {{"rmse", "RMSE", "of the light, which is from 0 to 1, against the traced one", 4, 1},
       [](const AmbientRow& r) -> AmbientValue { return r.all.rmse; }},
      {{"wrong", "wrong %", "points whose light is off by more than 0.1", 2, 100},
       [](const AmbientRow& r) -> AmbientValue { return r.all.wrongShare; }},
      {{"signed_mean", "mean error", "light minus traced light: above 0 where occluders are missed", 4, 1},
       [](const AmbientRow& r) -> AmbientValue { return r.all.signedMean; }},
      {{"unseen_rmse", "RMSE unseen",
        "the same as RMSE, of the points at which occluders that the view does not show take 0.1 or more of the light",
        4, 1},
       [](const AmbientRow& r) { return r.unseen.points > 0 ? AmbientValue(r.unseen.rmse) : std::nullopt; }},
      {{"unseen_signed_mean", "mean error unseen", "the same as the mean error, of those points", 4, 1},
       [](const AmbientRow& r) { return r.unseen.points > 0 ? AmbientValue(r.unseen.signedMean) : std::nullopt; }},
      {{"mean_light", "light", "mean of the light", 3, 1},
       [](const AmbientRow& r) -> AmbientValue { return r.meanLight; }},
      {{"samples", "samples", "of the images that tell what hides light", 0, 1},
       [](const AmbientRow& r) {
         return r.way->samples > 0 ? AmbientValue(static_cast<double>(r.way->samples)) : std::nullopt;
       }},
      {{"build_ms", "build ms", "of images and their structures; without the acceleration structure of the geometry", 1,
        1},
       [](const AmbientRow& r) -> AmbientValue { return r.way->buildMilliseconds; }},
      {{"light_ms", "light ms", "of the light of all points, on all threads", 1, 1},
       [](const AmbientRow& r) -> AmbientValue { return r.way->lightMilliseconds; }},
  };
  return figures;
}

Image<glm::vec3> ambientPicture(const AmbientScene& scene, const AmbientSight& sight, const std::vector<float>& light) {
  Image<glm::vec3> picture = colorImage(sight.seen, scene.mesh(), shadeBackground());
  for (size_t i = 0; i < light.size(); ++i) {
    picture[sight.points[i].pixel] = glm::vec3(light[i]);
  }
  return picture;
}

Rgb8 ambientErrorColor(float off) {
  const Rgb8 full = off > 0 ? kTooLight : kTooDark;
  const float share = std::min(std::abs(off) / kFullLightError, 1.0f);
  return Rgb8(glm::mix(glm::vec3(kRightLight), glm::vec3(full), share) + 0.5f);
}

Image<Rgb8> ambientErrorMap(const AmbientSight& sight, const std::vector<float>& light,
                            const std::vector<float>& truth) {
  Image<Rgb8> map(sight.camera.width(), sight.camera.height(), kNoLight);
  for (size_t i = 0; i < light.size(); ++i) {
    map[sight.points[i].pixel] = ambientErrorColor(light[i] - truth[i]);
  }
  return map;
}

constexpr const char* kByItself = "auto";

/// A number, or nothing for "auto". Throws InputError for another text.
std::optional<double> numberOrAuto(const std::string& text, const char* option, double least, double most) {
  if (text == kByItself) {
    return std::nullopt;
  }
  const std::optional<double> value = numberFromText<double>(text);
  if (!value || *value < least || *value > most) {
    throw InputError(fmt::format("\"{}\" is no number from {} to {}", text, least, most), std::string("--") + option,
                     std::string("give such a number, or ") + kByItself);
  }
  return value;
}

std::optional<double> radiusFrom(const std::string& text) {
  return numberOrAuto(text, "radius", 0, 1e6);
}
std::optional<double> splitFrom(const std::string& text) {
  return numberOrAuto(text, "split", -1, 2);
}
std::optional<double> turnFrom(const std::string& text) {
  return numberOrAuto(text, "turn", 0, 80);
}

const std::vector<EffectOption>& ambientOptions() {
  static const std::vector<EffectOption> options{
      {"radius", "DISTANCE|auto", kByItself,
       "From where on nothing hides light, world units; auto: 0.15 of the scene's diagonal",
       [](const std::string& value) { radiusFrom(value); }},
      {"split", "SHARE|auto", kByItself,
       "Where the splitting point of the graph camera lies, from 0 for the scene's middle to 1 for behind it; auto: on "
       "a curve made for the scene",
       [](const std::string& value) { splitFrom(value); }},
      {"turn", "DEGREES|auto", kByItself, "Of the viewpoints of the graph camera beyond its plane; auto: 30",
       [](const std::string& value) { turnFrom(value); }}};
  return options;
}

AmbientSettings ambientSettings(const StageInputs& inputs) {
  const auto given = [&](const char* name) { return optionValue(inputs, ambientOptions(), name); };
  AmbientSettings settings;
  settings.radius = radiusFrom(given("radius"));
  settings.splitShare = splitFrom(given("split"));
  settings.turnDegrees = turnFrom(given("turn")).value_or(settings.turnDegrees);
  settings.cellSide = inputs.cellSide;
  return settings;
}

class AmbientWay final : public EffectWay {
 public:
  AmbientWay(std::shared_ptr<const AmbientScene> scene, const AmbientSettings& settings, std::string way)
      : scene_(std::move(scene)), settings_(settings), way_(std::move(way)) {}

  Image<glm::vec3> draw(const PinholeCamera& camera) const override {
    const AmbientSight sight(*scene_, camera);
    return ambientPicture(*scene_, sight, ambientLightBy(way_, {*scene_, sight, settings_, Progress{}}).light);
  }

 private:
  std::shared_ptr<const AmbientScene> scene_;
  AmbientSettings settings_;
  std::string way_;
};

class AmbientStage final : public EffectStage {
 public:
  explicit AmbientStage(const StageInputs& inputs)
      : settings_(ambientSettings(inputs)),
        progress_(inputs.progress),
        scene_(std::make_shared<const AmbientScene>(inputs.scene, settings_.radius)) {}

  std::unique_ptr<EffectWay> build(const std::string& way) const override {
    checkAmbientWay(way);
    return std::make_unique<AmbientWay>(scene_, settings_, way);
  }

  void checkView(const PinholeCamera& camera) const override {
    if (AmbientSight(*scene_, camera).points.empty()) {
      throw InputError("the picture shows nothing on which light is measured", "--view",
                       "move the eye, or give an object in sight the role \"receive\"");
    }
  }

  ShadedWay measure(const std::string& way, const PinholeCamera& camera, int runs) override {
    const Truth& truth = truthOf(camera, way == kTraced ? runs : 1);
    const AmbientLight light = way == kTraced ? truth.light : ambientLightBy(way, inputsOf(truth.sight), runs);
    AmbientRow row{.all = ambientError(light.light, truth.light.light), .unseen = {}, .way = &light};
    std::vector<float> unseenLight;
    std::vector<float> unseenTruth;
    for (size_t i = 0; i < light.light.size(); ++i) {
      row.meanLight += static_cast<double>(light.light[i]) / static_cast<double>(light.light.size());
      if (truth.unseen[i] >= kUnseenLight) {
        unseenLight.push_back(light.light[i]);
        unseenTruth.push_back(truth.light.light[i]);
      }
    }
    row.unseen = ambientError(unseenLight, unseenTruth);
    ShadedWay shown{.name = way, .picture = ambientPicture(*scene_, truth.sight, light.light)};
    if (way != kTraced) {
      shown.maps.push_back(
          {"errors", "where light is wrong", ambientErrorMap(truth.sight, light.light, truth.light.light)});
    }
    for (const AmbientFigure& figure : ambientFigures()) {
      shown.figures.push_back(figure.value(row));
    }
    return shown;
  }

  std::vector<ShadeFact> facts(const PinholeCamera& camera) override {
    const Truth& truth = truthOf(camera, 1);
    const auto unseen = static_cast<size_t>(
        std::count_if(truth.unseen.begin(), truth.unseen.end(), [](float light) { return light >= kUnseenLight; }));
    const SplitCurve& curve = scene_->curve;
    const glm::dvec3 direction(camera.forward());
    const double share = settings_.splitShare.value_or(curve.share(direction));
    const glm::dvec3 split = curve.pointAt(direction, share);
    return {{"points", std::to_string(truth.sight.points.size()),
             fmt::format("Light is measured at {} pixels.", groupedDigits(truth.sight.points.size()))},
            {"unseen_points", std::to_string(unseen),
             fmt::format("At {} of them occluders that the view does not show take 0.1 or more of it.",
                         groupedDigits(unseen))},
            {"radius", fmt::format("{}", scene_->options.radius),
             fmt::format("What is {:.3g} units away or more hides none.", scene_->options.radius)},
            {"traced_rays", std::to_string(kTruthRays), fmt::format("{} traced rays a point.", kTruthRays)},
            {"image_rays", std::to_string(kImageRays), fmt::format("{} rays a point at images.", kImageRays)},
            {"splitting_point", fmt::format("[{}, {}, {}]", split.x, split.y, split.z),
             fmt::format("The splitting point of the graph camera lies {:.2f} of the way from the scene's middle to "
                         "behind it.",
                         share)},
            {"turn_degrees", fmt::format("{}", settings_.turnDegrees),
             fmt::format("Beyond their plane the viewpoints of the graph camera are turned by {:.3g} degrees.",
                         settings_.turnDegrees)}};
  }

 private:
  struct Truth {
    AmbientSight sight;
    AmbientLight light;
    std::vector<float> unseen;  ///< the light that occluders take which the view does not show
  };

  AmbientInputs inputsOf(const AmbientSight& sight) const { return {*scene_, sight, settings_, progress_}; }

  const Truth& truthOf(const PinholeCamera& camera, int runs) {
    if (!truth_ || truth_->sight.camera != camera) {
      AmbientSight sight(*scene_, camera);
      AmbientLight light = ambientLightBy(kTraced, inputsOf(sight), runs);
      std::vector<float> unseen = ambientByRays(sight.points, UnseenTarget(scene_->rays, camera, sight.seen),
                                                scene_->options, {.count = kUnseenRays});
      for (float& each : unseen) {
        each = 1 - each;
      }
      truth_.emplace(Truth{std::move(sight), std::move(light), std::move(unseen)});
    }
    return *truth_;
  }

  AmbientSettings settings_;
  Progress progress_;
  std::shared_ptr<const AmbientScene> scene_;
  std::optional<Truth> truth_;
};

}  // namespace

Effect ambientEffect() {
  Effect effect{};
  effect.name = "ambient";
  effect.title = "Ambient light";
  effect.description =
      "how much of an even sky reaches objects with the role \"receive\", or all of a scene without it";
  effect.ways =
      "traced or traced-N (N rays a point at the geometry), horizon (in the view's depth buffer), horizon-wide (with a "
      "border), graph (horizons in a graph camera of three frusta), graph-rays (rays at its samples), NAME:horizon (in "
      "another graph camera), or the reference images of a camera: a name or a JSON file";
  for (const AmbientFigure& figure : ambientFigures()) {
    effect.columns.push_back(figure.column);
  }
  effect.legend = {{kTooLight, "too light: occluders are missed"},
                   {kTooDark, "too dark: light is hidden by what does not hide it"},
                   {kRightLight, "right"}};
  effect.mapNote = "Colours are full where the light, which is from 0 to 1, is off by 0.3 or more.";
  effect.terms = {{"Light",
                   "The share of the light of an even sky that reaches a point, weighted by the cosine to its "
                   "normal. What hides light counts less the farther away it is."}};
  effect.checkWay = checkAmbientWay;
  effect.waysToOffer = ambientWayNames;
  effect.requireObjects = [](const ShadedScene& scene) {
    if (scene.whole.mesh.triangles.empty()) {
      throw InputError("there is nothing on which light is measured", scene.source, "choose a scene with triangles");
    }
  };
  effect.defaultView = [](const ShadedScene&) { return View{}; };
  effect.stage = [](const StageInputs& inputs) -> std::unique_ptr<EffectStage> {
    return std::make_unique<AmbientStage>(inputs);
  };
  effect.options = ambientOptions();
  effect.needsRoles = false;
  return effect;
}

}  // namespace ocelli
