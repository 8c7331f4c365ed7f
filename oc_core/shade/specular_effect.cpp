#include "oc_core/shade/specular_effect.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "oc_core/base/error.h"
#include "oc_core/base/json_document.h"
#include "oc_core/camera/view.h"
#include "oc_core/constructor/camera_constructors.h"
#include "oc_core/evaluation/error_image.h"
#include "oc_core/page/html.h"
#include "oc_core/shade/glass_back_faces.h"
#include "oc_core/shade/ray_view.h"
#include "oc_core/shade/scene_proxies.h"
#include "oc_core/shade/shade_comparison.h"
#include "oc_core/shade/shaded_on_device.h"
#include "oc_core/shade/specular_figures.h"

namespace ocelli {
namespace {

constexpr int kMaxOrder = 8;
constexpr const char* kOrder = "order";
constexpr const char* kReference = "reference";
constexpr const char* kOfRays = "rays";
constexpr const char* kOfMiddle = "middle";

int orderFrom(const std::string& text) {
  if (text.size() == 1 && text[0] >= '1' && text[0] <= '0' + kMaxOrder) {
    return text[0] - '0';
  }
  throw InputError("\"" + text + "\" is no number of reflections", "--order",
                   fmt::format("give a whole number from 1 to {}", kMaxOrder));
}

bool fitsRays(const std::string& text) {
  if (text != kOfRays && text != kOfMiddle) {
    throw InputError("reference images are not made for \"" + text + "\"", "--reference", "give rays or middle");
  }
  return text == kOfRays;
}

const std::vector<EffectOption>& specularOptions() {
  static const std::vector<EffectOption> options{
      {kOrder, "N", "1",
       "How many reflections a ray takes at most, for objects that are both mirror and cast; with reflection the first "
       "one counts",
       [](const std::string& value) { orderFrom(value); }},
      {kReference, "rays|middle", kOfRays,
       "What reference images are made for: the view in which the rays of the picture seem to meet, or the middle of "
       "what sends them",
       [](const std::string& value) { fitsRays(value); }}};
  return options;
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
  SpecularScene(std::shared_ptr<const ShadedScene> shaded, const Specular& of)
      : scene(std::move(shaded)), specular(of), surfaces(*scene, of.senders(*scene)) {}

  std::shared_ptr<const ShadedScene> scene;
  const Specular& specular;
  FirstSurfaces surfaces;

  const std::vector<SpecularObject>& senders() const { return specular.senders(*scene); }
  SecondaryRays raysOf(const PinholeCamera& camera) const { return specular.rays(surfaces, camera); }
  SecondaryRays raysOf(const PinholeCamera& camera, const SpecularWayName& way) const {
    return way.exit ? refractedRaysByBackFaces(surfaces, camera, *way.exit) : raysOf(camera);
  }
};

/// On the device of the proxies, where they have one.
ShadedPicture shadeAnywhere(const SecondaryRays& rays, const SenderProxies& proxies, int order, int runs) {
  std::optional<ShadedPicture> picture = shadeOnDevice(rays, proxies, order, runs);
  return picture ? *std::move(picture) : shade(rays, proxies, order, runs);
}

class SpecularWay final : public EffectWay {
 public:
  SpecularWay(std::shared_ptr<const SpecularScene> scene, SpecularWayName way, SenderProxies proxies, int order)
      : scene_(std::move(scene)), way_(std::move(way)), proxies_(std::move(proxies)), order_(order) {}

  Image<glm::vec3> draw(const PinholeCamera& camera) const override {
    return shadeAnywhere(scene_->raysOf(camera, way_), proxies_, order_, 1).color;
  }

 private:
  std::shared_ptr<const SpecularScene> scene_;
  SpecularWayName way_;
  SenderProxies proxies_;
  int order_;
};

float largestSide(const Box& box) {
  return std::max({box.size().x, box.size().y, box.size().z});
}

/// What reference images are made for, one a sender of rays.
struct SenderViews {
  std::vector<PinholeCamera> references;
  std::vector<ViewCell> cells;
};

class SpecularStage final : public EffectStage {
 public:
  SpecularStage(const StageInputs& inputs, const Specular& specular)
      : inputs_(inputs),
        scene_(std::make_shared<SpecularScene>(inputs.scene, specular)),
        order_(orderFrom(optionValue(inputs, specularOptions(), kOrder))),
        fitsRays_(fitsRays(optionValue(inputs, specularOptions(), kReference))),
        views_(viewsFor(fitsRays_ && inputs.picture ? scene_->raysOf(*inputs.picture) : SecondaryRays{})),
        mirrorViews_(mirrorViews()) {}

