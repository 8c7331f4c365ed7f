// `ocelli slice`: from a scene, a mesh, a reference image or a volume to the slices of a display.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>

#include "cli/command.h"
#include "cli/gl_display.h"
#include "cli/gl_drawing.h"
#include "cli/interrupt.h"
#include "cli/motion_times.h"
#include "cli/output_option.h"
#include "cli/scene_notes.h"
#include "cli/scene_options.h"
#include "cli/slicing_options.h"
#include "cli/volume_slicing_options.h"
#include "display_sim/frames/svol_file.h"
#include "display_sim/frames/svol_writer.h"
#include "display_sim/slicing/exact_slicer.h"
#include "display_sim/slicing/shared_slicing.h"
#include "display_sim/slicing/slicer.h"
#include "oc_core/base/error.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/base/output_file.h"
#include "oc_core/base/parallel.h"

namespace ocelli {
namespace {

struct SliceChoice {
  SceneChoice scene;
  std::string profile = "perspecta";
  SlicingChoice slicing;
  VolumeChoice volume;
  VolumeSlicingChoice volumeSlicing;
  std::optional<double> framesPerSecond;
  int repeat = 1;
  bool json = false;
  std::string method = "cpu";
  std::string gl = "auto";
  std::string output;
};

double millisecondsOf(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

/// Milliseconds.
struct Times {
  double preparing = 0;
  std::vector<double> slicing;

  template <class Work>
  auto run(int repeat, Work&& work) {
    for (int i = 1; i < repeat; ++i) {
      slicing.push_back(millisecondsOf([&] { work(); }));
    }
    std::optional<Volume> volume;
    slicing.push_back(millisecondsOf([&] { volume = work(); }));
    return std::move(*volume);
  }

  double least() const { return *std::ranges::min_element(slicing); }
  double median() const {
    std::vector<double> sorted = slicing;
    std::ranges::sort(sorted);
    return sorted[sorted.size() / 2];
  }
};

/// What is sliced more than once is put in order first. The volume is that of a single run, in the order given: which
/// of two triangles samples the side that they share depends on the order.
Volume sliceFast(const Mesh& mesh, const DisplayProfile& profile, const SliceOptions& options, int repeat,
                 Times& times) {
  std::optional<SliceMesh> prepared;
  std::optional<Slicer> slicer;
  times.preparing = millisecondsOf([&] {
    prepared.emplace(repeat > 1 ? orderedForSlicing(mesh) : mesh);
    slicer.emplace(profile, options);
  });
  for (int i = 0; i < repeat; ++i) {
    times.slicing.push_back(millisecondsOf([&] { slicer->slice(*prepared); }));
  }
  if (repeat > 1) {
    slicer->slice(SliceMesh(mesh));
  }
  return slicer->takeVolume();
}

/// A volume of scalars, straight from its field.
void runVolume(const SliceChoice& choice, const CommandContext& context) {
  if (choice.method == "gl" || context.ranks().size() > 1) {
    throw InputError("volumes are sliced by one program on CPUs alone",
                     choice.method == "gl" ? "--method gl" : "mpirun", "use --method cpu, without mpirun");
  }
  requireGlUsed(choice.gl, false, "--method gl");
  const SliceOptions options = volumeSliceOptionsOf(choice.slicing);
  checkWritable(choice.output);
  const DisplayProfile profile = loadProfile(choice.profile);
  Times times;
  std::optional<ShownVolume> shown;
  times.preparing = millisecondsOf([&] {
    shown.emplace(loadShownVolume({choice.scene, choice.volume, choice.volumeSlicing}, profile, context));
  });
  VolumeSlicer slicer(profile, options);
  for (int i = 0; i < choice.repeat; ++i) {
    // With its tables, as where the transfer function moves.
    times.slicing.push_back(
        millisecondsOf([&] { slicer.slice(shown->samples(), shown->lightOf(shown->scene().appearance.transfer)); }));
  }
  const Volume volume = slicer.takeVolume();
  writeSvol(choice.output, volume, sliceMetadata(choice.scene, choice.slicing));
  const size_t lit = volume.litVoxels();
  const glm::ivec3& size = shown->scene().volume->grid().size;
  if (choice.json) {
    const nlohmann::ordered_json json = {{"profile", profile.name},       {"size", {size.x, size.y, size.z}},
                                         {"slices", volume.slices()},     {"lit_voxels", lit},
                                         {"slice_ms", times.least()},     {"slice_ms_median", times.median()},
                                         {"prepare_ms", times.preparing}, {"sampled_bytes", shown->samples().bytes()},
                                         {"runs", times.slicing.size()},  {"volumes_per_second", 1000 / times.least()},
                                         {"threads", threadCount()}};
    context.print(textOfJson(json, 2) + "\n");
  }
  if (lit == 0) {
    context.note("warning: nothing of the volume has light: look at --transfer, --mask, --iso, --clip and --cutaway");
  }
  context.note(fmt::format(
      "wrote {}: {} slices of {}x{}, {} lit voxels from {}x{}x{} in {:.0f} ms, prepared in {:.0f} ms", choice.output,
      volume.slices(), volume.width(), volume.height(), lit, size.x, size.y, size.z, times.least(), times.preparing));
}

/// What of the options is of a single volume.
void requireRecordable(const SliceChoice& choice, const CommandContext& context) {
  const std::string option = "--frames-per-second";
  if (isVolumeSource(choice.scene.source)) {
    throw InputError("volumes of scalars are sliced one at a time", option,
                     "slice each, and join them: ocelli volume join");
  }
  if (choice.method == "gl" || choice.repeat > 1 || choice.json || context.ranks().size() > 1) {
    throw InputError("recordings are sliced by one program on CPUs, without figures", option,
                     "leave out --method gl, --repeat, --json and mpirun, or slice one moment (--time)");
  }
}

/// All of a scene's motion, each volume at its time.
void runRecording(const SliceChoice& choice, const CommandContext& context) {
  requireRecordable(choice, context);
  const SliceOptions options = sliceOptionsOf(choice.slicing);
  checkWritable(choice.output);
  const DisplayProfile profile = loadProfile(choice.profile);
  const bool exact = choice.slicing.exact || needsExactSlicer(options);
  const FramedMotion framed = loadFramedMotion(choice.scene, *choice.framesPerSecond, context);
  runOrLeaveNothing(choice.output, context.progress(), [&](const Progress& progress) {
    SvolWriter file(choice.output, profile, {.metadata = sliceMetadata(choice.scene, choice.slicing)});
    Slicer slicer(profile, options);
    for (const double seconds : framed.seconds) {
      report(progress, "slicing", seconds / framed.motion->durationSeconds());
      const Mesh& mesh = framed.motion->at(seconds);
      const auto microseconds = static_cast<uint64_t>(std::llround(seconds * 1e6));
      if (exact) {
        file.append(sliceExactly(mesh, profile, options), microseconds);
      } else {
        slicer.slice(SliceMesh(mesh));
        file.append(slicer.takeVolume(), microseconds);
      }
    }
    file.finish();
  });
  noteSlicedScene(context, framed.motion->mesh(), profile);
  context.note(fmt::format("wrote {}: {} volumes of {:.3g} s, {:g} a second", choice.output, framed.seconds.size(),
                           framed.motion->durationSeconds(), *choice.framesPerSecond));
}

void run(const SliceChoice& choice, const CommandContext& context) {
  if (choice.framesPerSecond) {
    refuseVolumeOptions(choice.volume);
    refuseVolumeSlicingOptions(choice.volumeSlicing);
    requireGlUsed(choice.gl, choice.method == "gl", "--method gl");
    return runRecording(choice, context);
  }
  if (isVolumeSource(choice.scene.source)) {
    return runVolume(choice, context);
  }
  refuseVolumeOptions(choice.volume);
  refuseVolumeSlicingOptions(choice.volumeSlicing);
  requireGlUsed(choice.gl, choice.method == "gl", "--method gl");
  const SliceOptions options = sliceOptionsOf(choice.slicing);
  if (choice.method == "gl" && needsCpu(options)) {
    throw InputError("OpenGL has the ordered dither alone, no antialiasing, and does not even out light", "--method gl",
                     "leave out --dither, --antialias and --even-light, or --method gl");
  }
  Ranks& ranks = context.ranks();
  if (ranks.size() > 1 && choice.method == "gl") {
    throw InputError("ranks slice together on CPUs alone", "--method gl", "use --method cpu, or run it without mpirun");
  }
  if (ranks.isFirst()) {
    checkWritable(choice.output);
  }
  const auto gl = choice.method == "gl" ? std::make_unique<GlDisplay>(choice.gl) : nullptr;
  const DisplayProfile profile = loadProfile(choice.profile);
  const bool exact = choice.slicing.exact || needsExactSlicer(options);
  const Mesh mesh = loadMeshToSlice(choice.scene, profile, choice.slicing.exact, context.progress());
  Times times;
  const auto together = [&] { return sliceTogether(mesh, profile, options, exact, ranks); };
  const Volume volume = ranks.size() > 1 ? times.run(choice.repeat, together)
                        : gl != nullptr  ? times.run(choice.repeat, [&] { return gl->slice(mesh, profile, options); })
                        : exact ? times.run(choice.repeat, [&] { return sliceExactly(mesh, profile, options); })
                                : sliceFast(mesh, profile, options, choice.repeat, times);
  if (!ranks.isFirst()) {
    return;
  }
  writeSvol(choice.output, volume, sliceMetadata(choice.scene, choice.slicing));
  noteSlicedScene(context, mesh, profile);
  if (choice.json) {
    const nlohmann::ordered_json json = {{"profile", profile.name},
                                         {"triangles", mesh.triangles.size()},
                                         {"slices", volume.slices()},
                                         {"lit_voxels", volume.litVoxels()},
                                         {"slice_ms", times.least()},
                                         {"slice_ms_median", times.median()},
                                         {"prepare_ms", times.preparing},
                                         {"runs", times.slicing.size()},
                                         {"volumes_per_second", 1000 / times.least()},
                                         {"threads", threadCount()},
                                         {"ranks", ranks.size()},
                                         {"instruction_set", sliceInstructionSet()}};
    context.print(textOfJson(json, 2) + "\n");
  }
  if (ranks.size() > 1) {
    context.note(fmt::format("sliced by {} ranks, each the slices of its angles", ranks.size()));
  }
  if (gl != nullptr) {
    context.note("sliced with " + gl->description());
  }
  context.note(fmt::format("wrote {}: {} slices of {}x{}, {} lit voxels from {} triangles in {:.0f} ms", choice.output,
                           volume.slices(), volume.width(), volume.height(), volume.litVoxels(), mesh.triangles.size(),
                           times.least()));
}

}  // namespace

void addSliceCommand(CLI::App& program, const CommandContext& context) {
  CLI::App& command =
      *program.add_subcommand("slice", "Slice a scene, a mesh, a reference image (.exr) or a volume for a display");
  const auto choice = std::make_shared<SliceChoice>();
  addSceneOptions(command, choice->scene, context);
  addMotionOptions(command, choice->scene);
  addProfileOption(command, choice->profile);
  addSlicingOptions(command, choice->slicing);
  addVolumeOptions(command, choice->volume);
  addVolumeSlicingOptions(command, choice->volumeSlicing);
  command.add_option("--repeat", choice->repeat, "Slice so often, and tell the shortest time")
      ->check(CLI::Range(1, 100000))
      ->type_name("COUNT");
  addFrameRateOption(command, choice->framesPerSecond,
                     "Of a scene that moves: a recording of all of its motion, so many volumes a second");
  addMethodOption(command, choice->method);
  addGlOption(command, choice->gl);
  command.add_flag("--json", choice->json, "Print the figures as JSON");
  addOutputOption(command, choice->output, "Where the volume goes", {".svol"});
  context.finishShared(
      command,
      "  ocelli slice builtin:teapot -o teapot.svol\n"
      "  ocelli slice fox.glb --animation Run --frames-per-second 15 -o run.svol\n"
      "  ocelli slice statues.exr --profile perspecta-99 -o statues.svol\n"
      "  ocelli slice statues.ply --no-fit --shading none -o statues.svol   (a mesh of `ocelli ocri mesh`)\n"
      "  ocelli slice builtin:volume,name=skull --transfer ct-bone --seen-opacity 0.5 -o skull.svol",
      [choice, context] { run(*choice, context); });
}

}  // namespace ocelli
