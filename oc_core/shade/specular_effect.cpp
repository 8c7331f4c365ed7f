#include "oc_core/shade/specular_effect.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "oc_core/base/error.h"
#include "oc_core/camera/view.h"
#include "oc_core/evaluation/error_image.h"
#include "oc_core/page/html.h"
#include "oc_core/shade/scene_proxies.h"
#include "oc_core/shade/shade_comparison.h"

namespace ocelli {
namespace {

using Row = ShadeFigures;
using Value = std::optional<double>;

constexpr uint32_t kBrightestSteps = 48;  ///< the text's mean at fine steps

Value withDepth(const Row& row, double value) {
  return row.hasDepth ? Value(value) : std::nullopt;
}
Value inPyramids(const Row& row, double value) {
  return row.cost.nodes > 0 ? Value(value) : std::nullopt;
}
Value counted(size_t number) {
  return number > 0 ? Value(static_cast<double>(number)) : std::nullopt;
}

struct Figure {
  FigureColumn column;
  Value (*value)(const Row&);
};

const std::vector<Figure>& specularFigures() {
  static const std::vector<Figure> figures{
      {{"rays", nullptr, "one a pixel that sends one on", 0, 1},
       [](const Row& r) -> Value { return static_cast<double>(r.rays); }},
      {{"cast_rays", nullptr, "those whose traced first hit is on an object that depth images stand for", 0, 1},
       [](const Row& r) -> Value { return static_cast<double>(r.castRays); }},
      {{"psnr_db", "PSNR dB", "of the pixels that send rays on, against the traced picture", 2, 1},
       [](const Row& r) -> Value { return r.psnrDecibels; }},
      {{"lost", "lost %",
        "first hits that are missing or further than 1.5 footprints off, of the rays whose traced first "
        "hit is on an object that depth images stand for",
        2, 100},
       [](const Row& r) { return withDepth(r, r.lostRatio()); }},
      {{"missing", "missing %", "those of them that meet no sample", 2, 100},
       [](const Row& r) { return withDepth(r, r.missingRatio()); }},
      {{"false_hits", "false %",
        "rays that meet a sample more than 1.5 footprints before the traced first hit, of all rays", 2, 100},
       [](const Row& r) { return withDepth(r, r.falseRatio()); }},
      {{"steps_per_ray", "steps", "nodes of the pyramid that are opened and cells that are tested, a ray", 1, 1},
       [](const Row& r) { return inPyramids(r, r.stepsPerRay()); }},
      {{"max_steps", "most", "the most steps of a ray", 0, 1}, [](const Row& r) { return inPyramids(r, r.maxSteps); }},
      {{"boxes_per_ray", "boxes", "bounds that are compared, a ray", 1, 1},
       [](const Row& r) { return inPyramids(r, r.boxesPerRay()); }},
      {{"samples", "samples", "of the images", 0, 1}, [](const Row& r) { return counted(r.samples); }},
      {{"triangles", "triangles", "that rays can hit", 0, 1}, [](const Row& r) { return counted(r.triangles); }},
      {{"build_ms", "build ms", "of the images; of the acceleration structure where the geometry is traced", 1, 1},
       [](const Row& r) -> Value { return r.buildMilliseconds; }},
      {{"structure_ms", "pyramid ms", "of the cells and the pyramid", 1, 1},
       [](const Row& r) { return inPyramids(r, r.structureMilliseconds); }},
      {{"shade_ms", "rays ms", "of all rays, on all threads", 1, 1},
       [](const Row& r) -> Value { return r.shadeMilliseconds; }},
  };
  return figures;
}

/// What is different between the effects of this file.
struct Specular {
  const std::vector<SpecularObject>& (*senders)(const ShadedScene& scene);
  SecondaryRays (*rays)(const FirstSurfaces& surfaces, const PinholeCamera& camera);
};

const Specular kReflection{[](const ShadedScene& scene) -> const std::vector<SpecularObject>& { return scene.mirrors; },
                           reflectedRays};
const Specular kRefraction{[](const ShadedScene& scene) -> const std::vector<SpecularObject>& { return scene.lenses; },
                           refractedRays};

/// The scene, and what its pictures show first.
struct SpecularScene {
  std::shared_ptr<const ShadedScene> scene;
  const Specular& specular;
  FirstSurfaces surfaces;

