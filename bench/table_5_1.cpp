// Table 5.1 of the dissertation, measured again: how long the techniques of section 5.2.1.3 take for the image of a
// general pinhole camera of a terrain, as its triangles grow in number.
//
// "pinhole" is the image of the reference, for comparison. "straight" projects vertices alone and joins them by
// straight edges, the text's conventional rasterisation, which is not exact. "pieces" is the renderer of
// oc_core/render/ rasterize_gpc.h, "bent" the same without straight edges of small triangles, which evaluates each
// pixel of a transition as the text's non-linear rasterisation does. "subdivided" splits triangles down to a pixel,
// "OpenGL" does so with the context of --provider. "rays" are cast with an acceleration structure that stands, "rays,
// fresh" with one that is built for the image.
//
// How well images agree is measured against "rays": the share of pixels with another coverage or depth, and FLIP and
// PSNR of the colours.
//
// All take turns; a time is the least of --runs runs, after one that is not counted. Prints rows of a table in
// Markdown.
#include <cstdio>
#include <functional>

#include "bench/bench_program.h"
#include "bench/timing.h"
#include "oc_core/evaluation/flip.h"
#include "oc_core/gl/gl_renderer.h"
#include "oc_core/image/image_error.h"
#include "oc_core/image/png_file.h"
#include "oc_core/render/draw_parallel.h"
#include "oc_core/render/gpc_vertices.h"
#include "oc_core/render/rasterize.h"
#include "oc_core/render/rasterize_gpc.h"
#include "oc_core/render/raycast.h"
#include "oc_core/worlds/scene_source.h"

