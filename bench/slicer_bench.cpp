// Slicing against others who do the job, in the same run: what one volume takes, by triangles, slices, resolution and
// threads; what the stages take; and how fast the volume's memory can be written at all.
//
// A time is the least of --runs, whose runs of all ways are interleaved; what is slow runs three times. `--json` keeps
// all figures, `--svg` draws them. OCRI stands for the mesh of a DDOC image of the scene.
#include <fmt/format.h>
#include <hwy/targets.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <limits>
#include <nlohmann/json.hpp>

#include "bench/bench_program.h"
#include "bench/line_chart.h"
#include "bench/naive_slicer.h"
#include "bench/slicer_peers.h"
#include "bench/timing.h"
#include "display_sim/slicing/exact_slicer.h"
#include "display_sim/slicing/slicer.h"
#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/base/machine.h"
#include "oc_core/ocri/ddoc_builder.h"
#include "oc_core/ocri/image_mesh.h"
#include "oc_core/ocri/simplified_mesh.h"
#include "oc_core/worlds/scene_source.h"

namespace ocelli {
namespace {

struct Choice {
  int runs = 20;
  int threads = 0;
  int width = 1280;
  int height = 960;
  std::vector<std::string> parts{"triangles", "profiles", "threads", "timeline"};
  std::vector<double> thousands{10, 100, 600, 1000, 4600, 10000};
  bool peers = true;
  std::string instructionSet;
  std::string json;
  std::string svg;
};

constexpr const char* kScene = "builtin:statues,mesh=buddha.obj,triangles={}";

/// Simplified where the scene has more triangles by itself.
Mesh sceneOf(double thousands) {
  const auto triangles = static_cast<size_t>(thousands * 1000);
  Mesh mesh = loadScene(fmt::format(kScene, triangles));
  return mesh.triangles.size() > triangles * 11 / 10 ? simplifyMesh(mesh, triangles, SimplifyMethod::kTopological).mesh
                                                     : mesh;
}

/// One way to slice: its work, the least time so far, and how often it ran.
struct Way {
  std::string name;
  std::function<void()> work;
  double least = std::numeric_limits<double>::infinity();
  int runs = 0;
};

/// What takes longer than this runs three times at most.
constexpr double kSlowMilliseconds = 1000;

void runInterleaved(std::vector<Way>& ways, int runs) {
  for (int i = 0; i < runs; ++i) {
    for (Way& way : ways) {
      if (way.runs < 3 || way.least < kSlowMilliseconds) {
        way.least = std::min(way.least, milliseconds(way.work));
        ++way.runs;
      }
    }
  }
}

/// Every byte of a volume, by all threads.
double memoryFloor(const DisplayProfile& profile, int runs) {
  Volume volume(profile);
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < runs; ++i) {
    least = std::min(least, milliseconds([&] {
                       parallelFor(static_cast<size_t>(volume.slices()), 1, [&](size_t begin, size_t end) {
                         for (size_t slice = begin; slice < end; ++slice) {
                           std::ranges::fill(volume.slice(static_cast<int>(slice)), static_cast<uint8_t>(i));
                         }
                       });
                     }));
  }
  return least;
}

nlohmann::ordered_json stagesJson(const SliceStages& stages) {
  return {{"sampling_ms", stages.sampling},
          {"exact_ms", stages.exact},
          {"assembling_ms", stages.assembling},
          {"samples", stages.samples},
          {"exact_cells", stages.exactCells}};
}

/// All ways get the mesh in the same order, the one that is good for Ocelli.
nlohmann::ordered_json measureMesh(const std::string& name, const Mesh& unordered, const DisplayProfile& profile,
                                   const Choice& choice) {
  Slicer slicer(profile);
  Mesh mesh;
  std::optional<SliceMesh> prepared;
  const double preparing = milliseconds([&] {
    mesh = orderedForSlicing(unordered);
    prepared.emplace(mesh);
  });
  SliceStages stages;
  std::vector<Way> ways{{"Ocelli", [&] { slicer.slice(*prepared); }}};
  slicer.slice(*prepared);
  if (choice.peers) {
    ways.push_back({"Ocelli, exact", [&] { sliceExactly(mesh, profile); }});
    ways.push_back({"naive, one thread", [&] { sliceNaively(mesh, profile); }});
    std::vector<SlicerPeer> peers;
#ifdef OCELLI_BENCH_VTK
    for (const SlicerPeer& peer : vtkPeers()) {
      peers.push_back(peer);
    }
#endif
#ifdef OCELLI_BENCH_OPENVDB
    for (const SlicerPeer& peer : openVdbPeers()) {
      peers.push_back(peer);
    }
#endif
    for (const SlicerPeer& peer : peers) {
      if (mesh.triangles.size() <= peer.maxTriangles) {
        const std::function<void()> work = peer.prepare(mesh, profile);
        work();  // makes what is made once
        ways.push_back({peer.name, work});
      }
    }
  }
  runInterleaved(ways, choice.runs);
  slicer.slice(*prepared);
  stages = slicer.stages();
  nlohmann::ordered_json json = {{"mesh", name},
                                 {"triangles", mesh.triangles.size()},
                                 {"lit_voxels", slicer.slice(*prepared).litVoxels()},
                                 {"prepare_ms", preparing},
                                 {"stages", stagesJson(stages)}};
  fmt::print("{:<22} {:>10}", name, mesh.triangles.size());
  for (const Way& way : ways) {
    json["ms"][way.name] = way.least;
    json["runs"][way.name] = way.runs;
    fmt::print("  {} {:.1f} ms", way.name, way.least);
    if (&way != &ways.front()) {
      json["ratio"][way.name] = way.least / ways.front().least;
      fmt::print(" ({:.0f}x)", way.least / ways.front().least);
    }
  }
  fmt::print("\n");
  std::fflush(stdout);
  return json;
}

Mesh ocriMesh(const Mesh& scene, const Choice& choice) {
  const PinholeCamera camera(View{}, choice.width, choice.height);
  return imageMesh(buildDdocImage(buildDdocCamera(camera, scene), scene));
}

nlohmann::ordered_json measureTriangles(const Choice& choice, const DisplayProfile& profile) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const double thousand : choice.thousands) {
    const Mesh mesh = sceneOf(thousand);
    rows.push_back(measureMesh("geometry", mesh, profile, choice));
    if (thousand == choice.thousands.back()) {
      rows.push_back(measureMesh("OCRI", ocriMesh(mesh, choice), profile, choice));
    }
  }
  return rows;
}

