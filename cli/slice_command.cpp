// `ocelli slice`: from a scene, a mesh or a reference image to the slices of a display.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>

#include "cli/command.h"
#include "cli/gl_display.h"
#include "cli/gl_drawing.h"
#include "cli/output_option.h"
#include "cli/scene_options.h"
#include "display_sim/exact_slicer.h"
#include "display_sim/svol_file.h"
#include "oc_core/base/output_file.h"
#include "oc_core/ocri/reference_image_file.h"
#include "oc_core/ocri/union_mesh.h"

namespace ocelli {
namespace {

struct SliceChoice {
  SceneChoice scene;
  std::string profile = "perspecta";
  bool undithered = false;
  bool json = false;
  std::string method = "processor";
  std::string gl = "auto";
  std::string output;
};

Mesh loadMesh(const SceneChoice& scene, const Progress& progress) {
  return scene.source.ends_with(".exr") ? unionMesh(readReferenceImages(scene.source))
                                        : loadScene(scene.source, scene.options, progress);
}

bool liesWithin(const Mesh& mesh, const DisplayProfile& profile) {
  constexpr double kRounding = 1e-5;  // of fitting a scene
  return std::ranges::all_of(mesh.positions, [&](const glm::vec3& p) {
    return std::hypot(p.x, p.z) <= 1 + kRounding && std::abs(p.y) <= profile.halfHeightRadii + kRounding;
  });
}

/// What `ocelli volume info` tells of the volume later.
std::string metadataOf(const SliceChoice& choice) {
  const nlohmann::ordered_json json = {{"software", "ocelli " OCELLI_VERSION},
                                       {"scene", choice.scene.source},
                                       {"dither", choice.undithered ? "none: any light is full light" : "ordered"}};
  return json.dump();
}

void run(const SliceChoice& choice, const Frame& frame) {
  requireGlUsed(choice.gl, choice.method == "gl", "--method gl");
  checkWritable(choice.output);
  const auto gl = choice.method == "gl" ? std::make_unique<GlDisplay>(choice.gl) : nullptr;
  const DisplayProfile profile = loadProfile(choice.profile);
  const Mesh mesh = loadMesh(choice.scene, frame.progress());
  const auto start = std::chrono::steady_clock::now();
  const SliceOptions options{choice.undithered ? ColorReduction::kOccupancy : ColorReduction::kDither};
  const Volume volume = gl != nullptr ? gl->slice(mesh, profile, options) : sliceExactly(mesh, profile, options);
  const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
  writeSvol(choice.output, volume, metadataOf(choice));
  if (!liesWithin(mesh, profile)) {
    frame.note("a part of the scene lies outside of the display and is cut off");
  }
  if (choice.json) {
    const nlohmann::ordered_json json = {{"profile", profile.name},
                                         {"triangles", mesh.triangles.size()},
                                         {"slices", volume.slices()},
                                         {"lit_voxels", volume.litVoxels()},
                                         {"slice_ms", time.count()}};
    frame.print(json.dump(2) + "\n");
  }
  if (gl != nullptr) {
    frame.note("sliced with " + gl->description());
  }
  frame.note(fmt::format("wrote {}: {} slices of {}x{}, {} lit voxels from {} triangles in {:.0f} ms", choice.output,
                         volume.slices(), volume.width(), volume.height(), volume.litVoxels(), mesh.triangles.size(),
                         time.count()));
}

}  // namespace

void addSliceCommand(CLI::App& program, const Frame& frame) {
  CLI::App& command =
      *program.add_subcommand("slice", "Slice a scene, a mesh or a reference image (.exr) for a display");
  const auto choice = std::make_shared<SliceChoice>();
  addSceneOptions(command, choice->scene);
  command.add_option("--profile", choice->profile, "The display: a name, or a profile of your own")
      ->type_name("NAME|FILE.json");
  command.add_flag("--undithered", choice->undithered, "Light a channel wherever it has any light at all");
  addMethodOption(command, choice->method);
  addGlOption(command, choice->gl);
  command.add_flag("--json", choice->json, "Print the figures as JSON");
  addOutputOption(command, choice->output, "Where the volume goes", {".svol"});
  frame.finish(command,
               "  ocelli slice builtin:teapot -o teapot.svol\n"
               "  ocelli slice statues.exr --profile perspecta-99 -o statues.svol\n"
               "  ocelli slice statues.ply --no-fit --shading none -o statues.svol   (a mesh of `ocelli ocri mesh`)",
               [choice, frame] { run(*choice, frame); });
}

}  // namespace ocelli
