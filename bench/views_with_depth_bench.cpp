// Views with depth: which samples must be kept. Reference images built of 9 views of a cell (its middle and its
// corners), beside what the published pruning rule of MPEG immersive video leaves of the same views (pruned_views.h: a
// stand-in, not the test model itself), and all samples of all views.
//
// Samples are counted against those of the depth image from the middle. PSNR is of luma (BT.709 of sRGB-encoded
// values), over the pixels that the scene covers, of all viewpoints together: seeded ones inside of the cell that no
// image was taken from. Missing pixels are black, and in a second figure filled from around. What is kept is drawn by
// the meshes of reference images.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>

#include "bench/bench_program.h"
#include "bench/pruned_views.h"
#include "bench/timing.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/base/json_document.h"
#include "oc_core/depth_views/views_surface.h"
#include "oc_core/evaluation/frame_errors.h"
#include "oc_core/image/color.h"
#include "oc_core/image/image_error.h"
#include "oc_core/ocri/camera_choice.h"
#include "oc_core/ocri/corner_depth_images.h"
#include "oc_core/ocri/union_mesh.h"
#include "oc_core/ocri/view_cell.h"
#include "oc_core/ocri/view_holes.h"
#include "oc_core/worlds/scene_source.h"

namespace ocelli {
namespace {

using Json = nlohmann::ordered_json;

struct ViewsBenchChoice {
  std::vector<std::string> scenes{"builtin:room,mesh=bunny.obj",  "builtin:fence", "builtin:statues,mesh=bunny.obj",
                                  "builtin:doors,mesh=bunny.obj", "builtin:boxes", "builtin:canyon"};
  std::vector<double> cells{0.4, 0.8, 1.6};
  std::vector<std::string> cameras{"ddoc", "cell", "eoc-hv", "ldi-2", "ldi-4"};
  int viewpoints = 12;
  unsigned seed = 1;
  int runs = 1;
  int threads = 0;
  int width = 720;
  int height = 480;
  bool alsoOfScene = false;
  ViewsSurfaceOptions surface;
  std::string json;
  std::string pictures;
};

struct Truth {
  PinholeCamera camera;
  ViewFrame frame;
};

double encodedLuma(const Rgb8& c) {
  return (0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z) / 255;
}

/// dB, and which share of the pixels that the scene covers the mesh leaves empty.
struct LumaErrors {
  double squared = 0;
  double squaredFilled = 0;  ///< with holes filled from around
  size_t pixels = 0;
  size_t empty = 0;

  double psnr() const { return psnrDecibels(squared / static_cast<double>(pixels)); }
  double psnrFilled() const { return psnrDecibels(squaredFilled / static_cast<double>(pixels)); }
  double emptyShare() const { return static_cast<double>(empty) / static_cast<double>(pixels); }
};

/// As decoders do that inpaint: from what lies around, the farther part of it (view_holes.h). Holes are the pixels that
/// the scene covers, and the frame does not.
Image<Rgb8> withoutHoles(const Truth& truth, const ViewFrame& frame) {
  const int width = frame.image.width();
  const int height = frame.image.height();
  ResampledView view{Image<glm::vec3>(width, height), Image<float>(width, height, 0), Image<uint8_t>(width, height, 0)};
  for (size_t i = 0; i < frame.image.size(); ++i) {
    const Rgb8& c = frame.image[i];
    view.color[i] = {linearFromSrgbByte(c.x), linearFromSrgbByte(c.y), linearFromSrgbByte(c.z)};
    const bool isCovered = frame.points[i].w != 0;
    view.t[i] = isCovered ? truth.camera.cameraFromWorld(glm::vec3(frame.points[i])).z : 0;
    view.hole[i] = truth.frame.points[i].w != 0 && !isCovered;
  }
  fillHoles(view);
  return srgbFromLinear(view.color);
}

LumaErrors errorsOf(const Mesh& mesh, const std::vector<Truth>& truths) {
  LumaErrors errors;
  for (const Truth& truth : truths) {
    const ViewFrame frame = renderFrame(truth.camera, mesh);
    const Image<Rgb8> filled = withoutHoles(truth, frame);
    for (size_t i = 0; i < frame.image.size(); ++i) {
      if (truth.frame.points[i].w == 0) {
        continue;
      }
      const double difference = encodedLuma(truth.frame.image[i]) - encodedLuma(frame.image[i]);
      errors.squared += difference * difference;
      const double afterwards = encodedLuma(truth.frame.image[i]) - encodedLuma(filled[i]);
      errors.squaredFilled += afterwards * afterwards;
      errors.empty += frame.points[i].w == 0;
      ++errors.pixels;
    }
  }
  return errors;
}

size_t samplesOf(const ReferenceImages& images) {
  size_t samples = 0;
  for (const ReferenceImage& image : images) {
    samples += image.sampleCount();
  }
  return samples;
}

/// One line: what keeps how many samples, and how good its pictures are.
class ViewsTable {
 public:
  ViewsTable(std::string scene, double cell, size_t unit, const std::vector<Truth>& truths, std::string pictures)
      : scene_(std::move(scene)),
        cell_(cell),
        unit_(static_cast<double>(unit)),
        truths_(truths),
        pictures_(std::move(pictures)) {
    writePicture("scene", truths_.front().frame.image);
  }

