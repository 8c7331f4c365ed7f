// A scene that turns rigidly in every refresh, so that geometry must be sliced anew each time: against reference images
// that are built anew each time (their camera included), their meshes and their slices. Over packed scenes of growing
// size, up to which number of triangles is slicing geometry faster?
//
// Geometry is sliced in the slicer's best order, which is made once. Up to --max-in-memory triangles the scene is also
// in memory as one mesh, and images are built of it by rasterisation and by rays against a standing acceleration
// structure; larger scenes are sliced in parts. "level" is the scene as coarse as an eighth of a voxel allows, which is
// what `ocelli slice` takes of a pack: chosen once, as what turns about the axis stays as far from it.
// Ways take turns; times are those of the fastest of --runs refreshes, after one that is not counted; of three where
// one takes more than a second. `--json` keeps all figures and their stages, `--svg` draws them.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>

#include "bench/bench_program.h"
#include "bench/line_chart.h"
#include "bench/timing.h"
#include "bench/turning_ways.h"
#include "display_sim/frames/sweep_geometry.h"
#include "display_sim/slicing/slicer.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/base/machine.h"
#include "oc_core/ocri/packed_view.h"
#include "oc_core/pack/cluster_cut.h"
#include "oc_core/render/raycast.h"
#include "oc_core/worlds/packed_source.h"

namespace ocelli {
namespace {

struct Choice {
  std::vector<std::string> packs;
  std::vector<std::string> cameras{"di", "eoc-h", "ddoc"};
  int runs = 9;
  int threads = 0;
  int width = kDefaultWidth;
  int height = kDefaultHeight;
  double maxInMemory = 20.5e6;
  double trianglesOfPart = 10e6;
  std::string json;
  std::string svg;
};

const char* const kGeometry = "geometry";
const char* const kLevel = "level";
constexpr double kLongMilliseconds = 1000;
constexpr int kFewRuns = 3;

struct Timed {
  std::string name;
  TurningWay way;
  std::vector<std::vector<double>> stages;  ///< of each refresh

  /// The fastest refresh.
  const std::vector<double>& best() const {
    return *std::ranges::min_element(stages, {}, [](const std::vector<double>& each) { return total(each); });
  }
  double least() const { return total(best()); }

  static double total(const std::vector<double>& each) { return std::accumulate(each.begin(), each.end(), 0.0); }
};

void runInTurns(std::vector<Timed>& ways, int runs) {
  for (int refresh = 0; refresh <= runs; ++refresh) {
    for (Timed& each : ways) {
      const bool isLong = !each.stages.empty() && each.least() > kLongMilliseconds;
      if (isLong && each.stages.size() >= kFewRuns) {
        continue;
      }
      std::vector<double> stages = each.way(refresh);
      if (refresh > 0) {
        each.stages.push_back(std::move(stages));
      }
    }
  }
}

/// What is made of a scene once, and the ways that use it.
class SceneWays {
 public:
  SceneWays(const std::string& path, const Choice& choice, const DisplayProfile& profile)
      : choice_(choice), profile_(profile), packed_(path) {
    const SweepGeometry sweep(profile);
    const auto error = kPackedErrorVoxels * static_cast<float>(std::min(sweep.columnWidth(), sweep.rowHeight()));
    const Mesh level = orderedForSlicing(weldedMeshOf(packed_, coarsestClusters(packed_, error)));
    levelTriangles_ = level.triangles.size();
    ways_.push_back({kLevel, geometryWay(level, profile), {}});
    if (static_cast<double>(packed_.triangleCount()) <= choice.maxInMemory) {
      mesh_ = orderedForSlicing(unpackedMesh(packed_));
      ways_.push_back({kGeometry, geometryWay(mesh_, profile), {}});
      rays_.emplace(mesh_);
    }
    for (const std::string& name : choice.cameras) {
      addCamera(cameraChoice(name));
    }
  }

  nlohmann::ordered_json measure() {
    runInTurns(ways_, choice_.runs);
    nlohmann::ordered_json json{{"scene", packed_.path().filename().string()},
                                {"triangles", packed_.triangleCount()},
                                {"level_triangles", levelTriangles_}};
    for (const Timed& each : ways_) {
      json["ms"][each.name] = each.least();
      if (each.best().size() > 1) {
        json["stages_ms"][each.name] = each.best();
      }
      json["runs"][each.name] = each.stages.size();
    }
    if (!rays_) {
      const PartsTimes parts = sliceInParts(packed_, static_cast<size_t>(choice_.trianglesOfPart), kFewRuns, profile_);
      json["ms"][kGeometry] = parts.standing;
      json["ms"]["geometry, streamed"] = parts.streamed;
      json["parts"] = parts.parts;
    }
    return json;
  }

 private:
  void add(const std::string& name, std::function<ReferenceImages(const PinholeCamera&)> build) {
    ways_.push_back({name, ocriWay(std::move(build), choice_.width, choice_.height, profile_), {}});
  }

