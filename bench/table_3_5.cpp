// Table 3.5 of the dissertation, measured again: how long it takes to turn a scene at rest into the slices of the
// display, from its geometry, from its depth image (DI) and from its occlusion camera reference images (OCRI).
//
// The triangles of the scenes are those of the text. Geometry is sliced as it comes, made ready for the slicer each
// time, and as it stands in the slicer's best order, made once. Reference images are built from the scene's mesh in
// memory, and with --packs from a packed scene too: the clusters that the view needs, and the image. The peer in the
// same run is meshoptimizer: the scene decimated once to as many triangles as the OCRI has, its time taken as
// construction. Times are the least of --runs runs, after one run that is not counted; the slicer keeps its memory.
// Prints rows of a table in Markdown. turning_bench has scenes that move.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>

#include "bench/bench_program.h"
#include "bench/timing.h"
#include "display_sim/frames/display_profile.h"
#include "display_sim/slicing/slicer.h"
#include "oc_core/ocri/packed_view.h"
#include "oc_core/ocri/simplified_mesh.h"
#include "oc_core/ocri/union_mesh.h"
#include "oc_core/worlds/packed_source.h"

namespace ocelli {
namespace {

struct Choice {
  int runs = 5;
  int threads = 0;
  std::vector<std::string> scenes;
  std::vector<std::string> cameras{"di", "ddoc", "eoc-h", "eoc-hv"};
  std::string profile = "perspecta";
  std::string packs;
};

/// What the text has for one row, seconds; 0 where it has nothing.
struct Published {
  double slice = 0, construction = 0;
};

struct Case {
  const char* name;
  const char* scene;
  int width, height;
  Published geometry, depthImage, ocri;
};

constexpr Case kCases[] = {
    {"bunny", "builtin:room,mesh=bunny.obj,triangles=321000", 720, 480, {8.02}, {12.0}, {11.8, 2.73}},
    {"bunny-qr", "builtin:room,mesh=bunny.obj,triangles=321000", 180, 120, {7.81}, {0.766}, {0.75, 0.875}},
    {"buddhas", "builtin:statues,mesh=buddha.obj,triangles=4603000", 720, 480, {131}, {11.4}, {11.5, 12.1}},
    {"ten-million", "builtin:room,mesh=dragon.obj,triangles=10252000", 720, 480, {292}, {12.5}, {13.9, 20.3}},
};

/// Packed where it is not yet.
PackedScene packedScene(const Case& row, const std::string& folder) {
  std::string name = row.name;
  const std::filesystem::path path = std::filesystem::path(folder) / (name.substr(0, name.find("-qr")) + ".opack");
  if (!std::filesystem::exists(path)) {
    std::filesystem::create_directories(folder);
    packSource(row.scene, {}, path);
  }
  return PackedScene(path);
}

class Table {
 public:
  Table(const Choice& choice, const Case& row) : runs_(choice.runs), row_(row), slicer_(loadProfile(choice.profile)) {}

  void measure(const Choice& choice) {
    const Mesh scene = loadScene(row_.scene);
    const PinholeCamera camera(View{}, row_.width, row_.height);
    geometry_ = sliceTime(scene);
    print("geometry", scene, {}, {}, geometry_, row_.geometry);
    const Mesh ordered = orderedForSlicing(scene);
    const SliceMesh prepared(ordered);
    print("geometry, best order", ordered, {}, {}, leastMilliseconds(runs_, [&] { slicer_.slice(prepared); }), {});
    std::optional<PackedScene> packed;
    if (!choice.packs.empty()) {
      packed.emplace(packedScene(row_, choice.packs));
    }
    size_t ocriTriangles = 0;
    for (const std::string& name : choice.cameras) {
      const CameraChoice chosen = cameraChoice(name);
      Mesh mesh;
      const double build =
          leastMilliseconds(runs_, [&] { mesh = unionMesh(buildReferenceImages(chosen, camera, scene)); });
      std::optional<double> packedBuild;
      if (packed) {
        packedBuild =
            leastMilliseconds(runs_, [&] { mesh = unionMesh(buildReferenceImages(chosen, camera, *packed)); });
      }
      print(name, mesh, build, packedBuild, sliceTime(mesh),
            name == "di"     ? row_.depthImage
            : name == "ddoc" ? row_.ocri
                             : Published{});
      ocriTriangles = name == "ddoc" ? mesh.triangles.size() : ocriTriangles;
    }
    if (ocriTriangles > 0 && ocriTriangles < scene.triangles.size()) {
      Mesh simple;
      const double build =
          milliseconds([&] { simple = simplifyMesh(scene, ocriTriangles, SimplifyMethod::kTopological).mesh; });
      print("decimated", simple, build, {}, sliceTime(simple), {});
    }
  }