  void add(const std::string& name, size_t samples, const Mesh& mesh, double buildMilliseconds, size_t packed = 0) {
    const LumaErrors errors = errorsOf(mesh, truths_);
    writePicture(name, renderFrame(truths_.front().camera, mesh).image);
    const double share = static_cast<double>(samples) / unit_;
    fmt::print("| {} | {:.1f} | {} | {:.2f} | {:.2f} | {:.2f} | {:.2f} % | {:.0f} ms |{}\n", scene_, cell_, name, share,
               errors.psnr(), errors.psnrFilled(), 100 * errors.emptyShare(), buildMilliseconds,
               packed > 0 ? fmt::format(" packed {:.2f}", static_cast<double>(packed) / unit_) : "");
    std::fflush(stdout);
    rows.push_back({{"scene", scene_},
                    {"cell_radii", cell_},
                    {"what", name},
                    {"samples", samples},
                    {"samples_of_depth_image", unit_},
                    {"packed_pixels", packed},
                    {"psnr_db", errors.psnr()},
                    {"psnr_filled_db", errors.psnrFilled()},
                    {"empty_share", errors.emptyShare()},
                    {"build_ms", buildMilliseconds}});
  }

  Json rows = Json::array();

 private:
  /// From the first viewpoint, where pictures are wanted.
  void writePicture(const std::string& name, const Image<Rgb8>& image) const {
    if (!pictures_.empty()) {
      writePng(std::filesystem::path(pictures_) / (name + ".png"), image);
    }
  }

  std::string scene_;
  double cell_;
  double unit_;
  const std::vector<Truth>& truths_;
  std::string pictures_;  ///< a folder, or none
};

std::vector<Truth> truthsOf(const Mesh& scene, const PinholeCamera& reference, const ViewCell& cell,
                            const ViewsBenchChoice& choice) {
  std::vector<Truth> truths;
  for (const View& view : cell.interiorViews(reference.view(), choice.viewpoints, choice.seed)) {
    const PinholeCamera camera(view, choice.width, choice.height);
    truths.push_back({camera, renderFrame(camera, scene)});
  }
  return truths;
}

void addCameras(ViewsTable& table, const Mesh& mesh, const std::string& where, const PinholeCamera& reference,
                const ViewCell& cell, const ViewsBenchChoice& choice) {
  for (const std::string& name : choice.cameras) {
    ReferenceImages images;
    const double time = milliseconds([&] { images = buildReferenceImages(cameraChoice(name, cell), reference, mesh); });
    table.add(name + where, samplesOf(images), unionMesh(images), time);
  }
}

Json measureCase(const std::string& name, const Mesh& scene, double cellRadii, const ViewsBenchChoice& choice) {
  const PinholeCamera reference(View{}, choice.width, choice.height);
  ViewCell cell;
  cell.sideRadii = static_cast<float>(cellRadii);
  const std::vector<Truth> truths = truthsOf(scene, reference, cell, choice);
  std::vector<DepthView> views;
  for (ReferenceImage& image : buildCornerDepthImages(reference, scene, cell, 8)) {
    views.push_back({fmt::format("v{:02}", views.size()), std::move(image)});
  }
  ViewsTable table(name, cellRadii, views.front().image.sampleCount(), truths, choice.pictures);
  const ViewsSurface all = surfaceOfViews(views, {.keepsAll = true});
  table.add("all 9 views", all.samples, all.mesh, 0);
  PrunedViews pruned;
  const double pruning = milliseconds([&] { pruned = pruneViews(views); });
  table.add("pruning (stand-in)", pruned.samples, unionMesh(pruned.images), pruning, pruned.packedPixels);
  ViewsSurface surface;
  const double joining = milliseconds([&] { surface = surfaceOfViews(views, choice.surface); });
  table.add("views, joined", surface.keptSamples(), surface.mesh, joining);
  table.add("di", views.front().image.sampleCount(), unionMesh({views.front().image}), 0);
  addCameras(table, surface.mesh, "", reference, cell, choice);
  if (choice.alsoOfScene) {
    addCameras(table, scene, " of the scene", reference, cell, choice);
  }
  return table.rows;
}

void measure(const ViewsBenchChoice& choice) {
  Json rows = Json::array();
  fmt::print(
      "| scene | cell, radii | what | samples, depth images | PSNR, dB | with holes filled | empty | built in |\n");
  fmt::print("| --- | --- | --- | --- | --- | --- | --- | --- |\n");
  for (const std::string& name : choice.scenes) {
    const Mesh scene = loadScene(name, SceneOptions{});
    for (const double cell : choice.cells) {
      for (Json& row : measureCase(name, scene, cell, choice)) {
        rows.push_back(std::move(row));
      }
      if (!choice.json.empty()) {
        writeFile(choice.json, textOfJson(rows, 1) + "\n");
      }
    }
  }
}

}  // namespace
}  // namespace ocelli

int main(int argumentCount, char** arguments) {
  CLI::App program("Which samples of views with depth are kept, and what they are worth", "views_with_depth_bench");
  ocelli::ViewsBenchChoice choice;
  ocelli::addCommonOptions(program, choice);
  program.add_option("--scene", choice.scenes, "Scenes");
  program.add_option("--cell", choice.cells, "Sides of the cells, radii");
  program.add_option("--cameras", choice.cameras, "Cameras")->delimiter(',');
  program.add_option("--viewpoints", choice.viewpoints, "How many inside of each cell")->check(CLI::Range(1, 1000));
  program.add_option("--seed", choice.seed, "Of these");
  program.add_flag("--also-of-scene", choice.alsoOfScene, "Also build the reference images of the scene itself");
  program.add_option("--seam", choice.surface.seamPixels, "Pixels of seams")->check(CLI::Range(0, 100));
  program.add_option("--max-spaces", choice.surface.maxSpaces, "How far apart samples of the same place are, spaces");
  program.add_option("--better-by", choice.surface.betterBy, "How much closer together samples are of a better view");
  program.add_option("--pictures", choice.pictures, "Folder for what the first viewpoint sees: of one scene and cell");
  program.add_option("--json", choice.json, "Also write the figures here");
  return ocelli::runProgram(program, argumentCount, arguments, choice, [](const auto& each) { ocelli::measure(each); });
}
