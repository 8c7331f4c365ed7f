// Images for an eye that moves, each started from what the last one knew, beside images that are built by themselves:
// how long they take, in turns, and what of the scene they lack or make up, seen from elsewhere in the view cell. Over
// ways of heads that are made up (head_paths.h): times and errors of images, not evidence about people.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bench/bench_program.h"
#include "bench/head_paths.h"
#include "bench/timing.h"
#include "oc_core/evaluation/frame_errors.h"
#include "oc_core/ocri/camera_choice.h"
#include "oc_core/ocri/union_mesh.h"
#include "oc_core/ocri/view_cell.h"
#include "oc_core/render/raycast.h"
#include "oc_core/worlds/packed_source.h"

namespace ocelli {
namespace {

struct Choice {
  std::string scene = "builtin:statues";
  std::string camera = "ddoc";
  int paths = 10;
  int poses = 240;
  int each = 24;       ///< every so many poses are judged
  int viewpoints = 4;  ///< from which one is
  int runs = 1;
  int threads = 0;
  int width = kDefaultWidth;
  int height = kDefaultHeight;
  bool json = false;
};

constexpr double kPosesPerSecond = 24;

struct Way {
  std::vector<double> milliseconds;
  FrameErrors errors;

  double at(double share) const {
    std::vector<double> sorted = milliseconds;
    std::sort(sorted.begin(), sorted.end());
    return sorted[static_cast<size_t>(share * static_cast<double>(sorted.size() - 1))];
  }
};

class Judge {
 public:
  Judge(const Mesh& scene, const CameraChoice& camera, int viewpoints)
      : scene_(scene), rays_(scene), cell_{.sideRadii = camera.cellSideRadii}, viewpoints_(viewpoints) {}

  void add(FrameErrors& errors, const ReferenceImages& images, const PinholeCamera& reference) const {
    const Mesh mesh = unionMesh(images);
    for (const View& view : cell_.interiorViews(reference.view(), viewpoints_, kSeed)) {
      const PinholeCamera camera(view, reference.width(), reference.height());
      const ViewFrame truth = renderFrame(camera, scene_);
      const ViewFrame frame = renderFrame(camera, mesh);
      errors += countErrors(compareViewFrames(camera, truth, frame, rays_), frame);
    }
  }

 private:
  static constexpr unsigned kSeed = 19;

  const Mesh& scene_;
  RayScene rays_;
  ViewCell cell_;
  int viewpoints_;
};

nlohmann::json jsonOf(const Way& way) {
  return {{"median_ms", way.at(0.5)},
          {"ms_95_percent", way.at(0.95)},
          {"strict_percent", 100 * way.errors.strictRatio()},
          {"thick_percent", 100 * way.errors.thickRatio()},
          {"false_skins_percent", 100 * way.errors.falseSkinRatio()}};
}

void print(const char* name, const Way& way) {
  fmt::print("{:5} {:8.1f} ms (95 %: {:.1f})  strict {:.3f} %  thick {:.3f} %  false skins {:.3f} %\n", name,
             way.at(0.5), way.at(0.95), 100 * way.errors.strictRatio(), 100 * way.errors.thickRatio(),
             100 * way.errors.falseSkinRatio());
}

void measure(const Choice& choice) {
  const Mesh scene = loadScene(choice.scene);
  const CameraChoice camera = cameraChoice(choice.camera);
  const Judge judge(scene, camera, choice.viewpoints);
  Way cold;
  Way warm;
  size_t coldStarts = 0;
  for (int path = 0; path < choice.paths; ++path) {
    MovingImages moving(camera);
    const std::vector<EyePose> poses =
        madeUpHeadPath(static_cast<uint64_t>(path) + 1, choice.poses / kPosesPerSecond, kPosesPerSecond);
    for (int i = 0; i < choice.poses; ++i) {
      View view;
      view.eye = poses[static_cast<size_t>(i)].eye;
      const PinholeCamera reference(view, choice.width, choice.height);
      ReferenceImages images;
      warm.milliseconds.push_back(milliseconds([&] { images = moving.next(reference, scene); }));
      if (i % choice.each == choice.each - 1) {
        judge.add(warm.errors, images, reference);
        cold.milliseconds.push_back(milliseconds([&] { images = buildReferenceImages(camera, reference, scene); }));
        judge.add(cold.errors, images, reference);
      }
    }
    coldStarts += moving.starts().cold;
  }
  if (choice.json) {
    fmt::print("{}\n", nlohmann::json{{"scene", choice.scene},
                                      {"camera", choice.camera},
                                      {"triangles", scene.triangles.size()},
                                      {"poses", choice.paths * choice.poses},
                                      {"cold_starts", coldStarts},
                                      {"warm", jsonOf(warm)},
                                      {"cold", jsonOf(cold)}}
                           .dump(2));
    return;
  }
  fmt::print("{}, {}, {} triangles: {} images, {} of them started cold\n", choice.scene, choice.camera,
             scene.triangles.size(), choice.paths * choice.poses, coldStarts);
  print("warm", warm);
  print("cold", cold);
}

}  // namespace
}  // namespace ocelli

int main(int argumentCount, char** arguments) {
  ocelli::Choice choice;
  CLI::App program("Images that start from the last one, and images that start cold", "warm_start_bench");
  program.add_option("SCENE", choice.scene, "As `ocelli` takes it")->capture_default_str();
  program.add_option("--camera", choice.camera, "Which")->capture_default_str();
  program.add_option("--paths", choice.paths, "Ways of heads")->check(CLI::Range(1, 1000))->capture_default_str();
  program.add_option("--poses", choice.poses, "Of each")->check(CLI::Range(1, 100'000))->capture_default_str();
  program.add_option("--each", choice.each, "Every so many are judged")->check(CLI::Range(1, 100'000));
  program.add_option("--viewpoints", choice.viewpoints, "From which one is judged")->check(CLI::Range(1, 1000));
  program.add_flag("--json", choice.json, "As JSON");
  ocelli::addCommonOptions(program, choice);
  return ocelli::runProgram(program, argumentCount, arguments, choice, ocelli::measure);
}