  SecondaryRays raysOf(const PinholeCamera& camera) const { return specular.rays(surfaces, camera); }
};

class SpecularWay final : public EffectWay {
 public:
  SpecularWay(std::shared_ptr<const SpecularScene> scene, BuiltProxy built)
      : scene_(std::move(scene)), built_(std::move(built)) {}

  Image<glm::vec3> draw(const PinholeCamera& camera) const override {
    return shade(scene_->raysOf(camera), *built_.proxy).color;
  }

 private:
  std::shared_ptr<const SpecularScene> scene_;
  BuiltProxy built_;
};

float largestSide(const Box& box) {
  return std::max({box.size().x, box.size().y, box.size().z});
}

class SpecularStage final : public EffectStage {
 public:
  SpecularStage(const StageInputs& inputs, const Specular& specular)
      : inputs_(inputs),
        scene_(std::make_shared<SpecularScene>(inputs.scene, specular,
                                               FirstSurfaces(*inputs.scene, specular.senders(*inputs.scene)))),
        senders_(boundsOf(specular.senders(*inputs.scene))),
        reference_(referenceView(inputs.scene->cast, senders_, inputs.referenceSize.x, inputs.referenceSize.y),
                   inputs.referenceSize.x, inputs.referenceSize.y) {
    cell_.shape = ViewCell::Shape::kSphere;
    cell_.sideRadii = inputs.cellSide.value_or(largestSide(senders_));
  }

  std::unique_ptr<EffectWay> build(const std::string& way) const override {
    return std::make_unique<SpecularWay>(scene_, proxyOf(way));
  }

