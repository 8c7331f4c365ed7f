// What ways of antialiasing cost, and how far their images are from the truth (section 5.3.3): scenes in which much
// complexity lies in few clusters, drawn in turn in the same run by `none`, multisampling, samples everywhere, areas,
// and extreme antialiasing with tiles of several sizes.
//
// Error is the RMSE of linear colours over the image, and over the pixels of the clusters alone, against 16,384
// jittered samples a pixel (four images of 64 x 64 whose pixels take other patterns), and FLIP of the sRGB images.
// Flicker: the RMSE of how a pixel changes from one image to the next in a camera's motion of small steps, against how
// it should. Times are of the wall clock on --threads threads, the least of --runs, from the mesh to the image.
#include <cmath>
#include <cstdio>

#include "bench/bench_program.h"
#include "bench/timing.h"
#include "oc_core/antialiasing/antialias_option.h"
#include "oc_core/base/random.h"
#include "oc_core/evaluation/flip.h"
#include "oc_core/image/png_file.h"
#include "oc_core/worlds/scene_source.h"

namespace ocelli {
namespace {

struct AntialiasingChoice {
  std::vector<std::string> scenes{"clusters,10000", "clusters,100000", "clusters,1000000"};
  std::vector<std::string> ways{"none",
                                "msaa-4",
                                "msaa-16",
                                "uniform-16",
                                "uniform-64",
                                "uniform-256",
                                "uniform-400",
                                "uniform-1024",
                                "area-256",
                                "area-400",
                                "extreme,tile=320x360",
                                "extreme,tile=640x720",
                                "extreme,tile=1280x1440"};
  int runs = 3;
  int threads = 1;
  int width = 1280;
  int height = 720;
  int truthImages = 4;
  double distance = 0;  ///< of the eye; 0: that of the scene
  int steps = 0;
  bool thinLines = false;
  std::string images;
};

struct BenchScene {
  Mesh mesh;
  View view;
  std::vector<uint32_t> objects{};
};

/// Two clusters of square particles over a terrain (Figure 5.11).
BenchScene clusters(size_t particles) {
  Random random(5);
  BenchScene scene;
  Mesh& mesh = scene.mesh;
  const auto square = [&](const glm::vec3& at, const glm::vec3& right, const glm::vec3& up, const glm::vec3& color) {
    const auto first = static_cast<uint32_t>(mesh.positions.size());
    for (const glm::vec2 corner : {glm::vec2(-1, -1), {1, -1}, {1, 1}, {-1, 1}}) {
      mesh.positions.push_back(at + right * corner.x + up * corner.y);
      mesh.colors.push_back(color);
    }
    mesh.triangles.emplace_back(first, first + 1, first + 2);
    mesh.triangles.emplace_back(first, first + 2, first + 3);
  };
  for (int x = -10; x < 10; ++x) {
    for (int z = -10; z < 10; ++z) {
      const float shade = (x + z) % 2 == 0 ? 0.55f : 0.4f;
      square({static_cast<float>(x) * 0.6f, -1, static_cast<float>(z) * 0.6f}, {0.3f, 0, 0}, {0, 0, 0.3f},
             {shade, shade * 0.9f, 0.1f});
    }
  }
  // The larger their number, the smaller they are: they cover about as much.
  const float half = 0.25f / std::sqrt(static_cast<float>(particles)) * 1.5f;
  for (int cluster = 0; cluster < 2; ++cluster) {
    const glm::vec3 middle = cluster == 0 ? glm::vec3(-1.1f, -0.3f, 0) : glm::vec3(1.3f, -0.1f, -1);
    const glm::vec3 color = cluster == 0 ? glm::vec3(0.05f, 0.7f, 0.2f) : glm::vec3(0.9f, 0.1f, 0.05f);
    for (size_t i = 0; i < particles; ++i) {
      glm::vec3 in;
      do {
        in = {random.inRange(-1, 1), random.inRange(-1, 1), random.inRange(-1, 1)};
      } while (glm::dot(in, in) > 1);
      glm::vec3 a(random.inRange(-1, 1), random.inRange(-1, 1), random.inRange(-1, 1));
      a = glm::normalize(a + glm::vec3(0, 0, 1e-3f));
      const glm::vec3 b = glm::normalize(glm::cross(a, glm::vec3(random.inRange(-1, 1), random.inRange(-1, 1), 1.1f)));
      square(middle + in * 0.3f, a * half, b * half,
             glm::mix(color, glm::vec3(0.02f, 0.05f, 0.8f), random.inRange(0, 1)));
    }
  }
  scene.view.eye = {0, 1, 6};
  scene.view.target = {0, -0.3f, 0};
  scene.view.fovVerticalDegrees = 35;
  return scene;
}

BenchScene sceneOf(const std::string& source, double distance) {
  const std::string kClusters = "clusters,";
  if (source.starts_with(kClusters)) {
    return clusters(std::stoul(source.substr(kClusters.size())));
  }
  GuidedScene loaded = loadGuidedScene(source);
  BenchScene scene{std::move(loaded.mesh), {}, std::move(loaded.objectOfTriangle)};
  scene.view.fovVerticalDegrees = View{}.resolvedFovVerticalDegrees();
  if (distance > 0) {
    scene.view.eye.z = static_cast<float>(distance);
  }
  return scene;
}

constexpr glm::vec3 kSky(0.15f, 0.25f, 0.45f);

double rmseOver(const Image<glm::vec3>& a, const Image<glm::vec3>& b, const Image<uint8_t>& mask) {
  double sum = 0;
  double count = 0;
  for (size_t i = 0; i < a.size(); ++i) {
    if (mask[i] != 0) {
      const glm::dvec3 d = glm::dvec3(a[i]) - glm::dvec3(b[i]);
      sum += glm::dot(d, d) / 3;
      count += 1;
    }
  }
  return count > 0 ? std::sqrt(sum / count) : 0;
}

/// Four images with patterns of their own are one with four times the samples.
Image<glm::vec3> truthOf(const AntialiasScene& scene, int images) {
  static const SamplePlacement kShifted[] = {
      {"a", "", [](int i, int k, int n, uint32_t p) { return findSamplePlacement("jittered")->inStratum(i, k, n, p); },
       true},
      {"b", "",
       [](int i, int k, int n, uint32_t p) { return findSamplePlacement("jittered")->inStratum(i, k, n, p + 64); },
       true},
      {"c", "",
       [](int i, int k, int n, uint32_t p) { return findSamplePlacement("jittered")->inStratum(i, k, n, p + 128); },
       true},
      {"d", "",
       [](int i, int k, int n, uint32_t p) { return findSamplePlacement("jittered")->inStratum(i, k, n, p + 192); },
       true}};
  Image<glm::vec3> sum(scene.view().width(), scene.view().height());
  for (int image = 0; image < images; ++image) {
    const PixelRule rule{std::make_shared<SamplePattern>(64, kShifted[image % 4]), false, 0};
    const Image<glm::vec3> each = scene.draw({{rule}, {}}, kSky);
    for (size_t i = 0; i < sum.size(); ++i) {
      sum[i] += each[i] / static_cast<float>(images);
    }
  }
  return sum;
}

Image<glm::vec3> drawWay(const AntialiasChoice& way, const PinholeCamera& camera, const BenchScene& of) {
  const AntialiasScene scene(camera, of.mesh);
  return scene.draw(antialiasPlan(way, camera, antialiasRegions(way, scene, of.objects)), kSky);
}

/// Lines 0.3 pixels thick in an image of 144x144, turned from an angle on in ten steps of 0.03 degrees: the RMSE
/// against exact areas, the mean of the steps, and that of how pixels change from step to step.
void measureThinLines() {
  View view;
  view.eye = {72, 72, 144};
  view.target = {72, 72, 0};
  view.fovVerticalDegrees = 53.13010235;  // a pixel is one unit of the plane z = 0
  const PinholeCamera camera(view, 144, 144);
  const Image<uint8_t> all(144, 144, 1);
  const auto linesAt = [](double degrees) {
    Mesh mesh;
    const double turn = degrees * 3.14159265358979 / 180;
    const glm::dvec2 along(std::cos(turn), std::sin(turn));
    const glm::dvec2 across(-along.y, along.x);
    for (int line = 0; line < 24; ++line) {
      const glm::dvec2 middle = glm::dvec2(72, 72) + across * (line * 6.03 - 69);
      const auto first = static_cast<uint32_t>(mesh.positions.size());
      for (const glm::dvec2 corner : {glm::dvec2(-160, -0.15), {160, -0.15}, {160, 0.15}, {-160, 0.15}}) {
        mesh.positions.emplace_back(glm::vec2(middle + along * corner.x + across * corner.y), 0);
      }
      mesh.triangles.emplace_back(first, first + 1, first + 2);
      mesh.triangles.emplace_back(first, first + 2, first + 3);
    }
    return mesh;
  };
  const auto rowOf = [&](const std::string& name, const PixelRule& rule) {
    fmt::print("  {:<24}", name);
    for (const double from : {-0.15, 20.0}) {
      double error = 0;
      double flicker = 0;
      Image<glm::vec3> before;
      Image<glm::vec3> trueBefore;
      for (int step = 0; step < 10; ++step) {
        const Mesh mesh = linesAt(from + step * 0.03);
        const AntialiasScene scene(camera, mesh);
        const Image<glm::vec3> image = scene.draw({{rule}, {}}, glm::vec3(0));
        PixelRule exact = rule;
        exact.maxExactTriangles = 16;
        const Image<glm::vec3> truth = scene.draw({{exact}, {}}, glm::vec3(0));
        error += rmseOver(image, truth, all) / 10;
        if (step > 0) {
          Image<glm::vec3> change(144, 144);
          for (size_t i = 0; i < change.size(); ++i) {
            change[i] = image[i] - before[i] - truth[i] + trueBefore[i];
          }
          flicker += rmseOver(change, Image<glm::vec3>(144, 144), all) / 9;
        }
        before = image;
        trueBefore = truth;
      }
      fmt::print("  from {:>5.2f} degrees: rmse {:.5f} flicker {:.5f}", from, error, flicker);
    }
    fmt::print("\n");
  };
  rowOf("msaa-16", {std::make_shared<SamplePattern>(SamplePattern::multisample(16)), true, 0});
  for (const SamplePlacement& each : samplePlacements()) {
    for (const int side : {4, 8, 20}) {
      rowOf(fmt::format("uniform-{}, {}", side * side, each.name),
            {std::make_shared<SamplePattern>(side, each), false, 0});
    }
  }
}

/// How much more a pixel changes than it should, from step to step.
void measureFlicker(const AntialiasingChoice& choice, const BenchScene& scene) {
  std::vector<std::vector<Image<glm::vec3>>> frames(choice.ways.size());
  std::vector<Image<glm::vec3>> truth;
  Image<uint8_t> all(choice.width, choice.height, 1);
  for (int step = 0; step < choice.steps; ++step) {
    View view = scene.view;
    view.eye.x += static_cast<float>(step) * 0.002f;
    view.eye.y += static_cast<float>(step) * 0.0005f;
    const PinholeCamera camera(view, choice.width, choice.height);
    truth.push_back(truthOf(AntialiasScene(camera, scene.mesh), 1));
    for (size_t way = 0; way < choice.ways.size(); ++way) {
      frames[way].push_back(drawWay(antialiasChoice(choice.ways[way], "--ways"), camera, scene));
    }
  }
  for (size_t way = 0; way < choice.ways.size(); ++way) {
    double sum = 0;
    for (size_t step = 1; step < truth.size(); ++step) {
      Image<glm::vec3> change(choice.width, choice.height);
      Image<glm::vec3> should(choice.width, choice.height);
      for (size_t i = 0; i < change.size(); ++i) {
        change[i] = frames[way][step][i] - frames[way][step - 1][i];
        should[i] = truth[step][i] - truth[step - 1][i];
      }
      sum += rmseOver(change, should, all);
    }
    fmt::print("  flicker {:<40} {:.6f}\n", choice.ways[way], sum / static_cast<double>(truth.size() - 1));
  }
}

void measureScene(const AntialiasingChoice& choice, const std::string& source) {
  const BenchScene scene = sceneOf(source, choice.distance);
  const PinholeCamera camera(scene.view, choice.width, choice.height);
  const AntialiasScene standing(camera, scene.mesh);
  const Image<glm::vec3> truth = truthOf(standing, choice.truthImages);
  const Image<Rgb8> truthShown = srgbFromLinear(truth);
  Image<uint8_t> dense(choice.width, choice.height);
  for (const PixelBounds& box : denseRectangles(standing, 1)) {
    for (int y = box.y0; y < box.y1; ++y) {
      std::fill(&dense(box.x0, y), &dense(box.x0, y) + (box.x1 - box.x0), 1);
    }
  }
  const Image<uint8_t> all(choice.width, choice.height, 1);
  std::vector<AntialiasChoice> ways;
  for (const std::string& each : choice.ways) {
    ways.push_back(antialiasChoice(each, "--ways"));
  }
  std::vector<double> best(ways.size(), 1e30);
  double prepared = 1e30;
  for (int run = 0; run < choice.runs; ++run) {
    prepared = std::min(prepared, processorMilliseconds([&] { AntialiasScene(camera, scene.mesh); }));
    for (size_t way = 0; way < ways.size(); ++way) {
      best[way] = std::min(best[way], processorMilliseconds([&] { drawWay(ways[way], camera, scene); }));
    }
  }
  fmt::print("{}: {} triangles, {}x{}; projecting and binning {:.1f} ms of each\n", source, scene.mesh.triangles.size(),
             choice.width, choice.height, prepared);
  for (const AntialiasRegion& each : antialiasRegions(ways.back(), standing, scene.objects)) {
    fmt::print("  region {}x{} at ({}, {}): {} x {} samples a pixel by the last way, {:.1f} triangles a pixel\n",
               each.box.x1 - each.box.x0, each.box.y1 - each.box.y0, each.box.x0, each.box.y0, each.side, each.side,
               each.trianglesPerPixel);
  }
  for (size_t way = 0; way < ways.size(); ++way) {
    const Image<glm::vec3> image = drawWay(ways[way], camera, scene);
    const Image<Rgb8> shown = srgbFromLinear(image);
    fmt::print("  {:<40} {:>9.1f} ms  rmse {:.6f}  in clusters {:.6f}  FLIP {:.5f}\n", choice.ways[way], best[way],
               rmseOver(image, truth, all), rmseOver(image, truth, dense), flip(shown, truthShown));
    std::fflush(stdout);
    if (!choice.images.empty()) {
      writePng(fmt::format("{}-{}.png", choice.images, choice.ways[way].substr(0, choice.ways[way].find(','))), shown);
    }
  }
  if (choice.steps > 1) {
    measureFlicker(choice, scene);
  }
}

void measureAntialiasing(const AntialiasingChoice& choice) {
  if (choice.thinLines) {
    measureThinLines();
  }
  for (const std::string& each : choice.scenes) {
    measureScene(choice, each);
  }
}

}  // namespace
}  // namespace ocelli

int main(int argumentCount, char** arguments) {
  CLI::App program{"What antialiasing costs, and how far it is from the truth", "antialiasing_bench"};
  ocelli::AntialiasingChoice choice;
  ocelli::addCommonOptions(program, choice);
  program.add_option("--scenes", choice.scenes, "clusters,PARTICLES, or scenes as `ocelli render` takes them");
  program.add_option("--ways", choice.ways, "As --antialias of `ocelli render`");
  program.add_option("--truth-images", choice.truthImages, "Of 4,096 samples a pixel each")->check(CLI::Range(1, 4));
  program.add_option("--distance", choice.distance, "Of the eye from a scene's middle")->check(CLI::Range(0.0, 1000.0));
  program.add_option("--steps", choice.steps, "Of the camera's motion for flicker; 0: none")
      ->check(CLI::Range(0, 1000));
  program.add_flag("--thin-lines", choice.thinLines, "Placements of samples on thin lines, too");
  program.add_option("--images", choice.images, "Where images go, without \"-WAY.png\"");
  return ocelli::runProgram(program, argumentCount, arguments, choice, ocelli::measureAntialiasing);
}