  void addCamera(const CameraChoice& camera) {
    add(camera.name + ", pack",
        [this, camera](const PinholeCamera& eye) { return buildReferenceImages(camera, eye, packed_); });
    const auto moving = std::make_shared<MovingImages>(camera);
    if (moving->remembers()) {
      add(camera.name + ", pack, from the last one", [this, moving](const PinholeCamera& eye) {
        requireViewpointsOutside(packed_, moving->choice(), eye);
        return moving->next(eye, meshForView(packed_, moving->choice(), eye));
      });
    }
    if (rays_) {
      for (const Construction construction : {Construction::kRaster, Construction::kRays}) {
        const char* how = construction == Construction::kRays ? "rays" : "raster";
        add(camera.name + ", " + how, [this, camera, construction](const PinholeCamera& eye) {
          return buildReferenceImages(camera, eye, mesh_, {}, construction, &*rays_);
        });
      }
    }
  }

  const Choice& choice_;
  const DisplayProfile& profile_;
  PackedScene packed_;
  size_t levelTriangles_ = 0;
  Mesh mesh_;  ///< in the slicer's best order; empty where it is too large
  std::optional<RayScene> rays_;
  std::vector<Timed> ways_;
};

/// Triangles from which on a way is faster than geometry, between the rows: both grow as powers between two of them.
std::string crossing(const nlohmann::ordered_json& rows, const std::string& name) {
  double before = 0;
  double logTriangles = 0;
  for (const auto& row : rows) {
    if (!row["ms"].contains(name) || !row["ms"].contains(kGeometry)) {
      continue;
    }
    const double faster = std::log(row["ms"][kGeometry].get<double>() / row["ms"][name].get<double>());
    const double at = std::log(row["triangles"].get<double>());
    if (faster >= 0) {
      return logTriangles == 0
                 ? fmt::format("below {:.1f} M", std::exp(at) / 1e6)
                 : fmt::format("{:.1f} M",
                               std::exp(logTriangles + (at - logTriangles) * before / (before - faster)) / 1e6);
    }
    before = faster;
    logTriangles = at;
  }
  return "none";
}

void print(const nlohmann::ordered_json& rows) {
  std::vector<std::string> names;
  for (const auto& row : rows) {
    for (const auto& [name, ms] : row["ms"].items()) {
      if (std::ranges::find(names, name) == names.end()) {
        names.push_back(name);
      }
    }
  }
  std::string head = "\n| way |";
  std::string line = "| --- |";
  for (const auto& row : rows) {
    head += fmt::format(" {:.1f} M |", row["triangles"].get<double>() / 1e6);
    line += " ---: |";
  }
  fmt::print("{} faster than geometry from |\n{} ---: |\n", head, line);
  for (const std::string& name : names) {
    std::string text = fmt::format("| {} |", name);
    for (const auto& row : rows) {
      if (!row["ms"].contains(name)) {
        text += " |";
        continue;
      }
      const double ms = row["ms"][name];
      text += row["ms"].contains(kGeometry) && name != kGeometry
                  ? fmt::format(" {:.0f} ({:.2f}) |", ms, row["ms"][kGeometry].get<double>() / ms)
                  : fmt::format(" {:.0f} |", ms);
    }
    fmt::print("{} {} |\n", text, name == kGeometry ? "" : crossing(rows, name));
  }
}

void draw(const nlohmann::ordered_json& rows, const Choice& choice) {
  LineChart chart{"Time for a volume of a scene that turns", "Triangles", "Milliseconds for a volume", {}};
  std::vector<std::string> names{kGeometry, kLevel};
  for (const std::string& camera : choice.cameras) {
    names.push_back(camera + ", pack");
  }
  for (const std::string& name : names) {
    LineChart::Curve curve{name, {}};
    for (const auto& row : rows) {
      if (row["ms"].contains(name)) {
        curve.points.push_back({row["triangles"].get<double>(), row["ms"][name].get<double>()});
      }
    }
    chart.curves.push_back(curve);
  }
  writeFile(choice.svg, svgText(lineFigure(chart)));
}

void measure(const Choice& choice) {
  const DisplayProfile profile = loadProfile("perspecta");
  nlohmann::ordered_json json{{"processor", machineInfo().processor},
                              {"threads", threadCount()},
                              {"size", {choice.width, choice.height}},
                              {"refreshes", choice.runs},
                              {"scenes", nlohmann::ordered_json::array()}};
  for (const std::string& pack : choice.packs) {
    json["scenes"].push_back(SceneWays(pack, choice, profile).measure());
    fmt::print("{}\n", json["scenes"].back().dump());
    std::fflush(stdout);
  }
  print(json["scenes"]);
  if (!choice.json.empty()) {
    writeFile(choice.json, json.dump(2) + "\n");
  }
  if (!choice.svg.empty()) {
    draw(json["scenes"], choice);
  }
}

}  // namespace
}  // namespace ocelli

int main(int argumentCount, char** arguments) {
  ocelli::Choice choice;
  CLI::App program("A turning scene: geometry against reference images", "turning_bench");
  program.add_option("PACKS", choice.packs, "Packed scenes, the smallest first")->required();
  program.add_option("--cameras", choice.cameras, "Which")->delimiter(',')->capture_default_str();
  program.add_option("--max-in-memory", choice.maxInMemory, "Triangles of a scene that is one mesh in memory too");
  program.add_option("--triangles-of-part", choice.trianglesOfPart, "Where a larger one is sliced in parts")
      ->check(CLI::Range(1e4, 4e7));
  program.add_option("--json", choice.json, "Where the figures go");
  program.add_option("--svg", choice.svg, "Where a chart goes");
  ocelli::addCommonOptions(program, choice);
  return ocelli::runProgram(program, argumentCount, arguments, choice, ocelli::measure);
}
