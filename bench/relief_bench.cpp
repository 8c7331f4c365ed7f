// Relief tiles against traced geometry over many views of one tile, 10 to 60 degrees over the ground (section 3.5.2.4):
// pixels in error, false surfaces, texels, and times, for conventional relief and for images of occlusion cameras.
//
// Times are those of the CPU, all threads together, for the eye rays of a picture: the mean over views of the least of
// several runs. Pictures are without shadows.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "oc_core/base/conventions.h"
#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/image/png_file.h"
#include "oc_core/relief/relief_errors.h"
#include "oc_core/relief/relief_kinds.h"
#include "oc_core/scene/scene.h"
#include "oc_core/worlds/parked_things.h"
#include "oc_core/worlds/scene_source.h"

namespace ocelli {
namespace {

struct ReliefBenchChoice {
  std::vector<std::string> objects{"car", "barrel", "builtin:teapot"};
  std::vector<std::string> ways{"height-field", "height-field-512", "layered-4", "di", "spoc", "cell"};
  int views = 200;
  double distance = 4;
  int width = 640;
  int height = 480;
  size_t texels = 512 * 512;
  int runs = 1;
  std::string json;
  std::string pictures;
};

/// In the unit sphere, without light.
Mesh objectNamed(const std::string& name) {
  if (name != "car" && name != "barrel") {
    SceneOptions options;
    options.shading = Shading::kNone;
    return loadScene(name, options);
  }
  Mesh mesh = name == "car" ? makeCar() : makeBarrel();
  transform(mesh, unitFromWorld(mesh, name));
  return mesh;
}

/// Spread over all sides and over the elevations.
View viewNumber(int i, int views, double distance) {
  constexpr double kGoldenTurn = 0.6180339887498949;
  const double elevation = radiansFromDegrees(10 + 50 * (i + 0.5) / views);
  const double azimuth = 2 * 3.141592653589793 * std::fmod(i * kGoldenTurn, 1.0);
  View view;
  view.eye = glm::vec3(glm::dvec3(std::cos(elevation) * std::sin(azimuth), std::sin(elevation),
                                  std::cos(elevation) * std::cos(azimuth)) *
                       distance);
  view.fovVerticalDegrees = 29;  // holds the unit sphere from 4 radii away
  return view;
}

Rgb8 colorOf(ReliefState state, const glm::vec3& shown) {
  switch (state) {
    case ReliefState::kMissing:
      return {240, 150, 30};
    case ReliefState::kFalse:
      return {230, 40, 160};
    case ReliefState::kOther:
      return {60, 120, 240};
    case ReliefState::kElsewhere:
    case ReliefState::kRight:
      break;
  }
  const auto grey = static_cast<uint8_t>(std::min(90.0f, 90 * (shown.x + shown.y + shown.z) / 3));
  return {grey, grey, grey};
}

struct WayTotals {
  ReliefFigures figures = {};
  double milliseconds = 0;
  RayCost cost = {};
  size_t rays = 0;
};

void savePictures(const std::string& folder, const std::string& name, const ReliefPicture& picture,
                  const Image<ReliefState>* states) {
  writePng(std::filesystem::path(folder) / (name + ".png"), srgbFromLinear(picture.color));
  if (states == nullptr) {
    return;
  }
  Image<Rgb8> map(picture.color.width(), picture.color.height());
  for (size_t i = 0; i < map.size(); ++i) {
    map[i] = colorOf((*states)[i], picture.color[i]);
  }
  writePng(std::filesystem::path(folder) / (name + "-errors.png"), map);
}

nlohmann::json measureObject(const ReliefBenchChoice& choice, const std::string& object) {
  const Mesh mesh = objectNamed(object);
  const PlainGeometry geometry(mesh);
  const TracedTiles traced{geometry, mesh.triangles.size(), geometry.rays()};
  fmt::print("\n{}: {} triangles, {} views of {}x{}\n", object, mesh.triangles.size(), choice.views, choice.width,
             choice.height);
  fmt::print("  {:<18}{:>9}{:>9}{:>9}{:>9}{:>9}{:>8}{:>9}{:>9}{:>9}{:>9}{:>8}{:>8}\n", "by", "error %", "of hf's",
             "missing", "false", "other", "PSNR", "texels", "samples", "build ms", "pyramid", "cpu ms", "steps");
  std::vector<BuiltRelief> built;
  std::vector<std::unique_ptr<ReliefRenderer>> renderers;
  for (const std::string& way : choice.ways) {
    built.push_back(buildReliefObject(way, mesh, choice.texels));
    const auto scene = std::make_shared<const ReliefScene>(ReliefScene::Objects{built.back().object},
                                                           std::vector<ReliefTile>{ReliefTile{}});
    renderers.push_back(std::make_unique<ReliefRenderer>(scene, nullptr));
  }
  std::vector<WayTotals> totals(choice.ways.size());
  const ReliefDrawing how{.runs = choice.runs, .shadows = false};
  for (int i = 0; i < choice.views; ++i) {
    const PinholeCamera camera(viewNumber(i, choice.views, choice.distance), choice.width, choice.height);
    const ReliefPicture truth = traceTiles(traced, camera, how);
    const bool saves = !choice.pictures.empty() && i % std::max(1, choice.views / 4) == 0;
    if (saves) {
      savePictures(choice.pictures, fmt::format("{}-{}-traced", std::filesystem::path(object).stem().string(), i),
                   truth, nullptr);
    }
    for (size_t way = 0; way < renderers.size(); ++way) {
      const ReliefPicture picture = renderers[way]->draw(camera, how);
      const Image<ReliefState> states = reliefStates(truth, picture, geometry.rays(), camera);
      totals[way].figures += reliefFigures(truth, picture, states);
      totals[way].milliseconds += picture.cpuMilliseconds;
      totals[way].cost += picture.cost;
      totals[way].rays += picture.rays;
      if (saves) {
        savePictures(choice.pictures,
                     fmt::format("{}-{}-{}", std::filesystem::path(object).stem().string(), i, choice.ways[way]),
                     picture, &states);
      }
    }
  }
  nlohmann::json rows = nlohmann::json::array();
  const double views = choice.views;
  const double ofFirst = totals.empty() ? 0 : totals[0].figures.wrongShare();
  for (size_t way = 0; way < totals.size(); ++way) {
    const WayTotals& total = totals[way];
    const ReliefFigures& f = total.figures;
    const double whole = std::max<double>(1, static_cast<double>(f.tilePixels)) / 100;
    const double steps = total.rays > 0 ? static_cast<double>(total.cost.steps()) / static_cast<double>(total.rays) : 0;
    fmt::print("  {:<18}{:>9.2f}{:>9.3f}{:>9.2f}{:>9.2f}{:>9.2f}{:>8.1f}{:>9}{:>9}{:>9.0f}{:>9.0f}{:>8.2f}{:>8.1f}\n",
               choice.ways[way], 100 * f.wrongShare(), ofFirst > 0 ? f.wrongShare() / ofFirst : 0,
               static_cast<double>(f.missing) / whole, static_cast<double>(f.falseSurface) / whole,
               static_cast<double>(f.other) / whole, f.psnrDecibels(), built[way].object->texels(),
               built[way].object->samples(), built[way].buildMilliseconds, built[way].structureMilliseconds,
               total.milliseconds / views, steps);
    rows.push_back({{"by", choice.ways[way]},
                    {"wrong_share", f.wrongShare()},
                    {"missing_share", static_cast<double>(f.missing) / whole / 100},
                    {"false_share", static_cast<double>(f.falseSurface) / whole / 100},
                    {"psnr_db", f.psnrDecibels()},
                    {"texels", built[way].object->texels()},
                    {"samples", built[way].object->samples()},
                    {"build_ms", built[way].buildMilliseconds},
                    {"structure_ms", built[way].structureMilliseconds},
                    {"picture_cpu_ms", total.milliseconds / views},
                    {"steps_per_ray", steps}});
  }
  std::fflush(stdout);
  return {{"object", object}, {"triangles", mesh.triangles.size()}, {"views", choice.views}, {"ways", rows}};
}

int run(int argc, char** argv) {
  CLI::App app("Relief tiles against traced geometry over many views");
  ReliefBenchChoice choice;
  app.add_option("--objects", choice.objects, "car, barrel, or scenes")->delimiter(',');
  app.add_option("--ways", choice.ways, kReliefKindsHelp)->delimiter(',');
  app.add_option("--views", choice.views, "Views of each object")->check(CLI::Range(1, 100000));
  app.add_option("--distance", choice.distance, "Of the eye, in radii of the object; the field of view stays the same")
      ->check(CLI::Range(1.5, 1000.0));
  app.add_option("--width", choice.width, "Of the pictures")->check(CLI::Range(1, 8192));
  app.add_option("--height", choice.height, "Of the pictures")->check(CLI::Range(1, 8192));
  app.add_option("--texels", choice.texels, "Of an image")->check(CLI::Range(1, 1 << 26));
  app.add_option("--runs", choice.runs, "How often each picture is timed")->check(CLI::Range(1, 1000));
  app.add_option("--json", choice.json, "Also write the figures here");
  app.add_option("--pictures", choice.pictures, "Folder for the pictures of four of the views");
  CLI11_PARSE(app, argc, argv);
  nlohmann::json objects = nlohmann::json::array();
  for (const std::string& object : choice.objects) {
    objects.push_back(measureObject(choice, object));
  }
  if (!choice.json.empty()) {
    writeFile(choice.json, objects.dump(2) + "\n");
  }
  return 0;
}

}  // namespace
}  // namespace ocelli

int main(int argc, char** argv) {
  try {
    return ocelli::run(argc, argv);
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
}
