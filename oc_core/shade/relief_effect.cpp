#include "oc_core/shade/relief_effect.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "oc_core/base/conventions.h"
#include "oc_core/base/error.h"
#include "oc_core/evaluation/error_image.h"
#include "oc_core/ocri/camera_choice.h"
#include "oc_core/page/html.h"
#include "oc_core/relief/relief_errors.h"
#include "oc_core/relief/relief_kinds.h"

namespace ocelli {
namespace {

constexpr Rgb8 kShadowColor{0, 158, 115};

/// What a way takes to make, and a picture of it.
struct ReliefRow {
  const ReliefPicture& picture;
  ReliefFigures figures;
  bool traced = false;
  size_t texels = 0;
  size_t samples = 0;
  double buildMilliseconds = 0;
  double structureMilliseconds = 0;
};

using ReliefValue = std::optional<double>;

ReliefValue ofTiles(const ReliefRow& row, size_t part) {
  const auto whole = static_cast<double>(std::max<size_t>(row.figures.tilePixels, 1));
  return row.traced ? std::nullopt : ReliefValue(static_cast<double>(part) / whole);
}

ReliefValue ofImages(const ReliefRow& row, double value) {
  return row.traced ? std::nullopt : ReliefValue(value);
}

struct ReliefFigure {
  FigureColumn column;
  ReliefValue (*value)(const ReliefRow&);
};

const std::vector<ReliefFigure>& reliefFigureColumns() {
  static const std::vector<ReliefFigure> figures{
      {{"tile_pixels", nullptr, "that show a tile in the traced picture", 0, 1},
       [](const ReliefRow& r) -> ReliefValue { return static_cast<double>(r.figures.tilePixels); }},
      {{"wrong", "error %",
        "pixels that show a tile in one of both pictures alone, or more than 1.5 footprints off in depth, of the "
        "pixels "
        "of tiles",
        2, 100},
       [](const ReliefRow& r) { return ofTiles(r, r.figures.wrong); }},
      {{"missing", "missing %", "those of them that show something farther away than the traced tile", 2, 100},
       [](const ReliefRow& r) { return ofTiles(r, r.figures.missing); }},
      {{"false_surface", "false %",
        "those that show a point which no surface of the tiles is near: rubber bands across what is empty", 2, 100},
       [](const ReliefRow& r) { return ofTiles(r, r.figures.falseSurface); }},
      {{"psnr_db", "PSNR dB", "of pixels that show a tile in one of both pictures", 2, 1},
       [](const ReliefRow& r) -> ReliefValue { return r.figures.psnrDecibels(); }},
      {{"shadow_wrong", "shadow %",
        "pixels that show the same, and are in shadow in one of both pictures alone; of all "
        "that show the same",
        2, 100},
       [](const ReliefRow& r) {
         return ofImages(r, static_cast<double>(r.figures.shadowWrong) /
                                static_cast<double>(std::max<size_t>(r.figures.sunPixels, 1)));
       }},
      {{"steps_per_ray", "steps", "places of an image that are looked at, a ray and tile", 1, 1},
       [](const ReliefRow& r) {
         return ofImages(
             r, static_cast<double>(r.picture.cost.steps()) / static_cast<double>(std::max<size_t>(r.picture.rays, 1)));
       }},
      {{"texels", "texels", "pixels of the images of all objects", 0, 1},
       [](const ReliefRow& r) { return ofImages(r, static_cast<double>(r.texels)); }},
      {{"samples", "samples", "those that hold something", 0, 1},
       [](const ReliefRow& r) { return ofImages(r, static_cast<double>(r.samples)); }},
      {{"build_ms", "build ms", "of the images; of the acceleration structure where the geometry is traced", 1, 1},
       [](const ReliefRow& r) -> ReliefValue { return r.buildMilliseconds; }},
      {{"structure_ms", "pyramid ms", "of cells and pyramid", 1, 1},
       [](const ReliefRow& r) {
         return r.structureMilliseconds > 0 ? ReliefValue(r.structureMilliseconds) : std::nullopt;
       }},
      {{"picture_ms", "tiles ms", "of the eye rays to tiles; of all eye rays where the geometry is traced", 1, 1},
       [](const ReliefRow& r) -> ReliefValue {
         return r.traced ? r.picture.geometryMilliseconds : r.picture.milliseconds;
       }},
      {{"shadow_ms", "shadow ms", "of the rays to the sun", 1, 1},
       [](const ReliefRow& r) -> ReliefValue { return r.picture.shadowMilliseconds; }},
  };
  return figures;
}

/// The geometry of a tiled scene, ready for rays.
struct TracedScene {
  explicit TracedScene(const TiledScene& scene)
      : flat(scene.flatTiles()), all(together(flat, scene.around)), tiles(flat) {}