  std::unique_ptr<EffectWay> build(const std::string& text) const override {
    const SpecularWayName way = specularWay(text);
    return std::make_unique<SpecularWay>(scene_, way, proxiesOf(way), order_);
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

  ShadedWay measure(const std::string& text, const PinholeCamera& camera, int runs) override {
    const SpecularWayName way = specularWay(text);
    if (!truth_ || truth_->view != camera.view() || truth_->size != glm::ivec2(camera.width(), camera.height()) ||
        way.full == kTraced) {
      trace(camera, way.full == kTraced ? runs : 1);
    }
    if (way.full == kTraced) {
      return wayOf(truth_->total, truth_->rays, truth_->picture, way);
    }
    const SenderProxies proxies = proxiesOf(way);
    const SecondaryRays rays = way.exit ? scene_->raysOf(camera, way) : SecondaryRays{};
    const SecondaryRays& followed = way.exit ? rays : truth_->rays;
    const std::optional<ShadedPicture> onDevice = shadeOnDevice(followed, proxies, order_, runs);
    const ShadedPicture onCpu = shade(followed, proxies, order_, onDevice ? 1 : runs);
    if (!onDevice) {
      return wayOf(proxies.total(), followed, onCpu, way);
    }
    return wayOf(proxies.total(), followed, *onDevice, way, differingRays(followed, *onDevice, onCpu));
  }

  std::vector<ShadeFact> facts(const PinholeCamera& camera) override {
    if (!truth_) {
      trace(camera, 1);
    }
    size_t castRays = 0;
    for (const ProxyHit& hit : truth_->picture.hits) {
      castRays += hit.onCast;
    }
    const glm::ivec2 size = inputs_.referenceSize;
    const int height = inputs_.environmentHeight;
    std::string views;
    std::string cells;
    for (size_t i = 0; i < views_.references.size(); ++i) {
      views += (i > 0 ? ", " : "") + jsonText(views_.references[i].view());
      cells += fmt::format("{}{}", i > 0 ? ", " : "", views_.cells[i].sideRadii);
    }
    std::vector<ShadeFact> facts{
        {"rays", std::to_string(truth_->rays.rays.size()),
         fmt::format("{} rays, one a pixel that sends one on.", groupedDigits(truth_->rays.rays.size()))},
        {"cast_rays", std::to_string(castRays),
         fmt::format("{} of them first meet objects that depth images stand for.", groupedDigits(castRays))},
        {"order", std::to_string(order_),
         order_ > 1 ? fmt::format("Rays of up to {} reflections.", order_) : std::string()},
        {"reference", fmt::format("\"{}\"", fitsRays_ && inputs_.picture ? kOfRays : kOfMiddle)},
        {"reference_views", "[" + views + "]"},
        {"reference_size", fmt::format("[{}, {}]", size.x, size.y),
         fmt::format("Reference images of {} x {} pixels, {}.", size.x, size.y,
                     fitsRays_ && inputs_.picture ? "made for the view in which the rays seem to meet"
                                                  : "made for the middle of what sends the rays")},
        {"cell_sides", "[" + cells + "]",
         views_.cells.size() == 1 ? fmt::format("They are for a cell of {:.3g} units around that.",
                                                static_cast<double>(views_.cells[0].sideRadii))
                                  : std::string("Each object that sends rays has its own.")},
        {"environment_height", std::to_string(height),
         fmt::format("Environment maps are of {} x {} pixels.", 2 * height, height)}};
    if (inputs_.caster != nullptr) {
      const std::string by = inputs_.caster->description();
      facts.push_back({"gl", textOfJson(by), fmt::format("Rays at depth images are cast by {}.", by)});
    }
    return facts;
  }

 private:
  struct Truth {
    View view;
    glm::ivec2 size;
    SecondaryRays rays;
    ShadedPicture picture;
    BuiltProxy total;
  };

  /// Whether rays go on from mirrors that do not send the first ones.
  bool hasOtherMirrors() const { return order_ > 1 && &scene_->senders() != &scene_->scene->mirrors; }

  void trace(const PinholeCamera& camera, int runs) {
    Truth truth{camera.view(), {camera.width(), camera.height()}, scene_->raysOf(camera), {}, {}};
    const SenderProxies traced = proxiesOf(specularWay(kTraced));
    truth.picture = shade(truth.rays, traced, order_, runs);
    truth.total = traced.total();
    truth_ = std::move(truth);
  }

  /// Fitted to the rays, where that can be.
  SenderViews viewsFor(const SecondaryRays& rays) const {
    SenderViews views;
    const std::vector<SpecularObject>& senders = scene_->senders();
    for (size_t i = 0; i < senders.size(); ++i) {
      std::vector<SecondaryRay> own;
      std::copy_if(rays.rays.begin(), rays.rays.end(), std::back_inserter(own),
                   [&](const SecondaryRay& ray) { return ray.sender == i; });
      addView(views, senders[i], own);
    }
    return views;
  }
  SenderViews mirrorViews() const {
    SenderViews views;
    for (size_t i = 0; hasOtherMirrors() && i < scene_->scene->mirrors.size(); ++i) {
      addView(views, scene_->scene->mirrors[i], {});
    }
    return views;
  }
  void addView(SenderViews& views, const SpecularObject& sender, const std::vector<SecondaryRay>& rays) const {
    const CastObjects cast = castObjects(*scene_->scene, &sender);
    const Box box = boundsOf(sender.mesh);
    const auto [width, height] = std::pair(inputs_.referenceSize.x, inputs_.referenceSize.y);
    const std::optional<RayView> fitted = viewOfRays(rays, *cast.mesh, box.center(), width, height);
    // Mirrors among what is cast stand in the midst of it.
    const std::optional<View> plane = sender.isCast
                                          ? referenceView(*cast.mesh, box, width, height, WhatLiesAround::kMayBeLost)
                                          : planeView(*cast.mesh, box, width, height);
    const View view = fitted ? fitted->view : plane.value_or(aroundView(*cast.mesh, box));
    views.references.emplace_back(view, width, height);
    ViewCell cell;
    cell.shape = ViewCell::Shape::kSphere;
    cell.sideRadii = inputs_.cellSide.value_or(fitted ? fitted->cellSide : largestSide(box));
    views.cells.push_back(cell);
  }

  SenderProxies proxiesOf(const SpecularWayName& way) const {
    const auto built = [&](const std::vector<SpecularObject>& senders, const SenderViews& of) {
      std::vector<BuiltProxy> proxies;
      for (size_t i = 0; i < of.references.size(); ++i) {
        const CastObjects cast = castObjects(*scene_->scene, &senders[i]);
        proxies.push_back(
            buildProxy(way, {*scene_->scene, cast, boundsOf(senders[i].mesh).center(), of.references[i], of.cells[i],
                             inputs_.environmentHeight, inputs_.progress, inputs_.caster.get()}));
      }
      return proxies;
    };
    return {built(scene_->senders(), views_), built(scene_->scene->mirrors, mirrorViews_)};
  }

  /// Finer images are no stricter yardsticks: what counts is what the picture shows.
  std::vector<PinholeCamera> atPictureSize(const std::vector<PinholeCamera>& references) const {
    std::vector<PinholeCamera> yardsticks;
    for (const PinholeCamera& reference : references) {
      yardsticks.emplace_back(reference.view(), truth_->size.x, truth_->size.y);
    }
    return yardsticks;
  }

  /// `rays` are those of the way, of the same pixels as the traced ones.
  ShadedWay wayOf(const BuiltProxy& built, const SecondaryRays& rays, const ShadedPicture& picture,
                  const SpecularWayName& name, std::optional<size_t> deviceDiffering = {}) const {
    const Yardsticks yardsticks{atPictureSize(views_.references), atPictureSize(mirrorViews_.references)};
    ShadeFigures row = figuresOf(built, truth_->rays, truth_->picture, picture, yardsticks);
    row.deviceDiffering = deviceDiffering;
    ShadedWay way{.name = built.name, .picture = picture.color};
    if (name.exit) {
      // Other rays meet other things: their hits are neither right nor wrong.
      row.hasDepth = false;
      row.exitDegrees = meanDegreesBetween(rays, truth_->rays);
    }
    if (row.hasDepth && built.name != kTraced) {
      way.maps.push_back({"errors", "where first hits are wrong",
                          hitErrorImage(truth_->rays, truth_->picture,
                                        compareHits(truth_->rays, truth_->picture, picture, yardsticks))});
    }
    if (row.cost.steps() > 0) {
      way.maps.push_back({"steps", "steps of each ray", stepImage(truth_->rays, picture, kBrightestSteps)});
    }
    for (const SpecularFigure& figure : specularFigures()) {
      way.figures.push_back(figure.value(row));
    }
    return way;
  }

  StageInputs inputs_;
  std::shared_ptr<const SpecularScene> scene_;
  int order_;
  bool fitsRays_;
  SenderViews views_;
  SenderViews mirrorViews_;  ///< of rays that go on from mirrors, where those are not the senders
  std::optional<Truth> truth_;
};

void requireSenders(const Specular& specular, const ShadedScene& scene, const char* role) {
  if (specular.senders(scene).empty()) {
    throw InputError(fmt::format("no object of this scene has the role \"{}\"", role), scene.source,
                     "give one that role with --roles FILE.json, or choose another --effect");
  }
  for (const SpecularObject& sender : specular.senders(scene)) {
    if (castObjects(scene, &sender).mesh->empty()) {
      requireCast(scene);
    }
  }
}

Effect specularEffect() {
  static const std::string ways =
      "traced (the geometry), environment (an environment map), or the reference images of a camera, graph cameras "
      "too: a name or a JSON file; with words behind it for how they are met. " +
      wayWordsHelp();
  Effect effect{};
  effect.ways = ways.c_str();
  effect.options = specularOptions();
  for (const SpecularFigure& figure : specularFigures()) {
    effect.columns.push_back(figure.column);
  }
  effect.legend = {{kMissingColor, "missing: the ray meets no sample"},
                   {kFalseSkinColor, "off: the first hit is more than 1.5 footprints away from the traced one"},
                   {kWrongFrontColor, "false: a sample stands before the traced first hit"}};
  static_assert(kBrightestSteps == 48);
  effect.mapNote = "Steps: from dark blue for none over red to white for 48 or more.";
  effect.terms = {
      {"Footprint",
       "What a pixel of the reference view covers at the depth of a hit, if its image were as large as the picture: "
       "depth / focal length in pixels."}};
  effect.checkWay = checkProxyName;
  effect.waysToOffer = proxyNames;
  effect.castsOnDevice = [](const std::string& text) {
    const SpecularWayName way = specularWay(text);
    return way.target != kTraced && way.target != kEnvironment && !way.isStepped() && !namesConstructor(way.target);
  };
  return effect;
}

}  // namespace

Effect reflectionEffect() {
  Effect effect = specularEffect();
  effect.name = "reflection";
  effect.title = "Reflection";
  effect.description = "what objects with the role \"mirror\" reflect";
  effect.checkWay = [](const std::string& way) {
    checkProxyName(way);
    if (specularWay(way).exit) {
      throw InputError("rays do not pass a mirror", "--by " + way,
                       "leave \"expected-exit\" and \"searched-exit\" away, or give --effect refraction");
    }
  };
  effect.requireObjects = [](const ShadedScene& scene) { requireSenders(kReflection, scene, "mirror"); };
  effect.defaultView = [](const ShadedScene& scene) {
    const Box senders = boundsOf(scene.mirrors);
    return unhiddenView(pictureView(senders), scene, senders);
  };
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
  effect.defaultView = [](const ShadedScene& scene) {
    const Box senders = boundsOf(scene.lenses);
    return unhiddenView(pictureView(senders), scene, senders);
  };
  effect.stage = [](const StageInputs& inputs) -> std::unique_ptr<EffectStage> {
    return std::make_unique<SpecularStage>(inputs, kRefraction);
  };
  return effect;
}

}  // namespace ocelli
