// A scene all of whose triangles move, and an eye that moves, too: what each step of an image takes, refitting the
// acceleration structure against building it, and from the begin of the making to light on a device that shows nothing.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <ctime>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>

#include "bench/bench_program.h"
#include "bench/head_paths.h"
#include "bench/timing.h"
#include "display_driver/devices/device_kinds.h"
#include "display_driver/pacing/moving_view.h"
#include "display_driver/pacing/pacer.h"
#include "display_sim/slicing/slicer.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/ocri/representation_kind.h"
#include "oc_core/ocri/union_mesh.h"
#include "oc_core/render/rasterize.h"

namespace ocelli {
namespace {

struct Choice {
  std::string scene = "builtin:waving,room=1,triangles=1000000";
  std::string camera = "eoc-h";
  std::string construction = "auto";
  int runs = 11;
  int threads = 0;
  int width = 720;
  int height = 480;
  double seconds = 10;
  std::vector<double> minScales{1, 0.25};
  bool noSteps = false;
  bool json = false;
};

using Json = nlohmann::ordered_json;

/// Milliseconds of one kind of work, run after run: on the clock, and of all CPUs together.
class Step {
 public:
  explicit Step(std::string name) : name_(std::move(name)) {}

  template <class Work>
  void run(const Work& work) {
    const std::clock_t before = std::clock();
    wall_.push_back(milliseconds(work));
    cpu_.push_back(1000.0 * static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC);
  }
  Json row() const {
    return {{"step", name_},
            {"median_ms", median(wall_)},
            {"least_ms", *std::ranges::min_element(wall_)},
            {"cpu_median_ms", median(cpu_)}};
  }

 private:
  static double median(std::vector<double> values) {
    std::ranges::sort(values);
    return values[values.size() / 2];
  }

  std::string name_;
  std::vector<double> wall_;
  std::vector<double> cpu_;
};

PinholeCamera referenceFor(const Choice& choice) {
  return {View{}, choice.width, choice.height};
}

/// The steps one by one, at times that are spread over the motion. Each round does all of them.
Json measureSteps(const Choice& choice) {
  const auto motion = loadMotion(choice.scene, {});
  if (motion == nullptr) {
    throw InputError("this scene does not move", choice.scene, "builtin:waving");
  }
  const PinholeCamera reference = referenceFor(choice);
  MovingImages images(cameraChoice(choice.camera));
  const bool canCast = images.choice().kind->rayCrossover.has_value();
  const Mesh& mesh = motion->at(0);
  RayScene moving(mesh, RayScene::Quality::kLow, RayScene::Motion::kMoves);
  Slicer slicer(loadProfile("perspecta"));
  Step move("motion: positions and shades");
  Step refit("structure: refit");
  Step low("structure: build, fast");
  Step medium("structure: build, good");
  Step raster("depth image, rasterised");
  Step castRefitted("depth image, rays against the refitted structure");
  Step castBuilt("depth image, rays against a new structure");
  Step byRaster(choice.camera + ", rasterised");
  Step byRays(choice.camera + ", rays against the refitted structure");
  Step meshing("mesh of the image");
  Step slicing("slices of that mesh");
  int rebuilds = 0;
  for (int i = 0; i < choice.runs; ++i) {
    move.run([&] { motion->at(motion->durationSeconds() * (i + 0.5) / choice.runs); });
    refit.run([&] { rebuilds += moving.update() == RayScene::Update::kRebuilt ? 1 : 0; });
    std::optional<RayScene> built;
    low.run([&] { built.emplace(mesh, RayScene::Quality::kLow); });
    castBuilt.run([&] { raycast(reference, mesh, *built); });
    castRefitted.run([&] { raycast(reference, mesh, moving); });
    built.reset();
    medium.run([&] { built.emplace(mesh, RayScene::Quality::kMedium); });
    raster.run([&] { rasterize(reference, mesh); });
    ReferenceImages seen;
    byRaster.run([&] { seen = images.next(reference, mesh); });
    if (canCast) {
      byRays.run([&] { seen = images.next(reference, mesh, &moving); });
    }
    Mesh surface;
    meshing.run([&] { surface = unionMesh(seen); });
    slicing.run([&] { slicer.slice(SliceMesh(surface)); });
  }
  Json rows = Json::array();
  for (const Step* step :
       {&move, &refit, &low, &medium, &raster, &castRefitted, &castBuilt, &byRaster, &meshing, &slicing}) {
    rows.push_back(step->row());
  }
  if (canCast) {
    rows.push_back(byRays.row());
  }
  return {{"triangles", mesh.triangles.size()}, {"rebuilt", rebuilds}, {"steps", rows}};
}

/// A way of a head, from the first question on.
class HeadFeed final : public EyeFeed {
 public:
  HeadFeed(uint64_t seed, double seconds) : path_(madeUpHeadPath(seed, seconds, kRate)) {}
  std::optional<glm::vec3> eyeAt(HostTime seen) override {
    start_ = start_ ? start_ : seen;
    asked_.push_back(realClock().now());
    const double at = std::chrono::duration<double>(seen - *start_).count() * kRate;
    return path_[std::min(static_cast<size_t>(std::max(at, 0.0)), path_.size() - 1)].eye;
  }
  bool ended(HostTime) override { return false; }
  /// When eyes were asked for, one after the other; not while a source is at work.
  const std::vector<HostTime>& asked() const { return asked_; }

