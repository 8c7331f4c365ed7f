#include "cli/volume_render.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <nlohmann/json.hpp>

#include "cli/gl_volume.h"
#include "cli/number_check.h"
#include "cli/values.h"
#include "oc_core/base/error.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/base/parallel.h"
#include "oc_core/image/png_file.h"
#include "oc_core/volume_camera/volume_camera.h"
#include "oc_core/volume_camera/volume_image_file.h"
#include "oc_core/volume_camera/volume_surfaces.h"
#include "oc_core/volume_render/volume_renderer.h"
#include "oc_core/volume_render/volume_target.h"

namespace ocelli {
namespace {

constexpr const char* kVolumeFrame = "volume";
constexpr const char* kGlMethod = "gl";

double secondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// The most memory that this program has held so far.
double peakMebibytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;  // Linux tells kibibytes
}

VolumeScene volumeWithSurfaces(const VolumeRender& render, const CommandContext& context) {
  VolumeScene scene = loadVolume(render.scene, render.volume, context);
  const VolumeRenderChoice& options = render.options;
  if (!options.surfaces.empty()) {
    const SceneOptions meshOptions{.shading = render.scene.options.shading, .warn = render.scene.options.warn};
    addSurfaces(scene, options.surfaces,
                options.surfacesFrame.empty() || options.surfacesFrame == kVolumeFrame ? SurfaceFrame::kVolume
                                                                                       : SurfaceFrame::kScene,
                meshOptions, context.progress());
  }
  return scene;
}

void checkChoice(const VolumeRender& render) {
  const VolumeRenderChoice& options = render.options;
  refuseForVolumes(!render.method.empty() && render.method != "raycast" && render.method != kGlMethod, "--method",
                   "is not drawn by " + render.method, "use raycast, the default, or gl");
  if (options.surfaces.empty() && !options.surfacesFrame.empty()) {
    throw InputError("there are no surfaces to stand anywhere", "--surfaces-frame", "give --surfaces, or leave it out");
  }
  if (!options.background.empty() && render.output.ends_with(".exr")) {
    throw InputError("an EXR image keeps its opacity in place of a background", "--background",
                     "leave it out, or write a .png file");
  }
}

}  // namespace

void addVolumeRenderOptions(CLI::App& command, VolumeRenderChoice& choice) {
  command
      .add_option("--step", choice.step,
                  fmt::format("Of a volume: the distance of samples along rays, in voxels; {} by default",
                              VolumeRenderOptions{}.step))
      ->check(numberCheck(1.0 / 64, 64))
      ->type_name("VOXELS");
  command
      .add_option("--surfaces", choice.surfaces,
                  "Of a volume: a scene of triangles that stands in it, opaque; it takes --shading too")
      ->type_name("SCENE");
  command
      .add_option(
          "--surfaces-frame", choice.surfacesFrame,
          "The coordinates that these have: those of the volume's file, of patients LPS, or those of the scene, as "
          "meshes that `ocelli scene export --iso` wrote of it")
      ->check(CLI::IsMember({kVolumeFrame, "scene"}))
      ->default_str(kVolumeFrame)
      ->type_name("NAME");
  command.add_option("--background", choice.background, "Of a volume: the colour behind it in a PNG")
      ->default_str("#000000")
      ->type_name("#RRGGBB");
  command.add_flag("--json", choice.json, "Of a volume: print what the picture took and shows as JSON");
}

void refuseVolumeRenderOptions(const VolumeRenderChoice& choice) {
  refuseVolumeOption(choice.step.has_value(), "--step");
  refuseVolumeOption(!choice.surfaces.empty(), "--surfaces");
  refuseVolumeOption(!choice.surfacesFrame.empty(), "--surfaces-frame");
  refuseVolumeOption(!choice.background.empty(), "--background");
  refuseVolumeOption(choice.json, "--json");
}

void refuseForVolumes(bool isGiven, const std::string& option, const std::string& what, const std::string& next) {
  if (isGiven) {
    throw InputError("a volume " + what, option, next + ", or draw the surface at a value: --iso VALUE");
  }
}

void renderVolumeScene(const VolumeRender& render, const CommandContext& context) {
  checkChoice(render);
  const std::string& background = render.options.background;
  const glm::vec3 behind = background.empty() ? glm::vec3(0) : colorFromText(background, "--background");
  const auto gl = render.method == kGlMethod ? std::make_unique<GlVolumeDrawing>(render.gl) : nullptr;
  const auto loading = std::chrono::steady_clock::now();
  VolumeRenderOptions options;
  options.step = render.options.step.value_or(options.step);
  const VolumeRenderer renderer(volumeWithSurfaces(render, context), options);
  if (gl) {
    gl->upload(renderer.scene(), options, context.progress());
  }
  const double loadSeconds = secondsSince(loading);
  const VolumeTarget firstHits(renderer);
  const VolumeCamera camera = volumeCamera(
      render.camera, render.reference, renderer.scene(), [&]() -> const RayTarget& { return firstHits; },
      context.progress());
  const auto drawing = std::chrono::steady_clock::now();
  const VolumeImage image =
      gl ? gl->render(camera.size, camera.ray, context.progress())
         : renderer.render(camera.size.x, camera.size.y, camera.ray, context.progress(), camera.hull, camera.isSmooth);
  const double drawSeconds = secondsSince(drawing);
  const VolumeImageFacts facts = factsOf(image);
  if (facts.touched == 0) {
    failShowingNothing(camera, renderer.scene());
  }
  if (render.output.ends_with(".exr")) {
    writeVolumeImage(render.output, image, camera, options.depthOpacity);
  } else {
    writePng(render.output, srgbFromLinear(imageBefore(behind, image)));
  }
  if (render.options.json) {
    const glm::ivec3 voxels = renderer.scene().volume->grid().size;
    const nlohmann::ordered_json json = {{"camera", camera.name},
                                         {"width", camera.size.x},
                                         {"height", camera.size.y},
                                         {"voxels", {voxels.x, voxels.y, voxels.z}},
                                         {"step", options.step},
                                         {"samples", facts.samples},
                                         {"pixels_touched", facts.touched},
                                         {"pixels_opaque", facts.opaque},
                                         {"mean_opacity", facts.meanOpacity},
                                         {"load_seconds", loadSeconds},
                                         {"draw_seconds", drawSeconds},
                                         {"threads", threadCount()},
                                         {"peak_mib", peakMebibytes()}};
    context.print(textOfJson(json, 2) + "\n");
  }
  if (gl) {
    context.note("drawn with " + gl->description());
  }
  context.note(fmt::format("wrote {}: {} of {}x{}, {:.1f} million samples in {:.2f} s", render.output, camera.name,
                           camera.size.x, camera.size.y, static_cast<double>(facts.samples) / 1e6, drawSeconds));
}

}  // namespace ocelli