  static Mesh together(Mesh mesh, const Mesh& around) {
    append(mesh, around);
    return mesh;
  }
  TracedTiles traced() const { return {all, flat.triangles.size(), tiles}; }

  Mesh flat;
  PlainGeometry all;
  RayScene tiles;
};

/// The objects of a scene by one way, and its tiles.
struct BuiltTiles {
  std::shared_ptr<const ReliefScene> scene;
  size_t texels = 0;
  size_t samples = 0;
  double buildMilliseconds = 0;
  double structureMilliseconds = 0;
};

BuiltTiles buildTiles(const std::string& way, const TiledScene& scene, size_t texels, const Progress& progress) {
  BuiltTiles built;
  ReliefScene::Objects objects;
  for (const Mesh& mesh : scene.objects) {
    const BuiltRelief relief = buildReliefObject(way, mesh, texels, progress);
    built.texels += relief.object->texels();
    built.samples += relief.object->samples();
    built.buildMilliseconds += relief.buildMilliseconds;
    built.structureMilliseconds += relief.structureMilliseconds;
    objects.push_back(relief.object);
  }
  std::vector<ReliefTile> tiles;
  for (const TiledScene::Tile& tile : scene.tiles) {
    tiles.push_back({tile.object, tile.worldFromTile, tile.tint});
  }
  built.scene = std::make_shared<const ReliefScene>(std::move(objects), std::move(tiles));
  return built;
}

class ReliefWay final : public EffectWay {
 public:
  explicit ReliefWay(ReliefRenderer renderer) : renderer_(std::move(renderer)) {}
  Image<glm::vec3> draw(const PinholeCamera& camera) const override { return renderer_.draw(camera).color; }

 private:
  ReliefRenderer renderer_;
};

class TracedReliefWay final : public EffectWay {
 public:
  explicit TracedReliefWay(std::shared_ptr<const TracedScene> scene) : scene_(std::move(scene)) {}
  Image<glm::vec3> draw(const PinholeCamera& camera) const override {
    return traceTiles(scene_->traced(), camera).color;
  }

 private:
  std::shared_ptr<const TracedScene> scene_;
};

/// Near is light; the background black.
Image<Rgb8> depthMap(const ReliefPicture& picture, const ReliefPicture& truth) {
  float nearest = 1e30f;
  float farthest = 0;
  for (const float z : truth.z) {
    nearest = z > 0 ? std::min(nearest, z) : nearest;
    farthest = std::max(farthest, z);
  }
  const float depth = std::max(farthest - nearest, 1e-20f);
  Image<Rgb8> map(picture.z.width(), picture.z.height(), Rgb8(0, 0, 0));
  for (size_t i = 0; i < map.size(); ++i) {
    if (picture.z[i] > 0) {
      const float share = std::clamp((picture.z[i] - nearest) / depth, 0.0f, 1.0f);
      map[i] = Rgb8(static_cast<uint8_t>(235 - 190 * share));
    }
  }
  return map;
}

Image<Rgb8> reliefErrorMap(const ReliefPicture& truth, const ReliefPicture& picture, const Image<ReliefState>& states) {
  constexpr float kDimmed = 0.12f;
  Image<glm::vec3> dimmed(truth.color.width(), truth.color.height());
  for (size_t i = 0; i < dimmed.size(); ++i) {
    dimmed[i] = truth.color[i] * kDimmed;
  }
  Image<Rgb8> map = srgbFromLinear(dimmed);
  for (size_t i = 0; i < states.size(); ++i) {
    switch (states[i]) {
      case ReliefState::kElsewhere:
      case ReliefState::kRight:
        map[i] = truth.inShadow[i] != picture.inShadow[i] ? kShadowColor : map[i];
        break;
      case ReliefState::kMissing:
        map[i] = kMissingColor;
        break;
      case ReliefState::kFalse:
        map[i] = kFalseSkinColor;
        break;
      case ReliefState::kOther:
        map[i] = kWrongFrontColor;
        break;
    }
  }
  return map;
}

class ReliefStage final : public EffectStage {
 public:
  explicit ReliefStage(const StageInputs& inputs) : inputs_(inputs) {
    if (inputs.cellSide) {
      throw InputError("the cell that relief tiles are made for is always the same", "--cell", "leave it out");
    }
    const auto start = std::chrono::steady_clock::now();
    traced_ = std::make_shared<const TracedScene>(tiled());
    tracedBuildMilliseconds_ =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    around_ = std::make_shared<const PlainGeometry>(tiled().around);
  }