  void checkView(const PinholeCamera& camera) const override {
    for (int y = 0; y < camera.height(); ++y) {
      for (int x = 0; x < camera.width(); ++x) {
        const glm::vec2 pixel(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
        if (scene_->surfaces.along(camera.rayPath(pixel)).object != nullptr) {
          return;
        }
      }
    }
    throw InputError("the picture shows nothing of what mirrors or refracts", "--view",
                     "move the eye, or leave --view out");
  }

  ShadedWay measure(const std::string& way, const PinholeCamera& camera, int runs) override {
    const BuiltProxy built = proxyOf(way);
    if (way == kTraced) {
      truth_ = Truth{camera.view(), {camera.width(), camera.height()}, scene_->raysOf(camera), {}};
      truth_->picture = shade(truth_->rays, *built.proxy, runs);
      return wayOf(built, truth_->picture);
    }
    prepareTruth(camera);
    return wayOf(built, shade(truth_->rays, *built.proxy, runs));
  }

  std::vector<ShadeFact> facts(const PinholeCamera& camera) override {
    prepareTruth(camera);
    size_t castRays = 0;
    for (const ProxyHit& hit : truth_->picture.hits) {
      castRays += hit.onCast;
    }
    const glm::ivec2 size = inputs_.referenceSize;
    const int height = inputs_.environmentHeight;
    return {{"reference_view", jsonText(reference_.view())},
            {"rays", std::to_string(truth_->rays.rays.size()),
             fmt::format("{} rays, one a pixel that sends one on.", groupedDigits(truth_->rays.rays.size()))},
            {"cast_rays", std::to_string(castRays),
             fmt::format("{} of them first meet objects that depth images stand for.", groupedDigits(castRays))},
            {"reference_size", fmt::format("[{}, {}]", size.x, size.y),
             fmt::format("Reference images of {} x {} pixels.", size.x, size.y)},
            {"cell_side", fmt::format("{}", cell_.sideRadii),
             fmt::format("They are for a cell of {:.3g} units around what sends the rays.",
                         static_cast<double>(cell_.sideRadii))},
            {"environment_height", std::to_string(height),
             fmt::format("Environment maps are of {} x {} pixels.", 2 * height, height)}};
  }

 private:
  struct Truth {
    View view;
    glm::ivec2 size;
    SecondaryRays rays;
    ShadedPicture picture;
  };

  BuiltProxy proxyOf(const std::string& way) const {
    return buildProxy(
        way, {*scene_->scene, senders_.center(), reference_, cell_, inputs_.environmentHeight, inputs_.progress});
  }

  void prepareTruth(const PinholeCamera& camera) {
    if (!truth_ || truth_->view != camera.view() || truth_->size != glm::ivec2(camera.width(), camera.height())) {
      measure(kTraced, camera, 1);
    }
  }

  ShadedWay wayOf(const BuiltProxy& built, const ShadedPicture& picture) const {
    const ShadeFigures row = figuresOf(built, truth_->rays, truth_->picture, picture, reference_);
    ShadedWay way{.name = built.name, .picture = picture.color};
    if (row.hasDepth && built.name != kTraced) {
      way.maps.push_back({"errors", "where first hits are wrong",
                          hitErrorImage(truth_->rays, truth_->picture,
                                        compareHits(truth_->rays, truth_->picture, picture, reference_))});
    }
    if (row.cost.nodes > 0) {
      way.maps.push_back({"steps", "steps of each ray", stepImage(truth_->rays, picture, kBrightestSteps)});
    }
    for (const Figure& figure : specularFigures()) {
      way.figures.push_back(figure.value(row));
    }
    return way;
  }

  StageInputs inputs_;
  std::shared_ptr<const SpecularScene> scene_;
  Box senders_;
  PinholeCamera reference_;
  ViewCell cell_;
  std::optional<Truth> truth_;
};

void requireSenders(const Specular& specular, const ShadedScene& scene, const char* role) {
  requireCast(scene);
  if (specular.senders(scene).empty()) {
    throw InputError(fmt::format("no object of this scene has the role \"{}\"", role), scene.source,
                     "give one that role with --roles FILE.json, or choose another --effect");
  }
}

Effect specularEffect() {
  Effect effect{};
  effect.ways =
      "traced (the geometry), environment (an environment map), or the reference images of a camera: a name or a JSON "
      "file";
  for (const Figure& figure : specularFigures()) {
    effect.columns.push_back(figure.column);
  }
  effect.legend = {{kMissingColor, "missing: the ray meets no sample"},
                   {kFalseSkinColor, "off: the first hit is more than 1.5 footprints away from the traced one"},
                   {kWrongFrontColor, "false: a sample stands before the traced first hit"}};
  static_assert(kBrightestSteps == 48);
  effect.mapNote = "Steps: from dark blue for none over red to white for 48 or more.";
  effect.terms = {{"Footprint",
                   "What a pixel of the reference view covers at the depth of a hit: depth / focal length in pixels."}};
  effect.checkWay = checkProxyName;
  effect.waysToOffer = proxyNames;
  return effect;
}

}  // namespace

Effect reflectionEffect() {
  Effect effect = specularEffect();
  effect.name = "reflection";
  effect.title = "Reflection";
  effect.description = "what objects with the role \"mirror\" reflect, at first order";
  effect.requireObjects = [](const ShadedScene& scene) { requireSenders(kReflection, scene, "mirror"); };
  effect.defaultView = [](const ShadedScene& scene) { return pictureView(boundsOf(scene.mirrors)); };
  effect.stage = [](const StageInputs& inputs) -> std::unique_ptr<EffectStage> {
    return std::make_unique<SpecularStage>(inputs, kReflection);
  };
  return effect;
}

Effect refractionEffect() {
  Effect effect = specularEffect();
  effect.name = "refraction";
  effect.title = "Refraction";
  effect.description = "what is seen through objects with the role \"refract\"";
  effect.requireObjects = [](const ShadedScene& scene) { requireSenders(kRefraction, scene, "refract"); };
  effect.defaultView = [](const ShadedScene& scene) { return pictureView(boundsOf(scene.lenses)); };
  effect.stage = [](const StageInputs& inputs) -> std::unique_ptr<EffectStage> {
    return std::make_unique<SpecularStage>(inputs, kRefraction);
  };
  return effect;
}

}  // namespace ocelli