 private:
  static constexpr double kRate = 120;
  std::vector<HostTime> asked_;
  std::vector<EyePose> path_;
  std::optional<HostTime> start_;
};

double share(std::vector<double> sorted, double part) {
  return sorted.empty()
             ? std::numeric_limits<double>::quiet_NaN()
             : sorted[std::min(sorted.size() - 1, static_cast<size_t>(part * static_cast<double>(sorted.size())))];
}

/// As `ocelli present --device null --eyes` does it.
Json measurePresenting(const Choice& choice, double minScale) {
  const DisplayProfile profile = loadProfile("perspecta");
  MovingImages images(cameraChoice(choice.camera));
  const double fewestPixels = choice.width * minScale * choice.height * minScale;
  MovingView view(loadMotion(choice.scene, {}), images, {.loop = true}, static_cast<size_t>(fewestPixels),
                  constructionFromText(choice.construction, "--construction"));
  HeadFeed feed(11, choice.seconds + 2);
  EyesSource source([&](const PinholeCamera& reference) { return view.imagesFrom(reference); }, profile,
                    {.width = choice.width,
                     .height = choice.height,
                     .slicing = {},
                     .minImageScale = minScale,
                     .moveScene = [&](HostTime seen) { return view.moveTo(seen); }},
                    feed);
  const auto device = openDevice("null", {.profile = profile});
  Pacer pacer(*device, source, realClock(), {.seconds = choice.seconds});
  std::vector<RefreshRecord> shown;
  const TimeLineSummary summary = pacer.run({}, [&](const RefreshRecord& record) {
    if (record.shown != HostTime{} && record.frame != 0) {
      shown.push_back(record);
    }
  });
  std::vector<double> latencies;
  std::vector<double> poseLatencies;
  std::vector<double> scales;
  for (const RefreshRecord& record : shown) {
    const auto since = [&](HostTime time) {
      return std::chrono::duration<double, std::milli>(record.shown - time).count();
    };
    latencies.push_back(since(record.makingBegan));
    // Eyes are asked for one after the other: this one's is the first after its making began.
    poseLatencies.push_back(since(*std::ranges::lower_bound(feed.asked(), record.makingBegan)));
    scales.push_back(static_cast<double>(record.imageScale));
  }
  std::ranges::sort(poseLatencies);
  std::ranges::sort(latencies);
  std::ranges::sort(scales);
  Json stages;
  for (const EyesSource::Stage& stage : source.stages()) {
    stages[stage.name] = std::chrono::duration<double, std::milli>(stage.times.median()).count();
  }
  return {{"min_scale", minScale},
          {"images", view.imagesMade()},
          {"images_by_rays", view.imagesByRays()},
          {"refreshes", summary.refreshes},
          {"new_images", latencies.size()},
          {"in_time", summary.count(RefreshOutcome::kShown)},
          {"making_to_light_median_ms", share(latencies, 0.5)},
          {"making_to_light_95_ms", share(latencies, 0.95)},
          {"pose_to_light_median_ms", share(poseLatencies, 0.5)},
          {"pose_to_light_95_ms", share(poseLatencies, 0.95)},
          {"image_scale_median", share(scales, 0.5)},
          {"stages_ms", stages}};
}

void measure(const Choice& choice) {
  Json result{{"scene", choice.scene},
              {"camera", choice.camera},
              {"width", choice.width},
              {"height", choice.height},
              {"threads", threadCount()}};
  if (!choice.noSteps) {
    result["work"] = measureSteps(choice);
  }
  result["presenting"] = Json::array();
  for (const double minScale : choice.minScales) {
    result["presenting"].push_back(measurePresenting(choice, minScale));
  }
  if (choice.json) {
    fmt::print("{}\n", textOfJson(result, 2));
    return;
  }
  if (!choice.noSteps) {
    fmt::print("{} triangles, {}x{}, {} threads; {} of {} structures built anew\n{:52}  median   least   CPU\n",
               result["work"]["triangles"].get<size_t>(), choice.width, choice.height, threadCount(),
               result["work"]["rebuilt"].get<int>(), choice.runs, "");
    for (const Json& row : result["work"]["steps"]) {
      fmt::print("{:52} {:6.1f}  {:6.1f}  {:6.1f} ms\n", row["step"].get<std::string>(), row["median_ms"].get<double>(),
                 row["least_ms"].get<double>(), row["cpu_median_ms"].get<double>());
    }
  }
  for (const Json& row : result["presenting"]) {
    fmt::print("present --eyes, --min-scale {}: {}\n", row["min_scale"].get<double>(), row.dump());
  }
}

}  // namespace
}  // namespace ocelli

int main(int argumentCount, char** arguments) {
  ocelli::Choice choice;
  CLI::App program("Images of a scene that moves, for an eye that moves", "moving_scene_bench");
  ocelli::addCommonOptions(program, choice);
  program.add_option("--scene", choice.scene, "It must move")->capture_default_str();
  program.add_option("--camera", choice.camera, "Of the reference images")->capture_default_str();
  program.add_option("--construction", choice.construction, "auto, raster or rays")->capture_default_str();
  program.add_option("--seconds", choice.seconds, "Of presenting")->capture_default_str();
  program.add_option("--min-scale", choice.minScales, "As present has it; none: nothing is presented")
      ->delimiter(',')
      ->expected(0, 10)
      ->capture_default_str();
  program.add_flag("--no-steps", choice.noSteps, "Only present");
  program.add_flag("--json", choice.json, "Print the figures as JSON");
  return ocelli::runProgram(program, argumentCount, arguments, choice, ocelli::measure);
}