  std::unique_ptr<EffectWay> build(const std::string& way) const override {
    if (way == kTraced) {
      return std::make_unique<TracedReliefWay>(traced_);
    }
    return std::make_unique<ReliefWay>(ReliefRenderer(builtBy(way).scene, around_));
  }

  void checkView(const PinholeCamera& camera) const override {
    for (int y = 0; y < camera.height(); ++y) {
      for (int x = 0; x < camera.width(); ++x) {
        const RayPath path = camera.rayPath({static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f});
        if (traced_->tiles.intersect(path).covered()) {
          return;
        }
      }
    }
    throw InputError("the picture shows no relief tile", "--view", "move the eye, or leave --view out");
  }

  ShadedWay measure(const std::string& way, const PinholeCamera& camera, int runs) override {
    if (way == kTraced) {
      truth_ = Truth{camera, traceTiles(traced_->traced(), camera, {.runs = runs})};
      ReliefRow row{.picture = truth_->picture, .figures = {}, .traced = true};
      row.figures = reliefFigures(truth_->picture, truth_->picture, statesOf(truth_->picture));
      row.buildMilliseconds = tracedBuildMilliseconds_;
      ShadedWay measured = wayOf(way, row);
      measured.maps.push_back({"depth", "depth of each pixel", depthMap(truth_->picture, truth_->picture)});
      return measured;
    }
    prepareTruth(camera);
    const BuiltTiles built = builtBy(way);
    const ReliefPicture picture = ReliefRenderer(built.scene, around_).draw(camera, {.runs = runs});
    const Image<ReliefState> states = statesOf(picture);
    ReliefRow row{.picture = picture, .figures = reliefFigures(truth_->picture, picture, states)};
    row.texels = built.texels;
    row.samples = built.samples;
    row.buildMilliseconds = built.buildMilliseconds;
    row.structureMilliseconds = built.structureMilliseconds;
    ShadedWay measured = wayOf(way, row);
    measured.maps.push_back(
        {"errors", "where surfaces and shadows are wrong", reliefErrorMap(truth_->picture, picture, states)});
    measured.maps.push_back({"depth", "depth of each pixel", depthMap(picture, truth_->picture)});
    return measured;
  }

  std::vector<ShadeFact> facts(const PinholeCamera& camera) override {
    prepareTruth(camera);
    size_t pixels = 0;
    for (const int32_t shown : truth_->picture.shown) {
      pixels += shown >= 0;
    }
    const size_t triangles = traced_->flat.triangles.size();
    return {{"tiles", std::to_string(tiled().tiles.size()),
             fmt::format("Tiles: {}. Different objects: {}. Where they are traced, they have {} triangles.",
                         groupedDigits(tiled().tiles.size()), tiled().objects.size(), groupedDigits(triangles))},
            {"objects", std::to_string(tiled().objects.size())},
            {"tile_triangles", std::to_string(triangles)},
            {"tile_pixels", std::to_string(pixels),
             fmt::format("{} pixels of the picture show a tile.", groupedDigits(pixels))},
            {"texels_wanted", std::to_string(texels()),
             fmt::format("Images of about {} pixels.", groupedDigits(texels()))}};
  }