nlohmann::ordered_json measureProfiles(const Choice& choice) {
  const Mesh mesh = loadScene(fmt::format(kScene, 600000));
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const int slices : {99, 198, 396}) {
    for (const int side : {256, 512, 768, 1024}) {
      for (const int bits : {1, 4}) {
        DisplayProfile profile = loadProfile("perspecta");
        profile.slicesPerHalfTurn = slices;
        profile.width = profile.height = side;
        profile.colorBitsPerChannel = bits;
        if (bits > 1 && (slices != 198 || side != 768)) {
          continue;
        }
        Slicer slicer(profile);
        const SliceMesh prepared(orderedForSlicing(mesh));
        std::vector<Way> ways{{"Ocelli", [&] { slicer.slice(prepared); }}};
        runInterleaved(ways, choice.runs);
        rows.push_back({{"slices", slices},
                        {"side", side},
                        {"bits_per_channel", bits},
                        {"ms", ways[0].least},
                        {"stages", stagesJson(slicer.stages())},
                        {"memory_floor_ms", memoryFloor(profile, choice.runs)}});
        fmt::print("{}\n", rows.back().dump());
      }
    }
  }
  return rows;
}

nlohmann::ordered_json measureThreads(const Choice& choice, const DisplayProfile& profile) {
  const Mesh mesh = loadScene(fmt::format(kScene, 4600000));
  const SliceMesh prepared(orderedForSlicing(mesh));
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  const int most = threadCount();
  for (int threads = 1; threads <= most; ++threads) {
    setThreadCount(threads);
    Slicer slicer(profile);
    std::vector<Way> ways{{"Ocelli", [&] { slicer.slice(prepared); }}};
    runInterleaved(ways, choice.runs);
    rows.push_back(
        {{"threads", threads}, {"ms", ways[0].least}, {"memory_floor_ms", memoryFloor(profile, choice.runs)}});
    fmt::print("{}\n", rows.back().dump());
  }
  setThreadCount(choice.threads);
  return rows;
}

/// From moved vertices to the new volume: directly, and by way of the image of a camera that was made before.
nlohmann::ordered_json measureTimeline(const Choice& choice, const DisplayProfile& profile) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const double thousand : choice.thousands) {
    Mesh mesh = orderedForSlicing(sceneOf(thousand));
    SliceMesh prepared(mesh);
    Slicer direct(profile);
    Slicer reduced(profile);
    const PinholeCamera pinhole(View{}, 720, 480);
    const auto camera = buildDdocCamera(pinhole, mesh);
    constexpr int kFrames = 7;
    std::vector<std::vector<double>> times(6);
    for (int frame = 0; frame < kFrames; ++frame) {
      for (glm::vec3& p : mesh.positions) {
        p.y += frame % 2 == 0 ? 1e-3f : -1e-3f;
      }
      times[0].push_back(milliseconds([&] { prepared.setPositions(mesh.positions); }));
      times[1].push_back(milliseconds([&] { direct.slice(prepared); }));
      ReferenceImage image;
      times[2].push_back(milliseconds([&] { image = buildDdocImage(camera, mesh); }));
      Mesh ocri;
      times[3].push_back(milliseconds([&] { ocri = imageMesh(image); }));
      std::optional<SliceMesh> ocriPrepared;
      times[4].push_back(milliseconds([&] { ocriPrepared.emplace(ocri); }));
      times[5].push_back(milliseconds([&] { reduced.slice(*ocriPrepared); }));
    }
    std::vector<double> middle;
    for (std::vector<double>& each : times) {
      std::ranges::sort(each);
      middle.push_back(each[kFrames / 2]);
    }
    rows.push_back({{"triangles", mesh.triangles.size()},
                    {"direct", {{"move_ms", middle[0]}, {"slice_ms", middle[1]}, {"total_ms", middle[0] + middle[1]}}},
                    {"by_image",
                     {{"image_ms", middle[2]},
                      {"mesh_ms", middle[3]},
                      {"prepare_ms", middle[4]},
                      {"slice_ms", middle[5]},
                      {"total_ms", middle[2] + middle[3] + middle[4] + middle[5]}}}});
    fmt::print("{}\n", rows.back().dump());
    std::fflush(stdout);
  }
  return rows;
}

