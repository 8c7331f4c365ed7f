#include "cli/scene_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "cli/number_check.h"
#include "oc_core/base/error.h"
#include "oc_core/base/printable_text.h"
#include "oc_core/constructor/camera_constructors.h"
#include "oc_core/ocri/camera_choice.h"
#include "oc_core/ray_map/ray_map_file.h"

namespace ocelli {
namespace {

const std::string kCameraHelp =
    "Camera, a JSON file with its options (`ocelli camera list NAME` tells them), or a ray map:";
constexpr const char* kCameraType = "NAME|FILE.json|RAYS.exr";
constexpr const char* kConstructorType = "NAME|FILE.json";

template <class Named>
std::string listOf(const std::vector<Named>& cameras) {
  std::string lines;
  for (const Named& each : cameras) {
    lines += std::string("\n  ") + each.name + ": " + each.description;
  }
  return lines;
}

constexpr const char* kSceneHelp =
    "A scene file (PLY, OBJ, STL, glTF, ...), a volume (NRRD, MetaImage, VTI, NIfTI, or a folder of DICOM slices) or "
    "builtin:NAME[,key=value...]";

/// How the scene is read, whatever names it.
void addReadingOptions(CLI::App& command, SceneChoice& choice, const CommandContext& context) {
  choice.options.warn = [context](const std::string& warning) { context.note("warning: " + printableText(warning)); };
  command.add_flag_callback(
      "--no-fit", [&choice] { choice.options.fit = false; }, "Leave the scene where it is, not in the unit sphere");
  command
      .add_option_function<std::string>(
          "--shading",
          [&choice](const std::string& name) {
            choice.options.shading = name == "none" ? Shading::kNone : Shading::kLambert;
            choice.shadingGiven = true;
          },
          "A fixed light on the vertex colours, or the colours as they are; of a volume by default what its transfer "
          "function says")
      ->check(CLI::IsMember({"lambert", "none"}))
      ->default_str("lambert")
      ->type_name("NAME");
  command.add_flag_callback(
      "--no-textures", [&choice] { choice.options.textures = false; }, "Leave the textures of a file out");
  command
      .add_option_function<std::string>(
          "--texture-triangles",
          [&choice](const std::string& text) {
            choice.options.textureTriangles = textureTrianglesFromText(text, "--texture-triangles");
          },
          "How many triangles the textures of a file may add: eight for each pixel of theirs or two, and textures that "
          "need more are halved in size until they do not. full: as many as a scene may have")
      ->default_str(std::to_string(kUsualTextureTriangles))
      ->type_name("N|full");
  command
      .add_option_function<std::string>(
          "--point-size",
          [&choice](const std::string& width) {
            choice.options.points.width = pointWidthFromText(width, "--point-size");
          },
          "Of a file with points or lines: how wide each is, in the units of the file; auto: points from their nearest "
          "neighbours, lines from the size of the scene")
      ->default_str("auto")
      ->type_name("WIDTH|auto");
  command
      .add_option("--labels", choice.options.labels.file,
                  "Texts in the scene, as letters that every camera and display sees: a table of x, y, z, text, and "
                  "perhaps size, color, nx, ny, nz, in the units of the scene before it is fitted")
      ->type_name("FILE.csv");
  command
      .add_option_function<std::string>(
          "--label-facing",
          [&choice](const std::string& direction) {
            choice.options.labels.facing = directionFromText(direction, "--label-facing");
          },
          "From where labels are read that have no nx, ny, nz: a direction")
      ->default_str("0,0,1")
      ->type_name("X,Y,Z");
  command
      .add_option("--iso", choice.options.iso,
                  "Of a volume: take the surface where it has this value, a mesh, in place of the volume")
      ->check(numberCheck(-1e30, 1e30))
      ->type_name("VALUE");
  command
      .add_option("--transfer", choice.options.transfer,
                  "Of a volume: the transfer function, which says what its values look like: a preset or a file; by "
                  "default one that fits the volume")
      ->type_name("NAME|FILE.json");
  command
      .add_option("--series", choice.options.series,
                  "Of a folder of DICOM files with several series: the one of this number or UID")
      ->type_name("NUMBER|UID");
}

}  // namespace

void addSceneOptions(CLI::App& command, SceneChoice& choice, const CommandContext& context) {
  command.add_option("SCENE", choice.source, kSceneHelp)->required();
  addReadingOptions(command, choice, context);
}

void addSceneOption(CLI::App& command, SceneChoice& choice, const CommandContext& context) {
  command.add_option("--scene", choice.source, kSceneHelp)->type_name("SCENE");
  addReadingOptions(command, choice, context);
}

void addMotionOptions(CLI::App& command, SceneChoice& choice) {
  MotionOptions& motion = choice.options.motion;
  command
      .add_option("--time", motion.seconds,
                  "Of a scene that moves: this moment of its motion. Without it a file is as it stands at rest")
      ->check(numberCheck(0, 1e9))
      ->type_name("SECONDS");
  command
      .add_option("--animation", motion.animation,
                  "Which animation of a file: its name, or its number from 1 on; by default the first")
      ->type_name("NAME|NUMBER");
  command.add_option("--rate", motion.meshesPerSecond, "Meshes a second of a folder of numbered meshes; 24 by default")
      ->check(numberCheck(1e-3, 1e4))
      ->type_name("HERTZ");
  command
      .add_option_function<std::string>(
          "--between",
          [&motion](const std::string& name) {
            motion.between = name == "linear" ? BetweenMeshes::kLinear : BetweenMeshes::kHold;
          },
          "Between two meshes of a folder: the earlier one, or, where their triangles are the same, a mesh whose "
          "vertices are on the way from one to the other")
      ->check(CLI::IsMember({"hold", "linear"}))
      ->default_str("hold")
      ->type_name("NAME");
}

void addCameraOption(CLI::App& command, std::string& camera) {
  command.add_option("--camera", camera, kCameraHelp + listOf(cameraNames()))->type_name(kCameraType);
}

void addConstructorOption(CLI::App& command, std::string& camera) {
  command.add_option("--camera", camera, kCameraHelp + listOf(cameraConstructors()))
      ->type_name(kConstructorType)
      ->required();
}

void addAnyCameraOption(CLI::App& command, std::string& camera) {
  command.add_option("--camera", camera, kCameraHelp + listOf(cameraNames()) + listOf(cameraConstructors()))
      ->type_name(kCameraType);
}

void addSizeOption(CLI::App& command, std::string& size) {
  command.add_option("--size", size, "Size of the image in pixels")->type_name("WIDTHxHEIGHT");
}

void addCameraSizeOption(CLI::App& command, std::string& size, const ImageSize& otherwise) {
  command
      .add_option("--size", size,
                  fmt::format("Size of the image in pixels; where not given that of the camera's file, or {}x{}",
                              otherwise.width, otherwise.height))
      ->type_name("WIDTHxHEIGHT");
}

ImageSize cameraImageSize(const std::string& camera, const std::string& size, const ImageSize& otherwise) {
  if (!size.empty()) {
    return imageSizeFromText(size, "--size");
  }
  if (namesRayMap(camera)) {
    const glm::ivec2 ofMap = readRayMapHeader(camera).size;
    return {ofMap.x, ofMap.y};
  }
  const std::optional<glm::ivec2> ofFile = sizeInFile(camera);
  return ofFile ? ImageSize{ofFile->x, ofFile->y} : otherwise;
}

void addMetreOption(CLI::App& command, std::optional<double>& metre) {
  command
      .add_option("--metre", metre,
                  "How many units of the scene a metre has; by default 1 where its longer level side has 2.5 to 20,000 "
                  "units, else that side is taken to be 20 metres")
      ->check(numberCheck(1e-6, 1e6))
      ->type_name("UNITS");
}

void addViewOption(CLI::App& command, std::string& path) {
  command.add_option("--view", path, "Reference view; by default from (0, 0, 10) to the origin")
      ->type_name("FILE.json");
}

View readViewOption(const std::string& path) {
  return path.empty() ? View{} : readView(path);
}

View cameraView(const std::string& camera, const std::string& path) {
  if (!namesRayMap(camera)) {
    return readViewOption(path);
  }
  const RayMapNotes notes = readRayMapHeader(camera).notes;
  if (path.empty()) {
    return notes.view.value_or(View{});
  }
  if (notes.frame == RayFrame::kWorld) {
    throw InputError("the rays of " + camera + " stand in the world already", "--view",
                     "leave it out; maps whose \"frame\" is \"view\" are placed at one (docs/ray_maps.md)");
  }
  return readView(path);
}

}  // namespace ocelli
