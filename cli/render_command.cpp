#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "cli/command.h"
#include "cli/gl_drawing.h"
#include "cli/output_option.h"
#include "cli/scene_options.h"
#include "cli/values.h"
#include "oc_core/base/error.h"
#include "oc_core/base/output_file.h"
#include "oc_core/base/png_file.h"
#include "oc_core/ocri/camera_choice.h"
#include "oc_core/ocri/reference_image_file.h"

namespace ocelli {
namespace {

struct RenderChoice {
  SceneChoice scene;
  std::string camera = "di";
  std::string method = "raster";
  std::string gl = "auto";
  std::string view;
  std::string size = "720x480";
  std::string output;
};

/// Nothing for "raster", what a camera builds its image with, and for "gl".
std::optional<Technique> techniqueOf(const std::string& method) {
  if (method == "points") {
    return Technique::kPoints;
  }
  if (method == "hybrid") {
    return Technique::kHybrid;
  }
  return method == "raycast" ? std::optional(Technique::kRaycast) : std::nullopt;
}

void render(const RenderChoice& choice, const Frame& frame) {
  requireGlUsed(choice.gl, choice.method == "gl", "--method gl");
  checkWritable(choice.output);
  const CameraChoice camera = cameraChoice(choice.camera);
  const ImageSize size = imageSizeFromText(choice.size, "--size");
  const PinholeCamera reference(readViewOption(choice.view), size.width, size.height);
  const auto gl = choice.method == "gl" ? std::make_unique<GlDrawing>(choice.gl) : nullptr;
  const Mesh mesh = loadScene(choice.scene.source, choice.scene.options, frame.progress());
  const auto technique = techniqueOf(choice.method);
  const ReferenceImages images =
      technique       ? ReferenceImages{drawReferenceImage(*technique, camera, reference, mesh, frame.progress())}
      : gl != nullptr ? buildReferenceImages(camera, reference, mesh, frame.progress(), gl->drawerOf(mesh))
                      : buildReferenceImages(camera, reference, mesh, frame.progress());
  const ReferenceImage& image = images.front();
  if (choice.output.ends_with(".exr")) {
    writeReferenceImages(choice.output, images);
  } else if (images.size() > 1) {
    throw InputError("\"" + image.camera + "\" is a union of " + std::to_string(images.size()) +
                         " images, which one PNG does not hold",
                     "-o " + choice.output, "write an .exr file, which holds them all");
  } else {
    writePng(choice.output, srgbFromLinear(image.color));
  }
  if (gl != nullptr) {
    frame.note("drawn with " + gl->description());
  }
  frame.note(fmt::format("wrote {}: {} of {}x{}", choice.output, image.camera, image.width(), image.height()));
}

}  // namespace

void addRenderCommand(CLI::App& program, const Frame& frame) {
  CLI::App& command = *program.add_subcommand("render", "Render a scene with any camera");
  const auto choice = std::make_shared<RenderChoice>();
  addSceneOptions(command, choice->scene);
  addCameraOption(command, choice->camera);
  command
      .add_option(
          "--method", choice->method,
          "How: fill projected triangles, splat samples of them, meet each with the rays around it, follow the rays "
          "(the reference), or draw on the GPU with OpenGL")
      ->check(CLI::IsMember({"raster", "points", "hybrid", "raycast", "gl"}))
      ->type_name("NAME");
  addGlOption(command, choice->gl);
  addViewOption(command, choice->view);
  addSizeOption(command, choice->size);
  addOutputOption(command, choice->output, "Where the image goes: PNG, or EXR with depth and offsets",
                  {".png", ".exr"});
  frame.finish(command,
               "  ocelli render builtin:teapot -o teapot.png\n"
               "  ocelli render builtin:statues --camera ddoc --size 1440x960 -o statues.png\n"
               "  ocelli render builtin:statues --camera ddoc --method raycast -o reference.exr\n"
               "  ocelli render builtin:statues --camera eoc-h --method gl -o statues.png",
               [choice, frame] { render(*choice, frame); });
}

}  // namespace ocelli
