#include "cli/camera_osl_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "cli/camera_rays_command.h"
#include "cli/command.h"
#include "cli/output_option.h"
#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/base/output_file.h"
#include "oc_core/camera_shader/closed_form_shader.h"
#include "oc_core/camera_shader/ray_texture_shader.h"
#include "oc_core/constructor/camera_constructors.h"

namespace ocelli {
namespace {

constexpr const char* kShaderEnding = ".osl";

struct OslChoice {
  RaysChoice rays;
  bool lookup = false;
  std::string texture;
  std::string output;
};

/// Writes the camera by its formula, where it has one and the user wants it.
bool writeClosedForm(const OslChoice& choice, const PinholeCamera& reference, const CommandContext& context) {
  if (choice.lookup || namesConstructor(choice.rays.camera)) {
    return false;
  }
  const CameraChoice camera = cameraChoice(choice.rays.camera);
  const ClosedForm* form = findClosedForm(camera);
  if (form == nullptr) {
    return false;
  }
  refuseImageNumber(choice.rays);
  if (!choice.texture.empty()) {
    throw InputError("the shader of camera \"" + choice.rays.camera + "\" computes its rays and reads no texture",
                     "--texture", "leave it out, or add --lookup");
  }
  writeFile(choice.output, closedFormShader(*form, camera, reference));
  context.note(fmt::format("wrote {}: it computes the rays of \"{}\", {}x{} pixels", choice.output, camera.name,
                           reference.width(), reference.height()));
  return true;
}

/// Beside the shader, where the user says nothing else.
std::string texturePath(const OslChoice& choice) {
  if (!choice.texture.empty()) {
    return choice.texture;
  }
  const std::filesystem::path shader(choice.output);
  if (shader.extension() != kShaderEnding) {
    throw InputError("the shader reads its rays from a texture, which needs a file", "--texture",
                     "give one, or let -o name a file that ends in .osl");
  }
  return shader.parent_path() / (shader.stem().string() + "_rays.exr");
}

void writeShader(const OslChoice& choice, const CommandContext& context) {
  checkWritable(choice.output);
  const PinholeCamera reference = raysReference(choice.rays);
  if (writeClosedForm(choice, reference, context)) {
    return;
  }
  const std::string texture = texturePath(choice);
  checkSecondOutput(texture, "--texture", choice.output);
  const RayMap map = raysOf(choice.rays, reference, context);
  const std::string shader = rayTextureShader(map, std::filesystem::absolute(texture).lexically_normal().string());
  writeFile(texture, rayTextureBytes(map, context.progress()));
  writeFile(choice.output, shader);
  context.note(fmt::format("wrote {}, which reads {} rays of {}x{} pixels from {}", choice.output, map.rayCount(),
                           map.width(), map.height(), texture));
}

}  // namespace

void addCameraOsl(CLI::App& camera, const CommandContext& context) {
  CLI::App& command = *camera.add_subcommand(
      "osl",
      "Write a camera for other renderers: as a shader in the Open Shading Language, as Blender's Cycles takes it");
  const auto choice = std::make_shared<OslChoice>();
  addRaysOptions(command, choice->rays, context);
  command.add_flag("--lookup", choice->lookup, "Read the rays from a texture, of cameras with a formula too");
  addSecondOutputOption(command, "--texture", choice->texture,
                        "Where the rays go that the shader reads: beside the shader, X_rays.exr, where not given; "
                        "di, gpc, panorama and cylinder need none",
                        {".exr"});
  addOutputOption(command, choice->output, "Where the shader goes (docs/ray_maps.md)", {kShaderEnding});
  context.finish(command,
                 "  ocelli camera osl gpc --view street.json --size 1280x720 -o gpc.osl\n"
                 "  ocelli camera osl rppc --scene builtin:statues -o rppc.osl",
                 [choice, context] { writeShader(*choice, context); });
}

}  // namespace ocelli