 private:
  double sliceTime(const Mesh& mesh) {
    return leastMilliseconds(runs_, [&] { slicer_.slice(SliceMesh(mesh)); });
  }

  void print(const std::string& what, const Mesh& mesh, std::optional<double> build, std::optional<double> packedBuild,
             double slice, const Published& text) const {
    const auto cell = [](std::optional<double> value, const char* format) {
      return value ? fmt::format(fmt::runtime(format), *value) : std::string();
    };
    const auto with = [&](std::optional<double> before) {
      return cell(before ? std::optional(geometry_ / (*before + slice)) : std::nullopt, "{:.2f}");
    };
    const bool known = text.slice > 0;
    fmt::print("| {} | {} | {:.0f} K | {} | {} | {:.1f} | {:.2f} | {} | {} | {} | {} |\n", row_.name, what,
               static_cast<double>(mesh.triangles.size()) / 1000, cell(build, "{:.0f}"), cell(packedBuild, "{:.0f}"),
               slice, geometry_ / slice, with(build), with(packedBuild),
               known ? cell(row_.geometry.slice / text.slice, "{:.1f}") : "",
               text.construction > 0 ? cell(row_.geometry.slice / (text.construction + text.slice), "{:.1f}") : "");
    std::fflush(stdout);
  }

  int runs_;
  const Case& row_;
  Slicer slicer_;
  double geometry_ = 0;
};

void measure(const Choice& choice) {
  fmt::print("{} threads, display {}, least of {} runs, milliseconds\n\n", threadCount(), choice.profile, choice.runs);
  fmt::print(
      "| scene | sliced | triangles | build, mesh | build, pack | slice | speedup | with build, mesh | with build, "
      "pack "
      "| the text: speedup | with build |\n| --- | --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: "
      "|\n");
  for (const Case& row : kCases) {
    if (choice.scenes.empty() || std::ranges::find(choice.scenes, row.name) != choice.scenes.end()) {
      Table(choice, row).measure(choice);
    }
  }
}

}  // namespace
}  // namespace ocelli

int main(int argumentCount, char** arguments) {
  ocelli::Choice choice;
  CLI::App program("Table 3.5: time to slice geometry, depth image and OCRI. Needs OCELLI_DATA_DIR.", "table_3_5");
  program.add_option("--runs", choice.runs, "Runs a figure")->check(CLI::Range(1, 1000))->capture_default_str();
  program.add_option("--threads", choice.threads, "0 stands for all cores")->check(CLI::Range(0, 1024));
  program.add_option("--scenes", choice.scenes, "Of bunny, bunny-qr, buddhas, ten-million; all where left out")
      ->delimiter(',')
      ->check(CLI::IsMember({"bunny", "bunny-qr", "buddhas", "ten-million"}));
  program.add_option("--cameras", choice.cameras, "Which")->delimiter(',');
  program.add_option("--profile", choice.profile, "Display profile")->capture_default_str();
  program.add_option("--packs", choice.packs, "Builds from packed scenes too: their folder, 0.7 GB when they are made");
  return ocelli::runProgram(program, argumentCount, arguments, choice, ocelli::measure);
}