namespace ocelli {
namespace {

struct TableChoice {
  std::string scene = "builtin:canyon,triangles={}";
  std::vector<size_t> triangles{120'000, 500'000, 2'000'000};
  std::string sampling = "quadratic";
  std::string provider = "auto";
  int runs = 3;
  int threads = 0;
  int width = 1200;
  int height = 720;
  bool openGl = true;
};

struct TableTechnique {
  const char* name;
  const char* published;  ///< Hz of the text's table for 0.12, 0.5 and 2 million triangles
  bool isSlow;            ///< measured once
  std::function<FragmentImage()> draw;
  double best = 1e30;
  FragmentImage image{};
};

/// Vertices are projected, and edges are straight: what the text compares with.
FragmentImage drawStraight(const GpcCamera& camera, const Mesh& mesh) {
  const ProjectedMesh projected(camera.reference(), mesh);
  std::vector<GpcRasterZone> zones;
  zones.reserve(camera.map().zones().size());
  for (const GpcZone& zone : camera.map().zones()) {
    zones.emplace_back(zone, static_cast<uint32_t>(zones.size()), glm::ivec2(camera.width(), camera.height()));
  }
  const GpcVertices vertices(zones, projected);
  return drawParallel(
      camera.width(), camera.height(), mesh.triangles.size(), [&](VisibilityBuffer& buffer, size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i) {
          const glm::uvec3& t = mesh.triangles[i];
          const GpcVertex& a = vertices[t.x];
          const GpcVertex& b = vertices[t.y];
          const GpcVertex& c = vertices[t.z];
          if (a.isKnown() && b.isKnown() && c.isKnown() && !CentreCell::missCentres(a.cell, b.cell, c.cell)) {
            buffer.draw(static_cast<uint32_t>(i), {a.x, a.y, a.inverseZ, 0, 0}, {b.x, b.y, b.inverseZ, 1, 0},
                        {c.x, c.y, c.inverseZ, 0, 1});
          }
        }
      });
}

/// The share of pixels that one image covers and the other does not, or whose depths are farther apart than a hundredth
/// of a percent.
double otherShare(const FragmentImage& image, const FragmentImage& rays) {
  size_t others = 0;
  for (size_t i = 0; i < image.size(); ++i) {
    others += image[i].covered() != rays[i].covered() || std::abs(image[i].t - rays[i].t) > 1e-4f * rays[i].t;
  }
  return static_cast<double>(others) / static_cast<double>(image.size());
}

size_t coveredPixels(const FragmentImage& image) {
  return static_cast<size_t>(
      std::count_if(image.begin(), image.end(), [](const Fragment& each) { return each.covered(); }));
}

void measureTerrain(const TableChoice& choice, GlContext& context, size_t triangles) {
  const Mesh mesh = loadScene(fmt::format(fmt::runtime(choice.scene), triangles));
  const PinholeCamera pinhole(View{}, choice.width, choice.height);
  // The text's camera: half the width and height, zoom 3.
  const GpcCamera camera(pinhole, {findGpcSampling(choice.sampling.c_str()), {{{0.5f, 0.5f}, {0.5f, 0.5f}, 3, 1}}});
  const GlRenderer gl(context, mesh);
  const RayScene rays(mesh);
  std::vector<TableTechnique> techniques{
      {"pinhole", "", false, [&] { return rasterize(pinhole, mesh); }},
      {"straight", "55, 18, 6.7", false, [&] { return drawStraight(camera, mesh); }},
      {"pieces", "", false, [&] { return rasterizeGpc(camera, mesh); }},
      {"bent", "3.2, 1.1, 0.33", false, [&] { return rasterizeGpcExactly(camera, ProjectedMesh(pinhole, mesh)); }},
      {"subdivided", "15, 9.1, 5.3", true, [&] { return rasterize(camera, mesh, gpcSubdivision(camera)); }},
      {"OpenGL", "", true, [&] { return gl.draw(camera); }},
      {"rays", "", false, [&] { return raycast(camera, mesh, rays); }},
      {"rays, fresh", "", false, [&] { return raycast(camera, mesh, RayScene(mesh, RayScene::Quality::kLow)); }}};
  std::erase_if(techniques,
                [&](const TableTechnique& each) { return !choice.openGl && each.name == std::string("OpenGL"); });
  for (int run = 0; run <= choice.runs; ++run) {  // the first is not counted
    for (TableTechnique& each : techniques) {
      if (!each.isSlow || run == choice.runs) {
        const double time = processorMilliseconds([&] { each.image = each.draw(); });
        each.best = run > 0 ? std::min(each.best, time) : each.best;
      }
    }
  }
  const FragmentImage truth = raycast(camera, mesh, rays);
  const Image<Rgb8> truthColors = srgbFromLinear(colorImage(truth, mesh, glm::vec3(0)));
  for (const TableTechnique& each : techniques) {
    const FragmentImage& image = each.image;
    fmt::print("| {} | {} | {:.1f} | {:.1f} | {:.2f} | {} | {} |", mesh.triangles.size(), each.name, each.best,
               1000 / each.best, each.best / techniques.front().best, each.published, coveredPixels(image));
    if (&each != techniques.data()) {
      const Image<Rgb8> colors = srgbFromLinear(colorImage(image, mesh, glm::vec3(0)));
      fmt::print(" {:.3f} % | {:.4f} | {:.1f} |", 100 * otherShare(image, truth), flip(truthColors, colors),
                 psnrDecibels(meanSquaredError(truthColors, colors)));
    } else {
      fmt::print(" | | |");
    }
    fmt::print("\n");
    std::fflush(stdout);
  }
}

void measureTable(const TableChoice& choice) {
  const std::unique_ptr<GlContext> context = openGlContext(choice.provider, "--provider");
  const GlScope scope(*context);
  fmt::print("{}x{}, {}, {} threads, {}\n\n", choice.width, choice.height, choice.sampling, threadCount(),
             context->info().renderer);
  fmt::print(
      "| triangles | technique | ms | Hz | of the pinhole's | text, Hz | pixels | other pixels | FLIP | PSNR, dB |\n");
  fmt::print("| ---: | --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |\n");
  for (const size_t triangles : choice.triangles) {
    measureTerrain(choice, *context, triangles);
  }
}

}  // namespace
}  // namespace ocelli

int main(int argumentCount, char** arguments) {
  CLI::App program("Table 5.1: the general pinhole camera by several techniques", "table_5_1");
  ocelli::TableChoice choice;
  ocelli::addCommonOptions(program, choice);
  program.add_option("--scene", choice.scene, "{} stands for the triangles");
  program.add_option("--triangles", choice.triangles, "How many")->delimiter(',');
  program.add_option("--sampling", choice.sampling, "Of the transition")
      ->check(CLI::IsMember({"linear", "quadratic", "cubic"}))
      ->capture_default_str();
  program.add_option("--provider", choice.provider, "Of OpenGL: auto, egl, osmesa")->capture_default_str();
  program.add_flag("!--no-opengl", choice.openGl, "Leave OpenGL out, which takes long without a GPU");
  return ocelli::runProgram(program, argumentCount, arguments, choice, ocelli::measureTable);
}
