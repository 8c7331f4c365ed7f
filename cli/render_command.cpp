#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <optional>

#include "cli/antialiased_render.h"
#include "cli/command.h"
#include "cli/gl_drawing.h"
#include "cli/interrupt.h"
#include "cli/motion_times.h"
#include "cli/output_option.h"
#include "cli/scene_notes.h"
#include "cli/scene_options.h"
#include "cli/values.h"
#include "cli/viewed_scene.h"
#include "cli/volume_options.h"
#include "cli/volume_render.h"
#include "display_sim/observing/frame_sink.h"
#include "oc_core/base/error.h"
#include "oc_core/base/output_file.h"
#include "oc_core/constructor/camera_constructors.h"
#include "oc_core/image/png_file.h"
#include "oc_core/multiperspective/multiperspective_image.h"
#include "oc_core/ocri/camera_choice.h"
#include "oc_core/ocri/nothing_seen.h"
#include "oc_core/ocri/reference_image_file.h"
#include "oc_core/ocri/technique_names.h"
#include "oc_core/render/identity_image.h"

namespace ocelli {
namespace {

constexpr ImageSize kRenderSize{720, 480};
constexpr const char* kRasterMethod = "raster";

struct RenderChoice {
  SceneChoice scene;
  VolumeChoice volume;
  VolumeRenderChoice volumeRender;
  std::string camera = "di";
  std::string method;  ///< empty where the user said none
  std::string gl = "auto";
  std::string view;
  std::string size;
  std::string identity;
  std::string antialias = "none";
  std::optional<double> framesPerSecond;
  std::string output;
};

std::vector<std::string> methodNames() {
  std::vector<std::string> names{kRasterMethod};
  for (const TechniqueName& each : kTechniqueNames) {
    names.emplace_back(each.name);
  }
  names.emplace_back("gl");
  return names;
}

FragmentImage drawn(const RenderChoice& choice, const MultiperspectiveCamera& camera, const Mesh& mesh,
                    const CommandContext& context) {
  if (choice.method.empty() || choice.method == kRasterMethod) {
    return rasterize(camera, mesh);
  }
  if (choice.method == "raycast") {
    return raycast(camera, mesh);
  }
  if (choice.method == "gl") {
    GlDrawing gl(choice.gl);
    context.note("drawn with " + gl.description());
    return draw(camera, gl.rendererOf(mesh));
  }
  throw InputError("graph and curved ray cameras are not drawn by " + choice.method, "--method",
                   "use raster, raycast or gl");
}

/// Graph and curved ray cameras, which have no reference image: nothing displaces a pinhole's image into theirs.
void renderMultiperspective(const RenderChoice& choice, const PinholeCamera& reference, const CommandContext& context) {
  const GuidedScene scene = loadGuidedScene(choice.scene.source, choice.scene.options, context.progress());
  const MultiperspectiveCamera camera = constructCamera(choice.camera, scene, reference);
  noteBlackScene(context, scene.mesh);
  const FragmentImage fragments = drawn(choice, camera, scene.mesh, context);
  if (std::none_of(fragments.begin(), fragments.end(), [](const Fragment& each) { return each.covered(); })) {
    failSeeingNothing(reference, scene.mesh, "--camera " + choice.camera);
  }
  if (choice.output.ends_with(".exr")) {
    writeMultiperspectiveImage(choice.output, fragments, scene, camera);
  } else {
    writePng(choice.output, srgbFromLinear(colorImage(fragments, scene.mesh, skyColor())));
  }
  if (!choice.identity.empty()) {
    writePng(choice.identity, identityColors(identityImage(fragments, scene.objectOfTriangle)));
  }
  context.note(
      fmt::format("wrote {}: {} of {}x{}", choice.output, choice.camera, fragments.width(), fragments.height()));
}

/// The images of one mesh.
ReferenceImages imagesOf(const RenderChoice& choice, const CameraChoice& camera, const PinholeCamera& reference,
                         const Mesh& mesh, const Progress& progress) {
  const auto technique = techniqueNamed(choice.method);
  return technique ? ReferenceImages{drawReferenceImage(*technique, camera, reference, mesh, progress)}
                   : buildReferenceImages(camera, reference, mesh, progress);
}

[[noreturn]] void failUnion(const ReferenceImages& images, const std::string& output) {
  throw InputError("\"" + images.front().camera + "\" is a union of " + std::to_string(images.size()) +
                       " images, which one picture does not hold",
                   "-o " + output, "write an .exr file, which holds them all");
}

/// All of a scene's motion as a video, an image a frame.
void renderVideo(const RenderChoice& choice, const PinholeCamera& reference, const CommandContext& context) {
  constexpr double kUsualRate = 24;
  if (takesVolume(choice.scene) || choice.antialias != "none" || namesConstructor(choice.camera) ||
      choice.method == "gl" || !choice.identity.empty()) {
    throw InputError(
        "videos are of scenes of triangles, by cameras with a reference image, without OpenGL and antialiasing",
        "-o " + choice.output, "write a .png file of each moment (--time)");
  }
  refuseVolumeOptions(choice.volume);
  refuseVolumeRenderOptions(choice.volumeRender);
  const double rate = choice.framesPerSecond.value_or(kUsualRate);
  const CameraChoice camera = cameraChoice(choice.camera);
  const FramedMotion framed = loadFramedMotion(choice.scene, rate, context);
  runOrLeaveNothing(choice.output, context.progress(), [&](const Progress& progress) {
    std::unique_ptr<FrameSink> sink;
    for (const double seconds : framed.seconds) {
      report(progress, "frames", seconds / framed.motion->durationSeconds());
      const ReferenceImages images = imagesOf(choice, camera, reference, framed.motion->at(seconds), {});
      if (images.size() > 1) {
        failUnion(images, choice.output);
      }
      if (sink == nullptr) {
        sink = videoFile(choice.output, {images.front().width(), images.front().height(), rate});
      }
      sink->add(srgbFromLinear(images.front().color));
    }
    sink->finish();
  });
  context.note(fmt::format("wrote {}: {} frames of {:.3g} s", choice.output, framed.seconds.size(),
                           framed.motion->durationSeconds()));
}

void render(const RenderChoice& choice, const CommandContext& context) {
  requireGlUsed(choice.gl, choice.method == "gl", "--method gl");
  checkWritable(choice.output);
  checkSecondOutput(choice.identity, "--identity", choice.output);
  const ImageSize size = cameraImageSize(choice.camera, choice.size, kRenderSize);
  const PinholeCamera reference(cameraView(choice.camera, choice.view), size.width, size.height);
  if (isVideo(choice.output)) {
    return renderVideo(choice, reference, context);
  }
  if (choice.framesPerSecond) {
    throw InputError("one picture has no rate", "--frames-per-second", "leave it out, or give an .mp4 file");
  }
  if (takesVolume(choice.scene)) {
    refuseForVolumes(choice.antialias != "none", "--antialias", "has no antialiasing", "draw it in a larger --size");
    refuseForVolumes(!choice.identity.empty(), "--identity", "has no objects", "leave it out");
    return renderVolumeScene({choice.scene, choice.volume, choice.volumeRender, choice.camera, choice.method, choice.gl,
                              choice.output, reference},
                             context);
  }
  refuseVolumeOptions(choice.volume);
  refuseVolumeRenderOptions(choice.volumeRender);
  if (choice.antialias != "none") {
    if (!choice.identity.empty()) {
      throw InputError("averages tell of no single object", "--identity", "leave it out, or draw without --antialias");
    }
    return renderAntialiased({choice.scene, choice.camera, choice.method.empty() ? kRasterMethod : choice.method,
                              choice.antialias, choice.output, reference},
                             context);
  }
  if (namesConstructor(choice.camera)) {
    return renderMultiperspective(choice, reference, context);
  }
  if (!choice.identity.empty()) {
    throw InputError("only graph and curved ray cameras tell which object is at each pixel", "--identity",
                     "leave it out, or choose one of `ocelli camera list`");
  }
  const CameraChoice camera = cameraChoice(choice.camera);
  const auto gl = choice.method == "gl" ? std::make_unique<GlDrawing>(choice.gl) : nullptr;
  ViewedScene scene(choice.scene, context);
  const Mesh& mesh = scene.meshFor(camera, reference);
  const ReferenceImages images =
      gl != nullptr ? buildReferenceImages(camera, reference, mesh, context.progress(), gl->rendererOf(mesh))
                    : imagesOf(choice, camera, reference, mesh, context.progress());
  const ReferenceImage& image = images.front();
  if (choice.output.ends_with(".exr")) {
    writeReferenceImages(choice.output, images);
  } else if (images.size() > 1) {
    failUnion(images, choice.output);
  } else {
    writePng(choice.output, srgbFromLinear(image.color));
  }
  if (gl != nullptr) {
    context.note("drawn with " + gl->description());
  }
  context.note(fmt::format("wrote {}: {} of {}x{}", choice.output, image.camera, image.width(), image.height()));
}

}  // namespace

void addRenderCommand(CLI::App& program, const CommandContext& context) {
  CLI::App& command = *program.add_subcommand("render", "Render a scene with any camera");
  const auto choice = std::make_shared<RenderChoice>();
  addSceneOptions(command, choice->scene, context);
  addMotionOptions(command, choice->scene);
  addVolumeOptions(command, choice->volume);
  addVolumeRenderOptions(command, choice->volumeRender);
  addAnyCameraOption(command, choice->camera);
  command
      .add_option(
          "--method", choice->method,
          "How: fill projected triangles, splat samples of them, meet each with the rays around it, follow the rays "
          "(the reference), or draw on the GPU with OpenGL; of a volume along the rays, or with OpenGL")
      ->check(CLI::IsMember(methodNames()))
      ->default_str(kRasterMethod)
      ->type_name("NAME");
  addGlOption(command, choice->gl);
  addViewOption(command, choice->view);
  addCameraSizeOption(command, choice->size, kRenderSize);
  addAntialiasOption(command, choice->antialias);
  addOutputOption(command, choice->output,
                  "Where the image goes: PNG, or EXR with depth and offsets, or of graph and curved ray cameras "
                  "with depth, world points and objects, or of volumes with opacity, depth and world points; or a "
                  "video of all of the motion of a scene that moves",
                  {".png", ".exr", ".mp4", ".webm"});
  addFrameRateOption(command, choice->framesPerSecond, "Of a video: images a second; 24 by default");
  addSecondOutputOption(command, "--identity", choice->identity,
                        "Where an image goes of which object is at each pixel, in false colours", {".png"});
  context.finish(command,
                 "  ocelli render builtin:teapot -o teapot.png\n"
                 "  ocelli render builtin:statues --camera ddoc --size 1440x960 -o statues.png\n"
                 "  ocelli render builtin:statues --camera ddoc --method raycast -o reference.exr\n"
                 "  ocelli render builtin:statues --camera eoc-h --method gl -o statues.png\n"
                 "  ocelli render fox.glb --animation Run -o run.mp4\n"
                 "  ocelli render builtin:town --antialias extreme -o town.png\n"
                 "  ocelli render builtin:maze --camera comprehensive --size 1920x1200 -o maze.png\n"
                 "  ocelli render builtin:volume,name=skull --clip 'z>0' -o skull.png",
                 [choice, context] { render(*choice, context); });
}

}  // namespace ocelli