 private:
  struct Truth {
    PinholeCamera camera;
    ReliefPicture picture;
  };

  const TiledScene& tiled() const { return *inputs_.scene->tiled; }
  size_t texels() const {
    return static_cast<size_t>(inputs_.referenceSize.x) * static_cast<size_t>(inputs_.referenceSize.y);
  }
  BuiltTiles builtBy(const std::string& way) const { return buildTiles(way, tiled(), texels(), inputs_.progress); }

  void prepareTruth(const PinholeCamera& camera) {
    if (!truth_ || !(truth_->camera == camera)) {
      measure(kTraced, camera, 1);
    }
  }

  Image<ReliefState> statesOf(const ReliefPicture& picture) const {
    return reliefStates(truth_->picture, picture, traced_->tiles, truth_->camera);
  }

  static ShadedWay wayOf(const std::string& name, const ReliefRow& row) {
    ShadedWay way{.name = name, .picture = row.picture.color};
    for (const ReliefFigure& figure : reliefFigureColumns()) {
      way.figures.push_back(figure.value(row));
    }
    return way;
  }

  StageInputs inputs_;
  std::shared_ptr<const TracedScene> traced_;
  std::shared_ptr<const PlainGeometry> around_;
  double tracedBuildMilliseconds_ = 0;
  std::optional<Truth> truth_;
};

/// Nearer than that of other effects, and somewhat from the right, so that near tiles are larger and stand before
/// others; as wide as the tiles are from there.
View tilesView(const ShadedScene& scene) {
  constexpr float kDistance = 3.2f;  // radii of the tiles
  constexpr double kProportions = 1.5;
  const Box box = boundsOf(scene.tiled->flatTiles());
  const float radius = std::max(glm::length(box.size()) / 2, 1e-6f);
  View view;
  view.target = box.center();
  view.eye = view.target + glm::normalize(glm::vec3(0.45f, 0, 1)) * (kDistance * radius);
  view.zNear = 0.01f * radius;
  return viewAround(view, box, kProportions);
}

}  // namespace

Effect reliefEffect() {
  Effect effect{};
  effect.name = "relief";
  effect.title = "Relief tiles";
  effect.description = "objects with the role \"relief\", each by one image, wherever copies of it stand";
  static const std::string ways = std::string("traced (the geometry), ") + kReliefKindsHelp;
  effect.ways = ways.c_str();
  for (const ReliefFigure& figure : reliefFigureColumns()) {
    effect.columns.push_back(figure.column);
  }
  effect.legend = {{kMissingColor, "missing: something farther away is seen in the place of a tile"},
                   {kFalseSkinColor, "false: a surface that the object does not have"},
                   {kWrongFrontColor, "a surface that there is, but not where it is seen"},
                   {kShadowColor, "the right surface, in shadow in one of both pictures alone"}};
  effect.mapNote = "Depth: near is light.";
  effect.terms = {{"Footprint", "What a pixel of the picture covers: depth / focal length in pixels."},
                  {"Texel", "A pixel of the image that a tile carries."}};
  effect.checkWay = [](const std::string& way) {
    if (way != kTraced) {
      checkReliefKind(way);
    }
  };
  effect.waysToOffer = [] {
    std::vector<std::string> names = camerasWithImages();
    names.insert(names.begin(), {"height-field", "layered-4"});
    return names;
  };
  effect.requireObjects = [](const ShadedScene& scene) {
    if (scene.tiled == nullptr || scene.tiled->tiles.empty()) {
      throw InputError("no object of this scene has the role \"relief\"", scene.source,
                       "give one that role with --roles FILE.json, take builtin:parking, or choose another --effect");
    }
  };
  effect.defaultView = tilesView;
  effect.stage = [](const StageInputs& inputs) -> std::unique_ptr<EffectStage> {
    return std::make_unique<ReliefStage>(inputs);
  };
  effect.referenceSize = {512, 512};
  return effect;
}

}  // namespace ocelli