void drawTriangles(const nlohmann::ordered_json& rows, const std::string& path) {
  LineChart chart{"Time for a volume by triangles", "Triangles", "Milliseconds for a volume", {}};
  for (const char* name :
       {"Ocelli", "Ocelli, exact", "naive, one thread", "vtkPlaneCutter", "vtkCutter", "OpenVDB meshToVolume"}) {
    LineChart::Curve curve{name, {}};
    for (const auto& row : rows) {
      if (row["mesh"] == "geometry" && row["ms"].contains(name)) {
        curve.points.push_back({row["triangles"].get<double>(), row["ms"][name].get<double>()});
      }
    }
    if (!curve.points.empty()) {
      chart.curves.push_back(curve);
    }
  }
  writeFile(path, svgText(lineFigure(chart)));
}

/// Holds the slicer to an instruction set that this processor has and that the slicer was compiled for.
void useInstructionSet(const std::string& name) {
  std::string names;
  for (int64_t targets = hwy::SupportedTargets(); targets != 0; targets &= targets - 1) {
    hwy::SetSupportedTargetsForTest(targets & -targets);
    const std::string used = sliceInstructionSet();
    if (name == used) {
      return;
    }
    if (names.find(used) == std::string::npos) {
      names += (names.empty() ? "" : ", ") + used;
    }
    hwy::SetSupportedTargetsForTest(0);
  }
  throw InputError("there is no such instruction set here", "--instruction-set " + name, "use one of " + names);
}

void measure(const Choice& choice) {
  if (!choice.instructionSet.empty()) {
    useInstructionSet(choice.instructionSet);
  }
  const DisplayProfile profile = loadProfile("perspecta");
  nlohmann::ordered_json json = {{"processor", machineInfo().processor},
                                 {"threads", threadCount()},
                                 {"instruction_set", sliceInstructionSet()},
                                 {"profile", profile.name},
                                 {"runs", choice.runs},
                                 {"memory_floor_ms", memoryFloor(profile, choice.runs)}};
#ifdef OCELLI_BENCH_VTK
  json["vtk_threads"] = vtkThreads();
#endif
  fmt::print("{}\n", json.dump(2));
  const auto wants = [&](const char* part) { return std::ranges::find(choice.parts, part) != choice.parts.end(); };
  if (wants("triangles")) {
    json["by_triangles"] = measureTriangles(choice, profile);
  }
  if (wants("profiles")) {
    json["by_profile"] = measureProfiles(choice);
  }
  if (wants("threads")) {
    json["by_threads"] = measureThreads(choice, profile);
  }
  if (wants("timeline")) {
    json["timeline"] = measureTimeline(choice, profile);
  }
  if (!choice.json.empty()) {
    writeFile(choice.json, json.dump(2) + "\n");
  }
  if (!choice.svg.empty() && json.contains("by_triangles")) {
    drawTriangles(json["by_triangles"], choice.svg);
  }
}

}  // namespace
}  // namespace ocelli

int main(int argumentCount, char** arguments) {
  ocelli::Choice choice;
  CLI::App program("Measures slicing, and others who do it", "slicer_bench");
  ocelli::addCommonOptions(program, choice);
  program.add_option("--parts", choice.parts, "Of triangles, profiles, threads, timeline")
      ->delimiter(',')
      ->check(CLI::IsMember({"triangles", "profiles", "threads", "timeline"}));
  program.add_option("--thousands", choice.thousands, "Triangles of the scenes, in thousands")->delimiter(',');
  program.add_option("--instruction-set", choice.instructionSet, "AVX2, for example; the best one where left out");
  program.add_flag("!--no-peers", choice.peers, "Without other slicers");
  program.add_option("--json", choice.json, "Where the figures go");
  program.add_option("--svg", choice.svg, "Where a chart of times by triangles goes");
  return ocelli::runProgram(program, argumentCount, arguments, choice, ocelli::measure);
}
